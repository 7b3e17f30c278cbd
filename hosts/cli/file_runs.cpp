#include "file_runs.h"

#include "depfile.h"

#include <foredraw/io/scene_file.h>
#include <foredraw/page/heat_maps.h>
#include <foredraw/page/page.h>

#include <utility>

namespace foredraw::cli {

namespace {

namespace fs = std::filesystem;

Exit exit_of(const Job& job) {
  switch (job.status()) {
    case JobStatus::done: return done;
    case JobStatus::mistake: return users_mistake;
    case JobStatus::unreadable: return exit_for_file(job.diagnostics());
    case JobStatus::cancelled: return interrupted;
    case JobStatus::in_part:
    case JobStatus::unwritable: break;
  }
  return something_failed;
}

FileRun run_of(Job& job) {
  FileRun run;
  run.exit = exit_of(job);
  run.is_lost = job.is_lost();
  run.report = std::move(job.report());
  run.json = job.report_json();
  run.text = job.report_text();
  run.from_cache = job.is_recalled();
  run.read = job.files_read();
  run.sought = job.files_sought();
  return run;
}

void add(const Diagnostics& diagnostics, Report& report) {
  for (const Diagnostic& one : diagnostics.all()) report.diagnostics.push_back(one);
}

/// The run as one of which nothing is left.
FileRun lost(FileRun run, Exit exit, const Diagnostics& why) {
  Report report;
  report.command = run.report.command;
  report.input = run.report.input;
  report.diagnostics = std::move(run.report.diagnostics);
  add(why, report);
  run.report = std::move(report);
  run.json.clear();
  run.exit = exit;
  run.is_lost = true;
  return run;
}

/// Reads, plans and works, as far as it gets.
bool is_made(Job& job, const FileJob& with, const std::string& input) {
  const auto has_views = [&] {
    Diagnostics why;
    const PictureArguments& pictures = with.pictures;
    return pictures.heat_maps.empty() || are_views(pictures.heat_map_view, job.overdraw_options(), why) ||
           job.refuse(why);
  };
  return with_memory(input, "read it", [&] { return job.read(); }) &&
         with_memory(input, "plan for it", [&] { return job.plan(with.pipeline) && has_views(); }) &&
         with_memory(input, "work on it", [&] { return job.run(); });
}

/// Into the folder that was asked for, or, of several inputs, one of the input's own in it.
void write_heat_maps(Job& job, const FileJob& with, FileRun& run) {
  if (with.pictures.heat_maps.empty()) return;
  fs::path folder = with.pictures.heat_maps;
  if (!with.folder.empty()) folder /= fs::path(run.report.input.path).lexically_relative(with.folder);
  const auto files = heat_maps(job.input(), run.report.optimized ? &job.scene() : nullptr, job.overdraw_options(),
                               with.pictures.heat_map_view, folder, with.setup.executor, job.analyses());
  Diagnostics diagnostics;
  if (!files.empty() && !(make_folder(folder, diagnostics) && write_files(files, diagnostics))) {
    run.exit = something_failed;
  }
  add(diagnostics, run.report);
}

/// One pipeline beside the input.
std::string page_of(Job& job, const FileJob& with) {
  const Comparison comparison{job.report().input, {{with.pipeline_name, job.report()}}, {}};
  const std::optional<Scene> after = job.scene();
  const Display shown = display(job.input(), {&after, 1}, 0, with.pipeline.subjects.subject);
  return page({&comparison, 1}, {&shown, 1}, program_name());
}

/// The files of the outputs and, where the input is one file, its report, rules and page: all of them or none.
bool write(const FileJob& with, const FileRun& run, const std::vector<JobOutput>& outputs,
           std::vector<std::vector<OutputFile>> files, const std::string& page, Diagnostics& diagnostics) {
  std::vector<std::byte> standard;
  for (auto& of_one : files) {
    if (!of_one.empty() && of_one.front().path == "-") standard = std::move(std::exchange(of_one, {}).front().bytes);
  }
  if (with.folder.empty()) {
    std::vector<OutputFile> texts;
    if (!with.texts.report.empty()) {
      texts.push_back({with.texts.report, {}, [&](const OutputFile::Put& put) {
                         run.json.empty() ? write_json(run.report, put) : put(run.json);
                       }});
    }
    if (!with.texts.html.empty()) texts.push_back(text_file(with.texts.html, page));
    if (!with.texts.depfile.empty()) texts.push_back(text_file(with.texts.depfile, rules_of(with, run, outputs)));
    files.push_back(std::move(texts));
  }
  std::erase_if(files, [](const auto& of_one) { return of_one.empty(); });
  return (files.empty() || write_scenes(std::move(files), diagnostics)) &&
         (standard.empty() || write_standard_output(standard, diagnostics));
}

}  // namespace

std::string rules_of(const FileJob& with, const FileRun& run, const std::vector<JobOutput>& outputs) {
  DependencyRule rule;
  for (const JobOutput& output : outputs) rule.outputs.emplace_back(output.path);
  rule.inputs = {run.report.input.path};
  rule.inputs.insert(rule.inputs.end(), run.read.begin(), run.read.end());
  rule.inputs.insert(rule.inputs.end(), with.pipeline_files.begin(), with.pipeline_files.end());
  for (const FileRead& lent : with.setup.input.files ? with.setup.input.files->all() : std::vector<FileRead>()) {
    if (lent.found == FileRead::Found::content) rule.inputs.push_back(lent.path);
  }
  return rule_text(rule);
}

FileRun optimize_file(const FileJob& with, const std::string& input, const std::vector<JobOutput>& outputs) {
  Job job(with.setup, JobKind::optimize, input);
  const bool is_there = job.recall(outputs) || is_made(job, with, input);
  return with_memory(outputs.empty() ? input : outputs.front().path, "write it", [&] {
    if (!is_there || !(job.is_recalled() || job.encode(outputs))) return run_of(job);
    const std::string page = with.texts.html.empty() ? "" : page_of(job, with);
    FileRun run = run_of(job);
    if (with.is_cancelled()) return lost(std::move(run), interrupted, {});
    Diagnostics diagnostics;
    if (!write(with, run, outputs, std::move(job.files()), page, diagnostics)) {
      return lost(std::move(run), something_failed, diagnostics);
    }
    add(diagnostics, run.report);
    if (run.from_cache) return run;
    write_heat_maps(job, with, run);
    leave_out_pictures(run.report);  // a folder's reports are kept to the end
    if (with.keeps_scenes) run.scene = std::move(job.scene());
    return run;
  });
}

FileRun measure_file(const FileJob& with, const std::string& input) {
  Job job(with.setup, JobKind::measure, input);
  if (!is_made(job, with, input)) return run_of(job);
  FileRun run = run_of(job);
  write_heat_maps(job, with, run);
  leave_out_pictures(run.report);
  return run;
}

}  // namespace foredraw::cli

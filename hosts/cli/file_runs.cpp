#include "file_runs.h"

#include "depfile.h"
#include "result_cache.h"

#include <foredraw/page/page.h>

#include <foredraw/io/image/images.h>
#include <foredraw/io/side_files.h>
#include <foredraw/page/heat_maps.h>
#include <foredraw/report/remap.h>

#include <numeric>

namespace foredraw::cli {

namespace {

namespace fs = std::filesystem;
using Worker = std::function<Result(const Plan&, Scene, const Surroundings&)>;

/// How the plan's first evaluator of overdraw looks, or as all do by default.
OverdrawOptions looks_of(const Plan& plan) {
  OptionTable<OverdrawOptions> table;
  add_view_rows(table);
  add_pose_rows(table);
  add_faces_row(table);
  add_subject_row(table, &OverdrawOptions::subject);
  for (const PlannedStage& measure : plan.measures) {
    if (measure.plugin->overdraw_service) return table.read(measure.settings);
  }
  return {};
}

/// Into the folder that was asked for, or, of several inputs, one of the input's own in it.
bool write_heat_maps(const FileJob& job, const std::string& input, const Plan& plan, const Scene& before,
                     const Scene* after, Analyses& analyses, Diagnostics& diagnostics) {
  fs::path folder = job.arguments.heat_maps;
  if (is_folder(job.arguments.inputs[0])) folder /= fs::path(input).lexically_relative(job.arguments.inputs[0]);
  const auto files =
      heat_maps(before, after, looks_of(plan), job.arguments.heat_map_view, folder, job.executor, analyses);
  return files.empty() || (make_folder(folder, diagnostics) && write_files(files, diagnostics));
}

/// Reads, plans and works; `files` is told of what is read, unless it is null; `written` puts the result somewhere,
/// beside what the scene was where that is shown, and may fail.
FileRun run_file(const FileJob& job, const std::string& command, const std::string& input,
                 const std::shared_ptr<FilesRead>& files, const Worker& work,
                 const std::function<bool(const Scene&, Result&, Diagnostics&)>& written) {
  FileRun run;
  Diagnostics diagnostics;
  const auto lost = [&](Exit exit) {
    if (job.is_cancelled()) exit = interrupted;
    run.report.command = command;
    run.report.input.path = input;
    run.report.diagnostics = diagnostics.all();
    run.exit = exit;
    run.is_lost = true;
    return run;
  };
  SceneInput how = input_of(job.arguments, job.registry);
  how.files = files;
  if (job.is_cancelled()) return lost(interrupted);
  auto file = with_memory(input, "read it", [&] { return read_scene(input, diagnostics, how); });
  if (job.is_cancelled()) return lost(interrupted);
  if (!file) return lost(exit_for_file(diagnostics));
  const auto plan = with_memory(input, "plan for it", [&] {
    return foredraw::plan(job.pipeline, job.registry, file->scene, diagnostics, &job.lender);
  });
  if (!plan) return lost(users_mistake);
  const bool draws = !job.arguments.heat_maps.empty();
  if (draws && !are_views(job.arguments.heat_map_view, looks_of(*plan), diagnostics)) return lost(users_mistake);

  const Scene before = draws || !job.arguments.html.empty() ? file->scene : Scene();
  Analyses analyses(image_decoder(input, job.arguments.root, files));
  Result result = with_memory(input, "work on it", [&] {
    return work(*plan, std::move(file->scene),
                {job.executor, analyses, job.arguments.cancel(), job.progress});
  });
  if (job.is_cancelled()) return lost(interrupted);  // its stages stopped anywhere
  result.report.command = command;
  result.report.input = {input, file->bytes, to_text(file->stamp)};
  for (const Diagnostic& diagnostic : result.report.diagnostics) diagnostics.add(diagnostic);
  result.report.diagnostics = diagnostics.all();
  if (!draws) analyses.clear();  // nobody asks them any more
  if (!written(before, result, diagnostics)) return lost(something_failed);
  if (draws) {
    const Scene* after = result.report.optimized ? &result.scene : nullptr;
    if (!write_heat_maps(job, input, *plan, before, after, analyses, diagnostics)) result.failed = true;
  }
  run.report = std::move(result.report);
  leave_out_pictures(run.report);  // a folder's reports are kept to the end
  run.report.diagnostics = diagnostics.all();
  run.exit = result.failed ? something_failed : done;
  if (job.keeps_scenes) run.scene = std::move(result.scene);
  return run;
}

std::vector<fs::path> contents_read(const std::vector<FileRead>& files) {
  std::vector<fs::path> paths;
  for (const FileRead& file : files) {
    if (file.found == FileRead::Found::content) paths.push_back(file.path);
  }
  return paths;
}

std::vector<fs::path> files_sought(const std::vector<FileRead>& files) {
  std::vector<fs::path> paths;
  for (const FileRead& file : files) {
    if (file.found != FileRead::Found::content) paths.push_back(file.path);
  }
  return paths;
}

/// One pipeline beside the input.
std::string page_of(const Scene& before, const std::optional<Scene>& after, const Report& report, const FileJob& job) {
  const std::string name = job.arguments.pipelines.empty() ? "@default" : job.arguments.pipelines.front();
  const Comparison comparison{report.input, {{name, report}}, {}};
  const Display shown = display(before, {&after, 1}, 0, job.pipeline.subjects.subject);
  return page({&comparison, 1}, {&shown, 1}, program_name());
}

std::uint64_t bytes_of(std::span<const OutputFile> files) {
  return std::accumulate(files.begin(), files.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const OutputFile& file) { return sum + file.bytes.size(); });
}

Compression compression_of(const std::string& word) {
  if (word == "none") return Compression::none;
  if (word == "ext-meshopt") return Compression::ext;
  if (word == "draco") return Compression::draco;
  if (word == "draco-edgebreaker") return Compression::draco_edgebreaker;
  return word == "khr-meshopt" ? Compression::khr : Compression::keep;
}

/// The command line's word, else the pipeline's.
const std::string& word_of(const std::string& typed, const std::string& of_pipeline) {
  return typed.empty() ? of_pipeline : typed;
}

GltfOutput output_of(const Arguments& arguments, const OutputChoice& choice, const ProductRows& rows) {
  const bool has_nodes = word_of(arguments.levels, choice.levels) == "msft-lod";
  return {.compression = compression_of(word_of(arguments.compression, choice.compression)),
          .turns_corners = word_of(arguments.corners, choice.corners) == "turn",
          .levels = has_nodes ? LevelsAs::lod_nodes : LevelsAs::extension,
          .products = rows};
}

Scene without_products(Scene scene, const ProductRows& rows) {
  for (const auto& row : rows) {
    if (scene.products.has(row->card().name)) row->leave_out(scene);
  }
  return scene;
}

}  // namespace

std::string rules_of(const FileJob& job, const FileRun& run, const std::vector<Output>& outputs) {
  DependencyRule rule;
  for (const Output& output : outputs) rule.outputs.emplace_back(output.path);
  rule.inputs = {run.report.input.path};
  rule.inputs.insert(rule.inputs.end(), run.read.begin(), run.read.end());
  rule.inputs.insert(rule.inputs.end(), job.pipeline_files.begin(), job.pipeline_files.end());
  if (job.lent) {
    const auto lent = contents_read(job.lent->all());
    rule.inputs.insert(rule.inputs.end(), lent.begin(), lent.end());
  }
  return rule_text(rule);
}

bool write_with_texts(const FileJob& job, const FileRun& run, const std::vector<Output>& outputs,
                      std::vector<std::vector<OutputFile>> files, const std::string& page, Diagnostics& diagnostics) {
  const Arguments& arguments = job.arguments;
  if (!is_folder(arguments.inputs[0])) {
    std::vector<OutputFile> texts;
    if (!arguments.report.empty()) {
      texts.push_back({arguments.report, {}, [&](const OutputFile::Put& put) {
                         run.json.empty() ? write_json(run.report, put) : put(run.json);
                       }});
    }
    if (!arguments.html.empty()) texts.push_back(text_file(arguments.html, page));
    if (!arguments.depfile.empty()) texts.push_back(text_file(arguments.depfile, rules_of(job, run, outputs)));
    files.push_back(std::move(texts));
  }
  std::erase_if(files, [](const auto& of_one) { return of_one.empty(); });
  return files.empty() || write_scenes(std::move(files), diagnostics);
}

FileRun optimize_file(const FileJob& job, const std::string& input, const std::vector<Output>& outputs) {
  if (job.cache != nullptr) {
    if (auto run = job.cache->recalled(job, input, outputs)) return std::move(*run);
  }
  const Arguments& arguments = job.arguments;
  const auto read = job.lent ? std::make_shared<FilesRead>() : nullptr;
  std::string json;
  // The scene, the report and whatever else: all of it, or none and an explanation.
  const auto write = [&](const Scene& before, Result& result, Diagnostics& diagnostics) {
    Report& report = result.report;
    std::vector<std::vector<OutputFile>> files;
    std::vector<std::byte> standard;
    const ProductRows rows = job.registry.products();
    const GltfOutput as = output_of(arguments, job.pipeline.output, rows);
    const bool is_bare = arguments.products == "none" && !result.scene.products.empty();
    const std::optional<Scene> bare = is_bare ? std::optional(without_products(result.scene, rows)) : std::nullopt;
    const Scene& scene = bare ? *bare : result.scene;
    for (const Output& output : outputs) {
      auto of_one = output.row           ? encode_side_file(result.scene, *output.row, output.path, diagnostics)
                    : output.level       ? encode_level(scene, *output.level, output.path, diagnostics, as)
                    : !output.is_scene() ? std::vector{text_file(output.path, remap_json(result.scene))}
                                         : encode_scene(scene, output.path, diagnostics, as);
      if (!of_one) return false;
      if (report.output.path.empty() && output.is_scene()) report.output = {output.path, bytes_of(*of_one)};
      if (output.path == "-") {
        standard = std::move(of_one->front().bytes);
      } else {
        files.push_back(std::move(*of_one));
      }
    }
    report.diagnostics = diagnostics.all();
    if (job.cache != nullptr && !result.failed) {
      json = to_json(report);
      job.cache->keep(input, outputs, files, {read->all(), job.lent->all()}, scene, report, json);
    }
    FileRun run;
    run.report = std::move(report);
    if (read) run.read = contents_read(read->all());
    const std::string page = arguments.html.empty() ? "" : page_of(before, result.scene, run.report, job);
    if (job.is_cancelled()) return false;
    const bool is_written = write_with_texts(job, run, outputs, std::move(files), page, diagnostics) &&
                            (standard.empty() || write_standard_output(standard, diagnostics));
    report = std::move(run.report);
    return is_written;
  };
  FileRun run = run_file(job, "optimize", input, read, foredraw::optimize,
                         [&](const Scene& before, Result& result, Diagnostics& diagnostics) {
                           return with_memory(outputs.empty() ? input : outputs.front().path, "write it",
                                              [&] { return write(before, result, diagnostics); });
                         });
  if (read) {
    run.read = contents_read(read->all());
    run.sought = files_sought(read->all());
  }
  if (!run.is_lost) run.json = std::move(json);
  return run;
}

FileRun measure_file(const FileJob& job, const std::string& input) {
  return run_file(job, "measure", input, nullptr, foredraw::measure,
                  [](const Scene&, Result&, Diagnostics&) { return true; });
}

}  // namespace foredraw::cli

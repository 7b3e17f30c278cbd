// The commands that read a scene and run a pipeline on it.

#include "file_runs.h"
#include "scene_folder.h"
#include "text_outputs.h"

#include <foredraw/io/file_lender.h>
#include <foredraw/io/sprite/sprite_files.h>
#include <foredraw/job/pipelines.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw::cli {

namespace {

/// Record and scene would stand in each other's way.
bool outputs_clash(const OptimizeArguments& arguments, const std::vector<JobOutput>& outputs,
                   Diagnostics& diagnostics) {
  if (arguments.json && std::ranges::find(arguments.outputs, "-") != arguments.outputs.end()) {
    diagnostics.error({}, "bad-arguments", "--json and -o - both want standard output",
                      "use --report FILE for the record");
  }
  return !have_files_of_their_own(files_read(arguments, arguments), outputs, arguments, diagnostics);
}

/// Whether the options for many files and many runs can be used with the others.
bool batch_options_fit(const OptimizeArguments& arguments, Diagnostics& diagnostics) {
  if (arguments.shard && !is_folder(arguments.inputs[0])) {
    diagnostics.error({.file = arguments.inputs[0]}, "bad-arguments", "is no folder, of which --shard takes a part",
                      "leave --shard out");
  }
  if (!arguments.baseline.empty() && !is_folder(arguments.inputs[0])) {
    diagnostics.error({.file = arguments.inputs[0]}, "bad-arguments", "is no folder, of whose files --baseline tells",
                      "use foredraw compare --baseline");
  }
  const bool is_standard =
      arguments.inputs[0] == "-" || std::ranges::find(arguments.outputs, "-") != arguments.outputs.end();
  const auto refuse_with = [&](const char* option, const char* what) {
    diagnostics.error({}, "bad-arguments", std::string(option) + " cannot be used with " + what,
                      std::string("leave one of them out"));
  };
  if (!arguments.cache.empty() && is_standard) refuse_with("--cache", "standard input or output");
  if (!arguments.depfile.empty() && is_standard) refuse_with("--depfile", "standard input or output");
  if (!arguments.cache.empty() && !arguments.html.empty()) refuse_with("--cache", "--html, whose page is of a run");
  if (!arguments.cache.empty() && !arguments.heat_maps.empty()) refuse_with("--cache", "--heatmap");
  return !diagnostics.has_errors();
}

}  // namespace

Exit optimize(const OptimizeArguments& arguments, const Registry& registry) {
  Diagnostics diagnostics;
  const std::string& input = arguments.inputs[0];
  const auto pipeline = one_pipeline(arguments, registry, diagnostics);
  if (!pipeline) return refuse(diagnostics);
  const std::vector<JobOutput> outputs = outputs_of(arguments.outputs, input, registry.products(), diagnostics);
  if (outputs_clash(arguments, outputs, diagnostics)) return refuse(diagnostics);
  if (!batch_options_fit(arguments, diagnostics)) return refuse(diagnostics);
  const Executor executor(arguments.threads);
  SceneInput how = input_of(arguments, arguments, registry);
  if (!arguments.cache.empty() || !arguments.depfile.empty()) how.files = std::make_shared<FilesRead>();
  const FileLender lender(how);
  FileJob job{*pipeline, setup_of(arguments, registry, executor, lender, how)};
  job.setup.keeps_input = !arguments.heat_maps.empty() || !arguments.html.empty();
  job.folder = is_folder(input) ? input : "";
  job.pipeline_name = arguments.pipelines.empty() ? "@default" : arguments.pipelines.front();
  job.texts = arguments;
  job.pictures = arguments;
  if (!arguments.depfile.empty()) job.pipeline_files = files_of(arguments, *pipeline, registry);
  const auto cache = cache_of(arguments.cache, input, *pipeline, registry, how, diagnostics);
  if (diagnostics.has_errors()) return refuse(diagnostics);
  job.setup.cache = cache.get();
  if (!job.folder.empty()) return optimize_folder(job, arguments);
  std::vector<std::string> written = {arguments.report, arguments.html, arguments.depfile};
  for (const JobOutput& output : outputs) written.push_back(output.path);
  if (!can_write(outputs, input, diagnostics)) return refuse(diagnostics);
  if (!have_folders(written, diagnostics)) return refuse_file(diagnostics);
  if (is_sprite_input(input) && !works_on_sprites(*pipeline, registry)) {
    diagnostics.warning({.file = input}, "no-sprites",
                        "these are sprites, and no stage of the pipeline works on sprites", "try -p @sprites");
    tell(diagnostics);
  }

  job.setup.progress = progress_line();
  const FileRun run = optimize_file(job, input, outputs);
  end_progress();
  if (run.exit == interrupted) return tell_interrupted("nothing was written");
  tell(run.from_cache && !run.is_lost ? stored_report(run.json, registry).diagnostics : run.report.diagnostics);
  if (run.is_lost) return run.exit;
  fmt::print(stderr, "{}{}", run.text.empty() ? to_text(run.report) : run.text,
             run.from_cache ? "from the cache: no stage ran\n" : "");
  return arguments.json ? std::max(run.exit, print(run.json.empty() ? to_json(run.report) : run.json)) : run.exit;
}

Exit plan(const PlanArguments& arguments, const Registry& registry) {
  Diagnostics diagnostics;
  const auto pipeline = one_pipeline(arguments, registry, diagnostics);
  if (!pipeline) return refuse(diagnostics);
  const std::string& input = arguments.inputs[0];
  const Executor executor(arguments.threads);
  const SceneInput how = input_of(arguments, arguments, registry);
  const FileLender lender(how);
  const JobSetup setup = setup_of(arguments, registry, executor, lender, how);
  Job job(setup, JobKind::optimize, input);
  if (!with_memory(input, "read it", [&] { return job.read(); })) return refuse_file(job.diagnostics());
  if (!with_memory(input, "plan for it", [&] { return job.plan(*pipeline); })) return refuse(job.diagnostics());
  tell(job.diagnostics());
  return print(arguments.json ? to_json(job.plan(), job.scene()) : to_text(job.plan(), job.scene()));
}

Exit measure(const MeasureArguments& arguments, const Registry& registry) {
  Diagnostics diagnostics;
  const auto pipelines = pipelines_for(arguments, registry, {""}, diagnostics);
  if (!pipelines) return refuse(diagnostics);
  const Executor executor(arguments.threads);
  const SceneInput how = input_of(arguments, arguments, registry);
  const FileLender lender(how);
  const std::string& input = arguments.inputs[0];
  FileJob job{pipelines->front().pipeline, setup_of(arguments, registry, executor, lender, how)};
  job.setup.keeps_input = !arguments.heat_maps.empty();
  job.folder = is_folder(input) ? input : "";
  job.pictures = arguments;
  if (!job.folder.empty()) return measure_folder(job, arguments);

  job.setup.progress = progress_line();
  const FileRun run = measure_file(job, input);
  end_progress();
  if (run.exit == interrupted) return tell_interrupted();
  tell(run.report.diagnostics);
  if (run.is_lost) return run.exit;
  return std::max(run.exit, print(arguments.json ? to_json(run.report) : to_text(run.report)));
}

}  // namespace foredraw::cli

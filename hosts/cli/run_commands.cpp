// The commands that read a scene and run a pipeline on it.

#include "session.h"

#include <foredraw/report/comparison.h>
#include <foredraw/report/remap.h>

#include <fmt/format.h>

namespace foredraw::cli {

namespace {

constexpr const char* default_pipeline = "@default";

std::string first_pipeline(const Arguments& arguments) {
  return arguments.pipelines.empty() ? default_pipeline : arguments.pipelines.back();
}

Exit print(const std::string& text) {
  Diagnostics diagnostics;
  const bool printed = write_standard_output(std::as_bytes(std::span(text)), diagnostics);
  return printed ? done : refuse_file(diagnostics);
}

Result run_plan(const foredraw::Plan& plan, Scene scene, const Executor& executor, Analyses& analyses) {
  Result result = foredraw::run(plan, std::move(scene), {executor, analyses, nullptr, progress_line()});
  end_progress();
  return result;
}

/// The report, the remap tables and the scene, all or an explanation.
bool write_outputs(const Arguments& arguments, Result& result, Diagnostics& diagnostics) {
  const auto bytes = write_scene(result.scene, arguments.output, diagnostics);
  if (!bytes) return false;
  Report& report = result.report;
  report.output = {arguments.output, *bytes};
  for (const Diagnostic& diagnostic : diagnostics.all()) report.diagnostics.push_back(diagnostic);
  bool written = true;
  if (!arguments.report.empty()) written = write_text(arguments.report, to_json(report), diagnostics);
  if (!arguments.remap.empty()) written = write_text(arguments.remap, remap_json(result.scene), diagnostics) && written;
  return written;
}

}  // namespace

Exit optimize(const Arguments& arguments, const Registry& registry) {
  Diagnostics diagnostics;
  if (arguments.json && arguments.output == "-") {
    diagnostics.error({}, "bad-arguments", "--json and -o - both want standard output", "use --report FILE for the record");
    return refuse(diagnostics);
  }
  const auto pipeline = pipeline_for(arguments, first_pipeline(arguments), diagnostics);
  if (!can_write_scene(arguments.output, diagnostics) || !pipeline) return refuse(diagnostics);
  auto file = read_scene(arguments.inputs[0], diagnostics);
  if (!file) return refuse_file(diagnostics);
  const auto plan = foredraw::plan(*pipeline, registry, file->scene, diagnostics);
  if (!plan) return refuse(diagnostics);

  const Executor executor(arguments.threads);
  Analyses analyses;
  Result result = run_plan(*plan, std::move(file->scene), executor, analyses);
  result.report.command = "optimize";
  result.report.input = {arguments.inputs[0], file->bytes};
  tell(result.report.diagnostics);
  const bool written = write_outputs(arguments, result, diagnostics);
  tell(diagnostics);
  if (!written) return something_failed;
  fmt::print(stderr, "{}", to_text(result.report));
  if (arguments.json && print(to_json(result.report)) != done) return something_failed;
  return result.failed ? something_failed : done;
}

Exit plan(const Arguments& arguments, const Registry& registry) {
  Diagnostics diagnostics;
  const auto pipeline = pipeline_for(arguments, first_pipeline(arguments), diagnostics);
  if (!pipeline) return refuse(diagnostics);
  const auto file = read_scene(arguments.inputs[0], diagnostics);
  if (!file) return refuse_file(diagnostics);
  const auto plan = foredraw::plan(*pipeline, registry, file->scene, diagnostics);
  if (!plan) return refuse(diagnostics);
  tell(diagnostics);
  return print(arguments.json ? to_json(*plan, file->scene) : to_text(*plan, file->scene));
}

Exit measure(const Arguments& arguments, const Registry& registry) {
  Diagnostics diagnostics;
  const auto pipeline = pipeline_for(arguments, "", diagnostics);
  if (!pipeline) return refuse(diagnostics);
  auto file = read_scene(arguments.inputs[0], diagnostics);
  if (!file) return refuse_file(diagnostics);
  const auto plan = foredraw::plan(*pipeline, registry, file->scene, diagnostics);
  if (!plan) return refuse(diagnostics);

  const Executor executor(arguments.threads);
  Analyses analyses;
  Result result = run_plan(*plan, std::move(file->scene), executor, analyses);
  result.report.command = "measure";
  result.report.input = {arguments.inputs[0], file->bytes};
  tell(diagnostics);
  tell(result.report.diagnostics);
  const Exit printed = print(arguments.json ? to_json(result.report) : to_text(result.report));
  return result.failed ? something_failed : printed;
}

Exit compare(const Arguments& arguments, const Registry& registry) {
  Diagnostics diagnostics;
  std::vector<std::pair<std::string, Pipeline>> pipelines;
  for (const std::string& text : arguments.pipelines.empty() ? std::vector<std::string>{default_pipeline} : arguments.pipelines) {
    if (auto pipeline = pipeline_for(arguments, text, diagnostics)) pipelines.emplace_back(text, std::move(*pipeline));
  }
  if (diagnostics.has_errors()) return refuse(diagnostics);
  // Branches that were measured differently can not be compared.
  for (auto& [text, pipeline] : pipelines) pipeline.measure = pipelines.front().second.measure;

  const Executor executor(arguments.threads);
  Analyses analyses;
  std::vector<Comparison> comparisons;
  bool failed = false;
  for (const std::string& input : arguments.inputs) {
    const auto file = read_scene(input, diagnostics);
    if (!file) return refuse_file(diagnostics);
    Comparison comparison{{input, file->bytes}, {}};
    for (const auto& [text, pipeline] : pipelines) {
      const auto plan = foredraw::plan(pipeline, registry, file->scene, diagnostics);
      if (!plan) return refuse(diagnostics);
      Result result = run_plan(*plan, file->scene, executor, analyses);
      result.report.command = "compare";
      result.report.input = comparison.input;
      tell(result.report.diagnostics);
      failed = failed || result.failed;
      comparison.branches.push_back({text, std::move(result.report)});
    }
    comparisons.push_back(std::move(comparison));
    analyses.clear();
  }
  tell(diagnostics);
  if (!arguments.report.empty() && !write_text(arguments.report, to_json(comparisons), diagnostics)) {
    return refuse_file(diagnostics);
  }
  const Exit printed = print(arguments.json ? to_json(comparisons) : to_text(comparisons));
  return failed ? something_failed : printed;
}

}  // namespace foredraw::cli

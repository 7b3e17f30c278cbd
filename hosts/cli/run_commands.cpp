// The commands that read a scene and run a pipeline on it.

#include "session.h"

#include <foredraw/report/comparison.h>
#include <foredraw/report/remap.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw::cli {

namespace {

/// A scene read and a pipeline planned for it.
struct Job {
  SceneFile file;
  Plan plan;
};

/// The exit code, with all told, where there is no job.
std::variant<Job, Exit> job_for(const std::string& input, const Pipeline& pipeline, const Registry& registry) {
  Diagnostics diagnostics;
  auto file = with_memory(input, "read it", [&] { return read_scene(input, diagnostics); });
  if (!file) return refuse_file(diagnostics);
  auto plan = with_memory(input, "plan for it", [&] { return foredraw::plan(pipeline, registry, file->scene, diagnostics); });
  if (!plan) return refuse(diagnostics);
  tell(diagnostics);
  return Job{std::move(*file), std::move(*plan)};
}

std::optional<Pipeline> one_pipeline(const Arguments& arguments, Diagnostics& diagnostics) {
  if (arguments.pipelines.size() > 1) {
    diagnostics.error({}, "bad-arguments", "--pipeline is given more than once", "foredraw compare runs several");
    return std::nullopt;
  }
  const std::string text = arguments.pipelines.empty() ? "@default" : arguments.pipelines.front();
  auto pipelines = pipelines_for(arguments, {text}, diagnostics);
  return pipelines ? std::optional(std::move(pipelines->front())) : std::nullopt;
}

/// Reports and scene would stand in each other's way.
bool outputs_clash(const Arguments& arguments, Diagnostics& diagnostics) {
  if (arguments.json && arguments.output == "-") {
    diagnostics.error({}, "bad-arguments", "--json and -o - both want standard output", "use --report FILE for the record");
  }
  for (const std::string& text : {arguments.report, arguments.remap}) {
    if (text.empty()) continue;
    if (text == "-") diagnostics.error({}, "bad-arguments", "--report and --remap take the name of a file", "--json prints the record");
    if (text == arguments.output || (text == arguments.report && text == arguments.remap)) {
      diagnostics.error({.file = text}, "bad-arguments", "is to hold two outputs", "give each a file of its own");
      return true;
    }
  }
  return diagnostics.has_errors();
}

/// The scene, the report and the remap tables: all of them, or none and an explanation.
bool write_outputs(const Arguments& arguments, Result& result, Diagnostics& diagnostics) {
  const Compression compression = arguments.compression == "none" ? Compression::none : Compression::keep;
  auto files = encode_scene(result.scene, arguments.output, diagnostics, compression);
  if (!files) return false;
  Report& report = result.report;
  report.output = {arguments.output, files->front().bytes.size()};
  for (const Diagnostic& diagnostic : diagnostics.all()) report.diagnostics.push_back(diagnostic);
  if (!arguments.report.empty()) files->push_back(text_file(arguments.report, to_json(report)));
  if (!arguments.remap.empty()) files->push_back(text_file(arguments.remap, remap_json(result.scene)));
  if (arguments.output != "-") return write_scene(*files, diagnostics);
  return write_files(std::span(*files).subspan(1), diagnostics) &&
         write_standard_output(files->front().bytes, diagnostics);
}

}  // namespace

Exit optimize(const Arguments& arguments, const Registry& registry) {
  Diagnostics diagnostics;
  const auto pipeline = one_pipeline(arguments, diagnostics);
  if (!pipeline || outputs_clash(arguments, diagnostics) || !can_write_scene(arguments.output, arguments.inputs[0], diagnostics)) {
    return refuse(diagnostics);
  }
  auto job = job_for(arguments.inputs[0], *pipeline, registry);
  if (const Exit* exit = std::get_if<Exit>(&job)) return *exit;
  auto& [file, plan] = std::get<Job>(job);

  const Executor executor(arguments.threads);
  Analyses analyses;
  Result result = with_memory(arguments.inputs[0], "work on it", [&, &file = file, &plan = plan] {
    return foredraw::optimize(plan, std::move(file.scene), {executor, analyses, nullptr, progress_line()});
  });
  end_progress();
  result.report.command = "optimize";
  result.report.input = {arguments.inputs[0], file.bytes};
  tell(result.report.diagnostics);
  const bool written =
      with_memory(arguments.output, "write it", [&] { return write_outputs(arguments, result, diagnostics); });
  tell(diagnostics);
  if (!written) return something_failed;
  fmt::print(stderr, "{}", to_text(result.report));
  if (arguments.json && print(to_json(result.report)) != done) return something_failed;
  return result.failed ? something_failed : done;
}

Exit plan(const Arguments& arguments, const Registry& registry) {
  Diagnostics diagnostics;
  const auto pipeline = one_pipeline(arguments, diagnostics);
  if (!pipeline) return refuse(diagnostics);
  const auto job = job_for(arguments.inputs[0], *pipeline, registry);
  if (const Exit* exit = std::get_if<Exit>(&job)) return *exit;
  const auto& [file, plan] = std::get<Job>(job);
  return print(arguments.json ? to_json(plan, file.scene) : to_text(plan, file.scene));
}

Exit measure(const Arguments& arguments, const Registry& registry) {
  Diagnostics diagnostics;
  const auto pipelines = pipelines_for(arguments, {""}, diagnostics);
  if (!pipelines) return refuse(diagnostics);
  auto job = job_for(arguments.inputs[0], pipelines->front(), registry);
  if (const Exit* exit = std::get_if<Exit>(&job)) return *exit;
  auto& [file, plan] = std::get<Job>(job);

  const Executor executor(arguments.threads);
  Analyses analyses;
  Result result = with_memory(arguments.inputs[0], "measure it", [&, &file = file, &plan = plan] {
    return foredraw::measure(plan, std::move(file.scene), {executor, analyses, nullptr, progress_line()});
  });
  end_progress();
  result.report.command = "measure";
  result.report.input = {arguments.inputs[0], file.bytes};
  tell(result.report.diagnostics);
  const Exit printed = print(arguments.json ? to_json(result.report) : to_text(result.report));
  return result.failed ? something_failed : printed;
}

Exit compare(const Arguments& arguments, const Registry& registry) {
  Diagnostics diagnostics;
  const std::vector<std::string> texts =
      arguments.pipelines.empty() ? std::vector<std::string>{"@default"} : arguments.pipelines;
  const auto pipelines = pipelines_for(arguments, texts, diagnostics);
  if (!pipelines) return refuse(diagnostics);

  const Executor executor(arguments.threads);
  std::vector<Comparison> comparisons;
  Exit worst = done;
  for (const std::string& input : arguments.inputs) {
    Comparison comparison{{input, 0}, {}};
    Analyses analyses;  // shared by the branches, gone with the file
    for (std::size_t i = 0; i < texts.size(); ++i) {
      auto job = job_for(input, (*pipelines)[i], registry);
      if (const Exit* exit = std::get_if<Exit>(&job)) {
        worst = std::max(worst, *exit);
        break;
      }
      auto& [file, plan] = std::get<Job>(job);
      comparison.input.bytes = file.bytes;
      Result result = with_memory(input, "work on it", [&, &file = file, &plan = plan] {
        return foredraw::optimize(plan, std::move(file.scene), {executor, analyses, nullptr, progress_line()});
      });
      end_progress();
      result.report.command = "compare";
      result.report.input = comparison.input;
      tell(result.report.diagnostics);
      if (result.failed) worst = something_failed;
      comparison.branches.push_back({texts[i], std::move(result.report)});
    }
    if (comparison.branches.size() == texts.size()) comparisons.push_back(std::move(comparison));
  }
  if (comparisons.empty()) return worst;
  if (!arguments.report.empty()) {
    const OutputFile report = text_file(arguments.report, to_json(comparisons));
    if (!write_files(std::span(&report, 1), diagnostics)) return refuse_file(diagnostics);
  }
  return std::max(worst, print(arguments.json ? to_json(comparisons) : to_text(comparisons)));
}

}  // namespace foredraw::cli

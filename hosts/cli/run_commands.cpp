// The commands that read a scene and run a pipeline on it.

#include "file_runs.h"

#include <foredraw/io/images.h>
#include <foredraw/io/scene_folder.h>
#include <foredraw/report/comparison.h>

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
  auto plan =
      with_memory(input, "plan for it", [&] { return foredraw::plan(pipeline, registry, file->scene, diagnostics); });
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
    diagnostics.error({}, "bad-arguments", "--json and -o - both want standard output",
                      "use --report FILE for the record");
  }
  const auto same = [](const std::string& a, const std::string& b) {
    std::error_code error;
    return std::filesystem::weakly_canonical(a, error) == std::filesystem::weakly_canonical(b, error);
  };
  const std::string outputs[] = {arguments.report, arguments.remap, arguments.draw_orders};
  for (const std::string& text : outputs) {
    if (text.empty()) continue;
    if (same(text, arguments.inputs[0])) {
      diagnostics.error({.file = text}, "bad-arguments", "is the input", "give the output a file of its own");
      return true;
    }
    if (text == "-")
      diagnostics.error({}, "bad-arguments", "--report, --remap and --draw-orders take the name of a file",
                        "--json prints the record");
    const auto others =
        std::ranges::count_if(outputs, [&](const std::string& other) { return !other.empty() && same(text, other); });
    if (same(text, arguments.output) || others > 1) {
      diagnostics.error({.file = text}, "bad-arguments", "is to hold two outputs", "give each a file of its own");
      return true;
    }
  }
  return diagnostics.has_errors();
}

/// Whether the files can be put into their folders: who learns it after the work has lost it.
bool have_folders(std::initializer_list<std::string> files, Diagnostics& diagnostics) {
  for (const std::string& file : files) {
    const auto folder = std::filesystem::path(file).parent_path();
    if (folder.empty() || is_folder(folder.string())) continue;
    diagnostics.error({.file = file}, "no-such-folder", "can not be written: there is no folder '" + folder.string() + "'",
                      "make it, or name another one");
  }
  return !diagnostics.has_errors();
}

/// The inputs, folders among them replaced by the scenes that they hold.
std::optional<std::vector<std::string>> scenes_of(const std::vector<std::string>& inputs, Diagnostics& diagnostics) {
  std::vector<std::string> files;
  for (const std::string& input : inputs) {
    if (!is_folder(input)) {
      files.push_back(input);
      continue;
    }
    const auto scenes = scenes_below(input, {}, diagnostics);
    if (!scenes) return std::nullopt;
    for (const auto& scene : *scenes) files.push_back((input / scene).string());
  }
  return files;
}

}  // namespace

Exit optimize(const Arguments& arguments, const Registry& registry) {
  Diagnostics diagnostics;
  const std::string& input = arguments.inputs[0];
  const auto pipeline = one_pipeline(arguments, diagnostics);
  if (!pipeline || outputs_clash(arguments, diagnostics)) return refuse(diagnostics);
  if (!have_folders({arguments.report, arguments.remap, arguments.draw_orders}, diagnostics)) {
    return refuse_file(diagnostics);
  }
  const Executor executor(arguments.threads);
  if (is_folder(input)) return optimize_folder({arguments, *pipeline, registry, executor});
  if (!can_write_scene(arguments.output, input, diagnostics)) return refuse(diagnostics);
  if (!have_folders({arguments.output}, diagnostics)) return refuse_file(diagnostics);

  const FileRun run =
      optimize_file({arguments, *pipeline, registry, executor, progress_line()}, input, arguments.output);
  end_progress();
  tell(run.report.diagnostics);
  if (run.is_lost) return run.exit;
  fmt::print(stderr, "{}", to_text(run.report));
  return arguments.json ? std::max(run.exit, print(to_json(run.report))) : run.exit;
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
  const Executor executor(arguments.threads);
  const std::string& input = arguments.inputs[0];
  if (is_folder(input)) return measure_folder({arguments, pipelines->front(), registry, executor});

  const FileRun run = measure_file({arguments, pipelines->front(), registry, executor, progress_line()}, input);
  end_progress();
  tell(run.report.diagnostics);
  if (run.is_lost) return run.exit;
  return std::max(run.exit, print(arguments.json ? to_json(run.report) : to_text(run.report)));
}

Exit compare(const Arguments& arguments, const Registry& registry) {
  Diagnostics diagnostics;
  const std::vector<std::string> texts =
      arguments.pipelines.empty() ? std::vector<std::string>{"@default"} : arguments.pipelines;
  const auto pipelines = pipelines_for(arguments, texts, diagnostics);
  if (!pipelines) return refuse(diagnostics);

  const auto inputs = scenes_of(arguments.inputs, diagnostics);
  if (!inputs) return refuse(diagnostics);
  if (!have_folders({arguments.report}, diagnostics)) return refuse_file(diagnostics);

  const Executor executor(arguments.threads);
  std::vector<Comparison> comparisons;
  Exit worst = done;
  for (const std::string& input : *inputs) {
    Comparison comparison{{input, 0}, {}};
    Analyses analyses(image_decoder(input));  // shared by the branches, gone with the file
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

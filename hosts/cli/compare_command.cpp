// Several pipelines on the same scenes.

#include "file_runs.h"

#include <foredraw/io/images.h>
#include <foredraw/io/scene_folder.h>
#include <foredraw/report/bound.h>

#include <algorithm>

namespace foredraw::cli {

namespace {

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

/// Pipelines to be compared, with what they are called.
struct NamedPipelines {
  const std::vector<std::string>& names;
  const std::vector<Pipeline>& pipelines;
};

/// Every pipeline that can be planned for the file; `worst` tells of the others and of stages that failed.
std::optional<Comparison> compared(const std::string& input, const NamedPipelines& all, int rounds,
                                   const Registry& registry, const Executor& executor, Exit& worst) {
  Diagnostics diagnostics;
  const auto file = with_memory(input, "read it", [&] { return read_scene(input, diagnostics); });
  if (!file) {
    worst = std::max(worst, refuse_file(diagnostics));
    return std::nullopt;
  }
  tell(diagnostics);
  Comparison comparison{{input, file->bytes}, {}};
  std::vector<Plan> plans;
  for (std::size_t i = 0; i < all.pipelines.size(); ++i) {
    Diagnostics of_plan;
    auto plan = with_memory(input, "plan for it",
                            [&] { return foredraw::plan(all.pipelines[i], registry, file->scene, of_plan); });
    tell(of_plan);
    if (!plan) {
      worst = std::max(worst, users_mistake);
      continue;
    }
    plans.push_back(std::move(*plan));
    comparison.branches.push_back({all.names[i], {}});
  }
  if (plans.empty()) return std::nullopt;

  Analyses analyses(image_decoder(input));
  std::vector<Result> results = with_memory(input, "work on it", [&] {
    return foredraw::compare(plans, file->scene, rounds, {executor, analyses, nullptr, progress_line()});
  });
  end_progress();
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (results[i].failed) worst = something_failed;
    comparison.branches[i].report = std::move(results[i].report);
    comparison.branches[i].report.command = "compare";
    comparison.branches[i].report.input = comparison.input;
    tell(comparison.branches[i].report.diagnostics);
  }
  return comparison;
}

/// What figures are held to.
struct Budget {
  std::vector<Bound> bounds;
  std::optional<std::map<std::string, StoredFigures>> stored;
};

std::optional<Budget> budget_of(const Arguments& arguments, std::size_t pipelines, Diagnostics& diagnostics) {
  Budget budget;
  bool needs_baseline = false;
  for (const std::string& text : arguments.fail_if) {
    const auto bound = parse_bound(text, diagnostics);
    if (!bound) continue;
    needs_baseline = needs_baseline || bound->beside == Bound::Beside::baseline;
    budget.bounds.push_back(*bound);
  }
  if (arguments.baseline.empty()) {
    if (needs_baseline && pipelines < 2) {
      diagnostics.error({}, "bad-arguments", "--fail-if names a baseline, and there is none",
                        "give --baseline a stored report, or a pipeline before the one that is judged");
    }
  } else if (!needs_baseline) {
    diagnostics.error({}, "bad-arguments", "--baseline is given, but no --fail-if names it", "");
  } else if (const auto bytes = read_file(arguments.baseline, diagnostics)) {
    const std::string text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    budget.stored = read_stored_figures(text, arguments.baseline, diagnostics);
  }
  return diagnostics.has_errors() ? std::nullopt : std::optional(std::move(budget));
}

/// Tells of what is out of bounds.
Exit judged(const Budget& budget, std::span<const Comparison> comparisons) {
  Diagnostics diagnostics;
  judge(budget.bounds, comparisons, budget.stored ? &*budget.stored : nullptr, diagnostics);
  tell(diagnostics);
  if (!diagnostics.has_errors()) return done;
  const bool is_out =
      std::ranges::any_of(diagnostics.all(), [](const Diagnostic& d) { return d.code == "out-of-bounds"; });
  return is_out ? out_of_bounds : users_mistake;
}

}  // namespace

Exit compare(const Arguments& arguments, const Registry& registry) {
  Diagnostics diagnostics;
  const std::vector<std::string> names =
      arguments.pipelines.empty() ? std::vector<std::string>{"@default"} : arguments.pipelines;
  const auto pipelines = pipelines_for(arguments, names, diagnostics);
  if (!pipelines) return refuse(diagnostics);
  const auto inputs = scenes_of(arguments.inputs, diagnostics);
  if (!inputs) return refuse(diagnostics);
  const auto budget = budget_of(arguments, pipelines->size(), diagnostics);
  if (!budget) return refuse(diagnostics);
  if (!have_folders({arguments.report}, diagnostics)) return refuse_file(diagnostics);

  const Executor executor(arguments.threads);
  std::vector<Comparison> comparisons;
  Exit worst = done;
  for (const std::string& input : *inputs) {
    auto comparison = compared(input, {names, *pipelines}, arguments.repeat, registry, executor, worst);
    if (comparison) comparisons.push_back(std::move(*comparison));
  }
  if (comparisons.empty()) return worst;
  if (!arguments.report.empty()) {
    const OutputFile report = text_file(arguments.report, to_json(comparisons));
    if (!write_files(std::span(&report, 1), diagnostics)) return refuse_file(diagnostics);
  }
  worst = std::max(worst, print(arguments.json ? to_json(comparisons) : to_text(comparisons)));
  return std::max(worst, judged(*budget, comparisons));
}

}  // namespace foredraw::cli

// Several pipelines on the same scenes.

#include "file_runs.h"

#include <hosts/report/page.h>

#include <foredraw/io/images.h>
#include <foredraw/io/scene_folder.h>
#include <foredraw/pipeline/sweep.h>
#include <foredraw/report/bound.h>
#include <foredraw/report/fronts.h>

#include <fmt/format.h>

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

/// Pipelines to be compared, and how.
struct Contest {
  const std::vector<NamedPipeline>& pipelines;
  int rounds = 1;
  const std::vector<std::pair<std::string, std::string>>& fronts;
};

/// What is there of a file afterwards.
struct ComparedFile {
  Comparison comparison;
  Scene input;
  std::vector<std::optional<Scene>> scenes;  ///< [pipeline] nothing where it was lost
};

/// All pipelines on one file. Those that can not be planned for it are lost; `worst` tells of them and of stages that
/// failed.
std::optional<ComparedFile> compared(const std::string& input, const Contest& contest, const Registry& registry,
                                     const Executor& executor, Exit& worst) {
  Diagnostics diagnostics;
  const auto file = with_memory(input, "read it", [&] { return read_scene(input, diagnostics); });
  if (!file) {
    worst = std::max(worst, refuse_file(diagnostics));
    return std::nullopt;
  }
  tell(diagnostics);
  ComparedFile made{{{input, file->bytes}, {}, contest.fronts}, file->scene, {}};
  Comparison& comparison = made.comparison;
  std::vector<Plan> plans;
  std::vector<std::size_t> branches;  // [plan]
  for (const NamedPipeline& named : contest.pipelines) {
    Diagnostics of_plan;
    auto plan = with_memory(input, "plan for it",
                            [&] { return foredraw::plan(named.pipeline, registry, file->scene, of_plan); });
    tell(of_plan);
    comparison.branches.push_back({named.name, {}, !plan});
    if (plan) {
      branches.push_back(comparison.branches.size() - 1);
      plans.push_back(std::move(*plan));
    } else {
      comparison.branches.back().report.pipeline = print_file(named.pipeline);
      comparison.branches.back().report.diagnostics = of_plan.all();
      worst = std::max(worst, users_mistake);
    }
  }
  if (plans.empty()) return std::nullopt;

  Analyses analyses(image_decoder(input));
  std::vector<Result> results = with_memory(input, "work on it", [&] {
    return foredraw::compare(plans, file->scene, contest.rounds, {executor, analyses, nullptr, progress_line()});
  });
  end_progress();
  made.scenes.resize(comparison.branches.size());
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (results[i].failed) worst = something_failed;
    made.scenes[branches[i]] = std::move(results[i].scene);
    Report& report = comparison.branches[branches[i]].report;
    report = std::move(results[i].report);
    report.command = "compare";
    report.input = comparison.input;
    tell(report.diagnostics);
  }
  return made;
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

/// Every pipeline that takes part: those of the arguments, at every value of the sweeps.
std::optional<std::vector<NamedPipeline>> contestants(const Arguments& arguments, Diagnostics& diagnostics) {
  const std::vector<std::string> texts =
      arguments.pipelines.empty() ? std::vector<std::string>{"@default"} : arguments.pipelines;
  auto pipelines = pipelines_for(arguments, texts, diagnostics);
  std::vector<Sweep> sweeps;
  for (const std::string& text : arguments.sweeps) {
    if (auto sweep = parse_sweep(text, diagnostics)) sweeps.push_back(std::move(*sweep));
  }
  if (!pipelines || diagnostics.has_errors()) return std::nullopt;
  return swept(std::move(*pipelines), sweeps, diagnostics);
}

using Fronts = std::vector<std::pair<std::string, std::string>>;

std::optional<Fronts> fronts_in(const Arguments& arguments, Diagnostics& diagnostics) {
  Fronts fronts;
  for (const std::string& text : arguments.fronts) {
    if (auto front = parse_front(text, diagnostics)) fronts.push_back(std::move(*front));
  }
  return diagnostics.has_errors() ? std::nullopt : std::optional(std::move(fronts));
}

/// Tells of fronts that were asked for, and that nobody has the figures for.
Exit unknown_fronts(std::span<const Comparison> comparisons) {
  Diagnostics diagnostics;
  for (const Comparison& comparison : comparisons) {
    for (const std::string& figure : unknown_figures(comparison)) {
      diagnostics.error({.file = comparison.input.path}, "unknown-figure",
                        fmt::format("no pipeline has a figure '{}', which --front asks for", figure),
                        "--json lists all figures by evaluator and metric; --with says which evaluators measure");
    }
  }
  return diagnostics.has_errors() ? refuse(diagnostics) : done;
}

/// Two outputs in one file, or one in an input's place.
bool outputs_clash(const Arguments& arguments, Diagnostics& diagnostics) {
  std::vector<std::string> taken = arguments.inputs;
  if (!arguments.baseline.empty()) taken.push_back(arguments.baseline);
  for (const std::string& output : {arguments.report, arguments.csv, arguments.html}) {
    if (output.empty()) continue;
    if (output == "-") {
      diagnostics.error({}, "bad-arguments", "--report, --csv and --html take the name of a file",
                        "--json prints the comparison");
    }
    if (std::ranges::any_of(taken, [&](const std::string& other) { return is_same_file(other, output); })) {
      diagnostics.error({.file = output}, "bad-arguments", "is an input or another output",
                        "give the output a file of its own");
    }
    taken.push_back(output);
  }
  return diagnostics.has_errors();
}

}  // namespace

Exit compare(const Arguments& arguments, const Registry& registry) {
  Diagnostics diagnostics;
  const auto pipelines = contestants(arguments, diagnostics);
  const auto fronts = fronts_in(arguments, diagnostics);
  if (!pipelines || !fronts) return refuse(diagnostics);
  const auto inputs = scenes_of(arguments.inputs, diagnostics);
  if (!inputs) return refuse(diagnostics);
  const auto budget = budget_of(arguments, pipelines->size(), diagnostics);
  if (!budget || outputs_clash(arguments, diagnostics)) return refuse(diagnostics);
  if (!have_folders({arguments.report, arguments.csv, arguments.html}, diagnostics)) return refuse_file(diagnostics);

  const Executor executor(arguments.threads);
  std::vector<Comparison> comparisons;
  std::vector<Display> displays;
  Exit worst = done;
  for (const std::string& input : *inputs) {
    auto file = compared(input, {*pipelines, arguments.repeat, *fronts}, registry, executor, worst);
    if (!file) continue;
    if (!arguments.html.empty() && comparisons.size() < most_displays) {
      displays.push_back(with_memory(input, "show it", [&] { return display(file->input, file->scenes, comparisons.size()); }));
    }
    comparisons.push_back(std::move(file->comparison));
  }
  if (comparisons.empty()) return worst;
  std::vector<OutputFile> files;
  if (!arguments.report.empty()) files.push_back(text_file(arguments.report, to_json(comparisons)));
  if (!arguments.csv.empty()) files.push_back(text_file(arguments.csv, to_csv(comparisons)));
  if (!arguments.html.empty()) files.push_back(text_file(arguments.html, page(comparisons, displays, program_name())));
  if (!write_files(files, diagnostics)) return refuse_file(diagnostics);
  worst = std::max(worst, print(arguments.json ? to_json(comparisons) : to_text(comparisons)));
  worst = std::max(worst, unknown_fronts(comparisons));
  return std::max(worst, judged(*budget, comparisons));
}

}  // namespace foredraw::cli

// Several pipelines on the same scenes.

#include "file_runs.h"
#include "text_outputs.h"

#include <foredraw/page/page.h>

#include <foredraw/io/file_lender.h>
#include <foredraw/pipeline/sweep.h>
#include <foredraw/report/bound.h>
#include <foredraw/report/fronts.h>
#include <foredraw/report/since.h>
#include "scene_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace foredraw::cli {

namespace {

/// The inputs, folders among them replaced by the scenes that they hold.
std::optional<std::vector<std::string>> scenes_of(const std::vector<std::string>& inputs, const FolderScenes& which,
                                                  Diagnostics& diagnostics) {
  std::vector<std::string> files;
  for (const std::string& input : inputs) {
    if (!is_folder(input)) {
      files.push_back(input);
      continue;
    }
    const auto scenes = scenes_below(input, {}, which, diagnostics);
    if (!scenes) return std::nullopt;
    for (const auto& scene : *scenes) files.push_back((input / scene).string());
  }
  return files;
}

/// What is there of a file afterwards.
struct ComparedFile {
  Comparison comparison;
  Scene input;
  std::vector<std::optional<Scene>> scenes;  ///< [pipeline] nothing where it was lost
};

void tell_of(const Contest& made) {
  const std::vector<Branch>& branches = made.comparison.branches;
  for (std::size_t i = 0; i < branches.size(); ++i) {
    if (!branches[i].is_lost) continue;
    Diagnostics lost;
    lost.error({.file = made.comparison.input.path}, "can-not-be-planned",
               fmt::format("[{}] {} cannot be planned for this file:", i + 1, branches[i].name));
    tell(lost);
    tell(branches[i].report.diagnostics);
  }
  tell(made.warnings);
  for (const Branch& branch : branches) {
    if (!branch.is_lost) tell(branch.report.diagnostics);
  }
}

/// All pipelines on one file; a file that can not be read has none. `worst` tells of what failed.
ComparedFile compared(const std::string& input, const JobSetup& setup, const std::vector<NamedPipeline>& pipelines,
                      int rounds, Exit& worst) {
  Job job(setup, JobKind::compare, input);
  if (!with_memory(input, "read it", [&] { return job.read(); })) {
    worst = std::max(worst, refuse_file(job.diagnostics()));
    return {{{input, 0}, {}, {}, job.diagnostics().all()}, {}, {}};
  }
  tell(job.diagnostics());
  Contest made = with_memory(input, "work on it", [&] { return job.compare(pipelines, rounds); });
  end_progress();
  if (job.status() == JobStatus::cancelled) return {};
  tell_of(made);
  if (std::ranges::any_of(made.comparison.branches, &Branch::is_lost)) worst = std::max(worst, users_mistake);
  if (made.failed) worst = something_failed;
  return {std::move(made.comparison), std::move(job.scene()), std::move(made.scenes)};
}

/// What figures are held to.
struct Budget {
  std::vector<Bound> bounds;
  std::optional<Baseline> stored;
};

std::optional<Budget> budget_of(const CompareArguments& arguments, std::size_t pipelines, Diagnostics& diagnostics) {
  Budget budget;
  bool needs_baseline = false;
  for (const std::string& text : arguments.fail_if) {
    const auto bound = parse_bound(text, diagnostics);
    if (!bound) continue;
    needs_baseline = needs_baseline || bound->beside == Bound::Beside::baseline;
    budget.bounds.push_back(*bound);
  }
  if (arguments.baseline.empty() && needs_baseline && pipelines < 2) {
    diagnostics.error({}, "bad-arguments", "--fail-if names a baseline, but there is none",
                      "give --baseline a stored report, or run two pipelines, of which the first is the baseline");
  }
  budget.stored = baseline_of(arguments.baseline, diagnostics);
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

/// What changed since the baseline, of the first pipeline.
std::optional<Since> since_of(const CompareArguments& arguments, const Budget& budget,
                              std::span<const Comparison> comparisons) {
  if (!budget.stored) return std::nullopt;
  Since since(arguments.baseline, *budget.stored);
  for (const Comparison& comparison : comparisons) {
    if (comparison.is_lost() || comparison.branches.front().is_lost) {
      since.add_lost(comparison.input.path);
    } else {
      since.add(comparison.input.path, comparison.branches.front().report.after.metrics);
    }
  }
  return since;
}

/// Every pipeline that takes part: those of the arguments, at every value of the sweeps.
std::optional<std::vector<NamedPipeline>> contestants(const CompareArguments& arguments, const Registry& registry,
                                                      Diagnostics& diagnostics) {
  const std::vector<std::string> texts =
      arguments.pipelines.empty() ? std::vector<std::string>{"@default"} : arguments.pipelines;
  auto pipelines = pipelines_for(arguments, registry, texts, diagnostics);
  std::vector<Sweep> sweeps;
  for (const std::string& text : arguments.sweeps) {
    if (auto sweep = parse_sweep(text, diagnostics)) sweeps.push_back(std::move(*sweep));
  }
  if (!pipelines || diagnostics.has_errors()) return std::nullopt;
  return swept(std::move(*pipelines), sweeps, diagnostics);
}

using Fronts = std::vector<std::pair<std::string, std::string>>;

std::optional<Fronts> fronts_in(const CompareArguments& arguments, Diagnostics& diagnostics) {
  Fronts fronts;
  for (const std::string& text : arguments.fronts) {
    if (auto front = parse_front(text, diagnostics)) fronts.push_back(std::move(*front));
  }
  return diagnostics.has_errors() ? std::nullopt : std::optional(std::move(fronts));
}

/// Whether some evaluator or stage may have each of the figures that are named: who learns it after the work has lost
/// it.
bool have_sources(const Fronts& fronts, const Budget& budget, const std::vector<NamedPipeline>& pipelines,
                  Diagnostics& diagnostics) {
  std::set<std::string> sources;
  for (const NamedPipeline& named : pipelines) {
    for (const Stage& stage : named.pipeline.stages) sources.insert(stage.use);
    for (const Stage& stage : named.pipeline.measure) sources.insert(stage.use);
  }
  const auto check = [&](const std::string& figure, const std::string& argument) {
    const std::string source = figure.substr(0, figure.find_first_of(".#"));  // a second use is "tipsify#2"
    if (figure == "time" || sources.contains(source)) return;
    diagnostics.error({.file = argument}, "unknown-figure",
                      fmt::format("there is no figure '{}': figures come from {}", figure, fmt::join(sources, ", ")),
                      "add its evaluator with --with");
  };
  for (const auto& [x, y] : fronts) {
    check(x, "--front");
    check(y, "--front");
  }
  for (const Bound& bound : budget.bounds) check(bound.figure, "--fail-if");
  return !diagnostics.has_errors();
}

/// Tells of fronts that were asked for, and that nobody has the figures for.
Exit unknown_fronts(std::span<const Comparison> comparisons) {
  Diagnostics diagnostics;
  for (const Comparison& comparison : comparisons) {
    for (const std::string& figure : unknown_figures(comparison)) {
      diagnostics.error({.file = comparison.input.path}, "unknown-figure",
                        fmt::format("no pipeline has the figure '{}' that --front names", figure),
                        "--json lists all figures by evaluator and metric; add its evaluator with --with");
    }
  }
  return diagnostics.has_errors() ? refuse(diagnostics) : done;
}

}  // namespace

Exit compare(const CompareArguments& arguments, const Registry& registry) {
  Diagnostics diagnostics;
  const auto pipelines = contestants(arguments, registry, diagnostics);
  const auto fronts = fronts_in(arguments, diagnostics);
  if (!pipelines || !fronts) return refuse(diagnostics);
  const bool has_sprites = std::ranges::any_of(
      *pipelines, [&](const NamedPipeline& named) { return works_on_sprites(named.pipeline, registry); });
  const auto inputs = scenes_of(arguments.inputs, scenes_for(has_sprites), diagnostics);
  if (!inputs) return refuse(diagnostics);
  const auto budget = budget_of(arguments, pipelines->size(), diagnostics);
  if (!budget || !have_sources(*fronts, *budget, *pipelines, diagnostics) ||
      !have_files_of_their_own(files_read(arguments, arguments), {}, arguments, diagnostics)) {
    return refuse(diagnostics);
  }
  if (!have_folders({arguments.report, arguments.csv, arguments.html}, diagnostics)) return refuse_file(diagnostics);

  const Executor executor(arguments.threads);
  const SceneInput how = input_of({}, arguments, registry);
  const FileLender lender(how);
  JobSetup setup = setup_of(arguments, registry, executor, lender, how);
  setup.progress = progress_line();
  std::vector<Comparison> comparisons;
  std::vector<Display> displays;
  Exit worst = done;
  for (const std::string& input : *inputs) {
    ComparedFile file = compared(input, setup, *pipelines, arguments.repeat, worst);
    if (arguments.is_cancelled()) return tell_interrupted("nothing was written");
    file.comparison.fronts = *fronts;
    if (arguments.html.empty() || comparisons.size() >= most_displays) {
      for (Branch& branch : file.comparison.branches) leave_out_pictures(branch.report);
    }
    if (!arguments.html.empty() && displays.size() < most_displays && !file.scenes.empty()) {
      displays.push_back(with_memory(input, "show it", [&] {
        return display(file.input, file.scenes, comparisons.size(), pipelines->front().pipeline.subjects.subject);
      }));
    }
    comparisons.push_back(std::move(file.comparison));
  }
  if (std::ranges::all_of(comparisons, &Comparison::is_lost)) return worst;
  std::vector<OutputFile> files;
  const auto since = since_of(arguments, *budget, comparisons);
  const std::string changes = since ? since->to_json() : "";
  if (!arguments.report.empty()) files.push_back(text_file(arguments.report, to_json(comparisons, changes)));
  if (!arguments.csv.empty()) files.push_back(text_file(arguments.csv, to_csv(comparisons)));
  if (!arguments.html.empty()) files.push_back(text_file(arguments.html, page(comparisons, displays, program_name())));
  if (!write_files(files, diagnostics)) return refuse_file(diagnostics);
  worst = std::max(worst, print(arguments.json ? to_json(comparisons, changes) : to_text(comparisons)));
  if (since && !arguments.json) worst = std::max(worst, print('\n' + since->to_text()));
  return std::max({worst, unknown_fronts(comparisons), judged(*budget, comparisons)});
}

}  // namespace foredraw::cli

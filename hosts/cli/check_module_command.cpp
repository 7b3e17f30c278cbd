// What is asked of every technique that is built in, asked of a module's: right answers on odd draws at every option,
// the same ones each time; and what it gains, in which time.

#include "odd_draws.h"
#include "session.h"

#include <foredraw/base/counted.h>
#include <foredraw/report/table.h>

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>

namespace foredraw::cli {

namespace {

/// The stage behind whatever makes what it needs; an evaluator by itself.
Pipeline pipeline_with(const Plugin& plugin, const Settings& settings, const Registry& registry) {
  Pipeline pipeline;
  const Stage stage{.use = plugin.card.name, .settings = settings};
  if (plugin.kind == Kind::evaluator) {
    pipeline.measure.push_back(stage);
    return pipeline;
  }
  for (const std::string& need : plugin.card.needs) {
    for (const Plugin* other : registry.all()) {
      if (!other->card.provides.has(need) || registry.module_of(other->card.name) != nullptr) continue;
      pipeline.stages.push_back({.use = other->card.name});
      break;
    }
  }
  pipeline.stages.push_back(stage);
  return pipeline;
}

/// At its least or most.
std::optional<OptionValue> extreme(const OptionSpec& option, bool most) {
  if (option.type == OptionType::boolean) return OptionValue(most);
  if (option.type == OptionType::choice) return most ? option.choices.back() : option.choices.front();
  const double bound = most ? option.most : option.least;
  if (!std::isfinite(bound)) return std::nullopt;
  if (option.type == OptionType::integer) return static_cast<std::int64_t>(bound);
  return option.type == OptionType::number ? std::optional<OptionValue>(bound) : std::nullopt;
}

/// The defaults; all options at their least; each at its most, with the others at their least.
std::vector<Settings> settings_to_try(const Plugin& plugin) {
  std::vector<Settings> all{{}};
  Settings least;
  for (const OptionSpec& option : plugin.options) {
    if (auto value = extreme(option, false)) least[option.name] = *value;
  }
  if (!least.empty()) all.push_back(least);
  for (const OptionSpec& option : plugin.options) {
    if (auto value = extreme(option, true)) {
      all.push_back(least);
      all.back()[option.name] = *value;
    }
  }
  return all;
}

/// What came of a run: stamps of what is drawn, clusters, figures.
std::vector<std::uint64_t> traces_of(const Result& result) {
  std::vector<std::uint64_t> traces;
  for (const Draw& draw : result.scene.draws) {
    const IndexStream& stream = draw.full().stream();
    for (const Stamp& stamp : {draw.full().vertices->stamp(), stream.indices.stamp()}) {
      traces.push_back(stamp.high);
      traces.push_back(stamp.low);
    }
    if (stream.clusters) traces.insert(traces.end(), stream.clusters->offsets.begin(), stream.clusters->offsets.end());
  }
  for (const auto& [plugin, metrics] : result.report.after.metrics.all()) {
    for (const auto& [metric, figure] : metrics) {
      for (const double number : {figure.numerator, figure.denominator.value_or(-1), figure.error}) {
        traces.push_back(std::bit_cast<std::uint64_t>(number));
      }
    }
  }
  return traces;
}

class ModuleCheck {
 public:
  ModuleCheck(const CheckModuleArguments& arguments, const Registry& registry)
      : registry_(registry), threads_(std::max(Executor(arguments.threads).threads(), 2)) {}

  bool has_failed() const { return has_failed_; }

  std::string checked(const Plugin& plugin) {
    std::string text = fmt::format("\n{} ({})\n", plugin.card.name, to_text(plugin.kind));
    text += answers(plugin) + sameness(plugin) + figures(plugin);
    return text;
  }

 private:
  /// Nothing where it can not be planned.
  std::optional<Result> run(const Pipeline& pipeline, const Scene& scene, int threads, Diagnostics& diagnostics) const {
    const Executor executor(threads);
    const JobSetup setup{.registry = registry_, .executor = executor};
    Job job(setup, pipeline.stages.empty() ? JobKind::measure : JobKind::optimize, "");
    job.take({}, scene);
    if (!job.plan(pipeline) || !job.run()) {
      for (const Diagnostic& one : job.diagnostics().all()) diagnostics.add(one);
      return std::nullopt;
    }
    return Result{std::move(job.scene()), std::move(job.report()), job.status() == JobStatus::in_part};
  }

  std::string failure(const std::string& what) {
    has_failed_ = true;
    return "  FAILED " + what + '\n';
  }

  static std::string all_of(const std::vector<Diagnostic>& diagnostics) {
    std::string text;
    for (const Diagnostic& diagnostic : diagnostics) {
      if (diagnostic.severity != Severity::error) continue;
      text += fmt::format("\n    {}: {}", diagnostic.where.inside, diagnostic.message);
    }
    return text;
  }

  static const StageRecord& record_of(const Result& result, const Plugin& plugin) {
    return plugin.kind == Kind::evaluator ? result.report.measures.back() : result.report.stages.back();
  }

  /// Draws that it was given.
  static std::size_t candidates_of(const Result& result, const Plugin& plugin) {
    return record_of(result, plugin).candidates;
  }

  std::string answers(const Plugin& plugin) {
    const Scene scene = odd_draws();
    const std::vector<Settings> all = settings_to_try(plugin);
    std::string failures;
    std::size_t worked_on = 0;
    for (const Settings& settings : all) {
      Diagnostics diagnostics;
      const Pipeline pipeline = pipeline_with(plugin, settings, registry_);
      const auto result = run(pipeline, scene, 1, diagnostics);
      const std::vector<Diagnostic>& said = result ? result->report.diagnostics : diagnostics.all();
      const Stage& stage = pipeline.measure.empty() ? pipeline.stages.back() : pipeline.measure.back();
      if (!result || result->failed) failures += failure(fmt::format("{}{}", print_stage(stage), all_of(said)));
      if (result) worked_on = std::max(worked_on, candidates_of(*result, plugin));
    }
    if (!failures.empty()) return failures;
    if (worked_on == 0) return failure("no draw of triangles has what it needs");
    return fmt::format("  right on {} at {} of its options\n", counted(worked_on, "odd draw"),
                       counted(all.size(), "setting"));
  }

  std::string sameness(const Plugin& plugin) {
    const Scene scene = odd_draws();
    std::vector<std::vector<std::uint64_t>> traces;
    for (const int threads : {1, 1, threads_, threads_}) {
      Diagnostics diagnostics;
      const auto result = run(pipeline_with(plugin, {}, registry_), scene, threads, diagnostics);
      if (!result) return "";  // which was told
      traces.push_back(traces_of(*result));
    }
    if (traces[0] != traces[1]) return failure("it answers otherwise at the second time");
    if (traces[0] != traces[2] || traces[0] != traces[3]) {
      return failure(fmt::format("it answers otherwise on {}", counted(static_cast<std::size_t>(threads_), "thread")));
    }
    return fmt::format("  the same twice, and on 1 and {} threads\n", threads_);
  }

  /// What it takes, and what a vertex cache of 16 entries makes of it.
  std::string figures(const Plugin& plugin) {
    Table table({"  triangles", "milliseconds", "acmr before", "acmr after"});
    for (const std::size_t triangles : {1'000, 10'000, 100'000}) {
      Diagnostics diagnostics;
      Pipeline pipeline = pipeline_with(plugin, {}, registry_);
      if (plugin.kind != Kind::evaluator) pipeline.measure.push_back({.use = "vertex-cache"});
      const Scene scene = shuffled_sphere(triangles);
      const auto result = run(pipeline, scene, 1, diagnostics);
      if (!result || result->failed) return "";
      const Report& report = result->report;
      const auto acmr = [&](const StateRecord& state) {
        const auto plugins = state.metrics.all();
        const auto found = plugins.find("vertex-cache");
        return found == plugins.end() ? std::string("-") : fmt::format("{:.4f}", found->second.at("acmr").value());
      };
      table.add({fmt::format("  {}", report.before.triangles),
                 fmt::format("{:.2f}", 1000 * record_of(*result, plugin).seconds), acmr(report.before),
                 acmr(report.after)});
    }
    return table.text();
  }

  const Registry& registry_;
  int threads_;
  bool has_failed_ = false;
};

}  // namespace

Exit check_module(const CheckModuleArguments& arguments, const Registry& registry) {
  ModuleCheck check(arguments, registry);
  std::string text;
  for (const Plugin* plugin : registry.all()) {
    const ModuleFile* module = registry.module_of(plugin->card.name);
    if (module == nullptr) continue;
    if (text.empty())
      text = fmt::format("{}: {} {}, {}\n", module->path, module->vendor, module->version, module->hash);
    text += check.checked(*plugin);
  }
  const Exit printed = print(text);
  return check.has_failed() ? something_failed : printed;
}

}  // namespace foredraw::cli

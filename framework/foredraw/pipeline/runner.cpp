#include <foredraw/pipeline/runner.h>

#include <foredraw/analysis/scene_facts.h>
#include <foredraw/pipeline/milestones.h>
#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/stage_runner.h>
#include <foredraw/platform/machine.h>
#include <foredraw/platform/memory.h>
#include <foredraw/scene/levels.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <string>
#include <tuple>
#include <utility>

namespace foredraw {

namespace {

class Clock {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Every option of an evaluator as it was, defaults included: a figure without them can not be measured again.
std::map<std::string, OptionValue> whole_settings(const PlannedStage& stage) {
  std::map<std::string, OptionValue> whole;
  for (const OptionSpec& option : stage.plugin->options) whole[option.name] = option.default_value;
  for (const auto& [name, value] : stage.settings) whole[name] = value;
  if (stage.stage.level > 0) whole["level"] = std::int64_t{stage.stage.level};
  return whole;
}

std::vector<FileRecord> named_files(const Loans& loans) {
  std::vector<FileRecord> files;
  const auto add = [&](const auto& lent) {
    for (const auto& [path, loan] : lent) files.push_back({path, loan.bytes, to_text(loan.stamp)});
  };
  add(loans.scenes);
  add(loans.images);
  return files;
}

class PlanRunner {
 public:
  /// `watches_memory`: of every stage; nothing else may run in the process meanwhile.
  PlanRunner(const Plan& plan, Scene scene, const Surroundings& surroundings, bool watches_memory = false)
      : plan_(&plan), surroundings_(&surroundings), original_(scene), watches_memory_(watches_memory) {
    result_.scene = std::move(scene);
  }

  /// With stages to come there is a before and an after.
  void begin(bool with_stages) {
    const Clock clock;
    Report& report = result_.report;
    report.threads = surroundings_->executor.threads();
    report.machine = machine_text();
    report.optimized = with_stages;
    describe_input();
    count_steps();
    if (with_stages) measure_input();
    report.seconds += clock.seconds();
  }

  /// Goes on with another plan, which is the same up to here.
  void go_on_with(const Plan& plan) {
    plan_ = &plan;
    count_steps();
  }

  void run_stages(std::size_t first, std::size_t end) {
    const Clock clock;
    for (std::size_t i = first; i < end; ++i) {
      take_stage(run_one(plan_->stages[i], i + 1, "", result_.scene));
      if (surroundings_->milestones != nullptr && i + 1 < plan_->stages.size()) offer_milestone();
    }
    result_.report.seconds += clock.seconds();
  }

  /// Begins behind the stages that an earlier run has done, if one has. How many these are.
  std::size_t begin_at_milestone() {
    if (surroundings_->milestones == nullptr) return begin(true), 0;
    auto known = surroundings_->milestones->furthest(*plan_, original_);
    if (known) milestone_.measures = std::move(known->measures);
    for (Step& step : milestone_.measures) step.record.from_cache = true;
    begin(true);
    if (!known) return 0;
    result_.scene = std::move(known->scene);
    for (Step& step : known->stages) {
      step.record.from_cache = true;
      take_stage(std::move(step));
      ++done_;
    }
    return known->stages.size();
  }

  const std::vector<StageRecord>& stages() const { return result_.report.stages; }

  Result end() {
    const Clock clock;
    Report& report = result_.report;
    report.pipeline = print_file(plan_->pipeline);
    report.named = named_files(plan_->loans);
    report.modules = plan_->modules;
    report.seed = plan_->pipeline.seed;
    describe_output();
    const std::vector<StageRecord> before = std::exchange(report.measures, {});
    book_measures(measured(result_.scene, report.optimized ? "measuring the output: " : "measuring: "),
                  &DrawRecord::after, report.after);
    for (StageRecord& measure : report.measures) {
      const auto same = std::ranges::find(before, measure.use, &StageRecord::use);
      if (same != before.end()) measure.attachments_before = same->attachments;
    }
    report.diagnostics = diagnostics_.all();
    result_.failed = diagnostics_.has_errors();
    report.seconds += clock.seconds();
    report.peak_memory = std::max(peak_memory_, peak_memory());
    return std::move(result_);
  }

 private:
  using DrawState = StateRecord LevelRecord::*;

  void count_steps() {
    steps_ = result_.report.optimized ? plan_->stages.size() + 2 * plan_->measures.size() : plan_->measures.size();
  }

  void describe_input() {
    const Scene& scene = result_.scene;
    Report& report = result_.report;
    report.draws.resize(scene.draws.size());
    const std::vector<MeshFacts> facts = facts_of_draws(scene, surroundings_->analyses, surroundings_->executor);
    for (std::size_t i = 0; i < scene.draws.size(); ++i) {
      const Draw& draw = scene.draws[i];
      DrawRecord& record = report.draws[i];
      record.name = draw.name;
      record.facts = facts[i];
      for (std::size_t level = 0; level < draw.levels.size(); ++level) {
        record.level(level).before = state_of(draw, draw.levels[level]);
      }
      report.before.triangles += record.before.triangles;
    }
    report.before.vertices = count_vertices(scene);
  }

  void describe_output() {
    Report& report = result_.report;
    report.draws.resize(result_.scene.draws.size());
    for (std::size_t i = 0; i < report.draws.size(); ++i) {
      const Draw& draw = result_.scene.draws[i];
      report.draws[i].name = draw.name;
      for (std::size_t level = 0; level < draw.levels.size(); ++level) {
        LevelRecord& record = report.draws[i].level(level);
        const StateRecord state = state_of(draw, draw.levels[level]);
        record.traits = traits_of(draw, level);
        record.error = draw.levels[level].error;
        record.after.triangles = state.triangles;
        record.after.vertices = state.vertices;
        if (level == 0) report.after.triangles += state.triangles;
      }
    }
    report.after.vertices = count_vertices(result_.scene);
  }

  static StateRecord state_of(const Draw& draw, const Level& level) {
    StateRecord state;
    state.vertices = level.vertices->count;
    if (draw.topology == Topology::triangles) state.triangles = level.stream().triangle_count();
    return state;
  }

  void measure_input() {
    Report& report = result_.report;
    const bool is_known = milestone_.measures.size() == plan_->measures.size();
    std::vector<Step> steps = is_known ? milestone_.measures : measured(result_.scene, "measuring the input: ");
    if (is_known) done_ += static_cast<double>(steps.size());
    if (surroundings_->milestones != nullptr) milestone_.measures = steps;
    book_measures(std::move(steps), &DrawRecord::before, report.before);
    for (const Diagnostic& one : diagnostics_.all()) told_of_input_.insert(words_of(one));
  }

  std::vector<Step> measured(Scene& scene, std::string_view what) {
    std::vector<Step> steps;
    for (std::size_t i = 0; i < plan_->measures.size(); ++i) {
      steps.push_back(run_one(plan_->measures[i], plan_->stages.size() + i + 1, what, scene));
    }
    return steps;
  }

  void book_measures(std::vector<Step> steps, DrawState draw_state, StateRecord& total) {
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const PlannedStage& stage = plan_->measures[i];
      for (const Measured& measured : steps[i].measured) book(measured, stage, draw_state, total);
      result_.report.measures.push_back(std::move(steps[i].record));
      result_.report.evaluator_options[stage.label] = whole_settings(stage);
    }
  }

  void take_stage(Step step) {
    Report& report = result_.report;
    const PlannedStage& stage = plan_->stages[report.stages.size()];
    for (const Measured& measured : step.measured) book(measured, stage, &DrawRecord::after, report.after);
    report.stages.push_back(step.record);
    if (surroundings_->milestones != nullptr) milestone_.stages.push_back(std::move(step));
  }

  void offer_milestone() {
    if (diagnostics_.has_errors()) return;  // what failed may not fail the next time
    milestone_.scene = result_.scene;
    if (std::string why = surroundings_->milestones->reached(*plan_, milestone_); !why.empty()) {
      result_.report.stages.back().notes.push_back({"", "not-cached", std::move(why)});
    }
  }

  Step run_one(const PlannedStage& stage, std::size_t number, std::string_view what, Scene& scene) {
    Surroundings surroundings = *surroundings_;
    if (surroundings_->progress) {
      surroundings.progress = [&](std::string_view, double part) {
        surroundings_->progress(std::string(what) + stage.label, (done_ + part) / static_cast<double>(steps_));
      };
      surroundings.progress(stage.label, 0);
    }
    Step step;
    StageRecord& record = step.record;
    record.use = stage.label;
    record.text = print_stage(stage.stage);
    record.kind = stage.plugin->kind;
    record.loops_over = stage.loops_over();
    const std::optional<MemoryWatch> memory = watch_memory();
    const Clock clock;
    if (stage.left_out) {
      record.skipped.push_back({"unavailable", *stage.left_out, {}});
    } else {
      std::optional<Scene> coarser;
      if (stage.stage.level > 0) coarser = at_level(scene, static_cast<std::size_t>(stage.stage.level));
      Diagnostics told;
      step.measured =
          run_stage(stage, number, coarser ? *coarser : scene, original_, *plan_, surroundings, record, told);
      for (const Diagnostic& one : told.all()) tell(one);
      // Figures of the whole scene last: they stand in place of the sum over its parts.
      std::stable_partition(step.measured.begin(), step.measured.end(),
                            [](const Measured& figure) { return figure.about != About{}; });
    }
    record.seconds = clock.seconds();
    if (memory) record.memory = memory->growth();
    ++done_;
    return step;
  }

  /// What an evaluator says of the input is not told again when it says so of the output.
  void tell(const Diagnostic& one) {
    const auto before = told_of_input_.find(words_of(one));
    if (before == told_of_input_.end()) return diagnostics_.add(one);
    told_of_input_.erase(before);
  }

  /// Code, message, and inside of what.
  using Words = std::tuple<std::string, std::string, std::string>;
  static Words words_of(const Diagnostic& one) { return {one.code, one.message, one.where.inside}; }

  std::optional<MemoryWatch> watch_memory() {
    if (!watches_memory_) return std::nullopt;
    peak_memory_ = std::max(peak_memory_, peak_memory());  // which the watch begins anew
    return MemoryWatch();
  }

  void book(const Measured& measured, const PlannedStage& stage, DrawState draw_state, StateRecord& total) {
    Report& report = result_.report;
    const Figure figure = figure_of(measured, stage.plugin->card);
    // A stage may have added draws.
    report.draws.resize(std::max(report.draws.size(), result_.scene.draws.size()));
    if (measured.about.draw && *measured.about.draw < report.draws.size()) {
      (report.draws[*measured.about.draw].level(measured.about.level).*draw_state)
          .metrics.add(stage.label, measured.metric, figure);
    }
    if (measured.about == About{}) {
      total.metrics.set(stage.label, measured.metric, figure);
    } else if (measured.about.level == 0) {
      total.metrics.add(stage.label, measured.metric, figure);
    }
  }

  const Plan* plan_;
  const Surroundings* surroundings_;
  Scene original_;
  Diagnostics diagnostics_;
  Result result_;
  Milestone milestone_;  ///< the run so far, where somebody keeps it
  std::size_t steps_ = 0;
  double done_ = 0;
  bool watches_memory_ = false;
  std::uint64_t peak_memory_ = 0;       ///< before the last watch began
  std::multiset<Words> told_of_input_;  ///< and not of the output yet
};

/// Whether stages find the same surroundings in both.
bool run_alike(const Pipeline& a, const Pipeline& b) {
  const auto without_stages = [](Pipeline pipeline) {
    pipeline.stages.clear();
    pipeline.measure.clear();
    return pipeline;
  };
  return same_pipeline(without_stages(a), without_stages(b));
}

/// How many stages all plans begin with alike.
std::size_t shared_stages(std::span<const Plan> plans) {
  std::size_t shared = plans.front().stages.size();
  for (const Plan& plan : plans) {
    if (!run_alike(plan.pipeline, plans.front().pipeline)) return 0;
    std::size_t alike = 0;
    while (alike < std::min(shared, plan.stages.size()) &&
           print_stage(plan.stages[alike].stage) == print_stage(plans.front().stages[alike].stage)) {
      ++alike;
    }
    shared = alike;
  }
  return shared;
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

}  // namespace

Result optimize(const Plan& plan, Scene scene, const Surroundings& surroundings) {
  PlanRunner runner(plan, std::move(scene), surroundings);
  runner.run_stages(runner.begin_at_milestone(), plan.stages.size());
  return runner.end();
}

Result measure(const Plan& plan, Scene scene, const Surroundings& surroundings) {
  PlanRunner runner(plan, std::move(scene), surroundings);
  runner.begin(false);
  return runner.end();
}

std::vector<Result> compare(std::span<const Plan> plans, const Scene& scene, int rounds,
                            const Surroundings& surroundings) {
  if (plans.empty()) return {};
  const std::size_t shared = shared_stages(plans);
  Analyses analyses = surroundings.analyses.emptied();
  const Surroundings own{surroundings.executor, analyses, surroundings.cancel, surroundings.progress};
  PlanRunner input(plans.front(), scene, own, true);
  input.begin(true);
  std::vector<Result> results;
  std::vector<std::vector<std::vector<double>>> seconds(plans.size());  // [plan][stage][round]
  for (int round = 0; round < rounds; ++round) {
    analyses.clear();
    PlanRunner common = input;
    common.run_stages(0, shared);
    for (std::size_t p = 0; p < plans.size(); ++p) {
      analyses.clear();
      PlanRunner branch = common;
      branch.go_on_with(plans[p]);
      branch.run_stages(shared, plans[p].stages.size());
      seconds[p].resize(branch.stages().size());
      for (std::size_t s = 0; s < seconds[p].size(); ++s) seconds[p][s].push_back(branch.stages()[s].seconds);
      if (round == 0) results.push_back(branch.end());
    }
  }
  for (std::size_t p = 0; rounds > 1 && p < plans.size(); ++p) {
    for (std::size_t s = 0; s < seconds[p].size(); ++s) {
      results[p].report.stages[s].seconds = median(seconds[p][s]);
      results[p].report.stages[s].rounds = std::move(seconds[p][s]);
    }
  }
  return results;
}

}  // namespace foredraw

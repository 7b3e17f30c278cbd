#include <foredraw/pipeline/plan_runner.h>

#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/stage_runner.h>
#include <foredraw/platform/machine.h>
#include <foredraw/scene/levels.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace foredraw {

namespace {

class Clock {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

PlanRunner::PlanRunner(const Plan& plan, Scene scene, const Surroundings& surroundings, bool watches_memory)
    : plan_(&plan), surroundings_(&surroundings), original_(scene), watches_memory_(watches_memory) {
  result_.scene = std::move(scene);
}

void PlanRunner::begin(bool with_stages) {
  const Clock clock;
  Report& report = result_.report;
  report.threads = surroundings_->executor.threads();
  report.machine = machine_text();
  report.optimized = with_stages;
  describe_input(result_.scene, *surroundings_, report);
  count_steps();
  if (with_stages) measure_input();
  report.seconds += clock.seconds();
}

void PlanRunner::run_stages(std::size_t first, std::size_t end) {
  const Clock clock;
  for (std::size_t i = first; i < end; ++i) take_stage(run_one(plan_->stages[i], i + 1, "", result_.scene));
  result_.report.seconds += clock.seconds();
}

void PlanRunner::go_on_with(const Plan& plan) {
  plan_ = &plan;
  count_steps();
}

Result PlanRunner::end() {
  const Clock clock;
  Report& report = result_.report;
  describe_plan(*plan_, report);
  describe_output(result_.scene, report);
  const std::vector<StageRecord> before = std::exchange(report.measures, {});
  book_measures(measured(result_.scene, report.optimized ? "measuring the output: " : "measuring: "), *plan_,
                SceneState::output, result_.scene.draws.size(), report);
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

void PlanRunner::count_steps() {
  steps_ = result_.report.optimized ? plan_->stages.size() + 2 * plan_->measures.size() : plan_->measures.size();
}

void PlanRunner::measure_input() {
  book_measures(measured(result_.scene, "measuring the input: "), *plan_, SceneState::input, result_.scene.draws.size(),
                result_.report);
  for (const Diagnostic& one : diagnostics_.all()) told_of_input_.insert(words_of(one));
}

std::vector<Step> PlanRunner::measured(Scene& scene, std::string_view what) {
  std::vector<Step> steps;
  for (std::size_t i = 0; i < plan_->measures.size(); ++i) {
    steps.push_back(run_one(plan_->measures[i], plan_->stages.size() + i + 1, what, scene));
  }
  return steps;
}

void PlanRunner::take_stage(Step step) {
  Report& report = result_.report;
  const PlannedStage& stage = plan_->stages[report.stages.size()];
  book(step.measured, stage, SceneState::output, result_.scene.draws.size(), report);
  report.stages.push_back(std::move(step.record));
}

Step PlanRunner::run_one(const PlannedStage& stage, std::size_t number, std::string_view what, Scene& scene) {
  Surroundings surroundings = *surroundings_;
  if (surroundings.cancel != nullptr && *surroundings.cancel) {
    surroundings.progress = nullptr;  // the stage ends before it begins
  } else if (surroundings.progress) {
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
    step.measured = run_stage(stage, number, coarser ? *coarser : scene, original_, *plan_, surroundings, record, told);
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
void PlanRunner::tell(const Diagnostic& one) {
  const auto before = told_of_input_.find(words_of(one));
  if (before == told_of_input_.end()) return diagnostics_.add(one);
  told_of_input_.erase(before);
}

std::optional<MemoryWatch> PlanRunner::watch_memory() {
  if (!watches_memory_) return std::nullopt;
  peak_memory_ = std::max(peak_memory_, peak_memory());  // which the watch begins anew
  return MemoryWatch();
}

}  // namespace foredraw

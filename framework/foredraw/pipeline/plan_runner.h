#pragma once
// One run of a plan, step by step: who compares plans runs their common stages once, and goes on from a copy.

#include <foredraw/pipeline/run_record.h>
#include <foredraw/pipeline/runner.h>
#include <foredraw/platform/memory.h>

#include <optional>
#include <set>
#include <string>
#include <tuple>

namespace foredraw {

class PlanRunner {
 public:
  /// `watches_memory`: of every stage; nothing else may run in the process meanwhile.
  PlanRunner(const Plan& plan, Scene scene, const Surroundings& surroundings, bool watches_memory = false);

  /// With stages to come there is a before and an after.
  void begin(bool with_stages);
  void run_stages(std::size_t first, std::size_t end);
  /// Goes on with another plan, which is the same up to here.
  void go_on_with(const Plan& plan);
  const std::vector<StageRecord>& stages() const { return result_.report.stages; }
  Result end();

 private:
  void count_steps();
  void measure_input();
  std::vector<Step> measured(Scene& scene, std::string_view what);
  void take_stage(Step step);
  Step run_one(const PlannedStage& stage, std::size_t number, std::string_view what, Scene& scene);
  void tell(const Diagnostic& one);
  std::optional<MemoryWatch> watch_memory();

  using Words = std::tuple<std::string, std::string, std::string>;  ///< code, message, inside of what
  static Words words_of(const Diagnostic& one) { return {one.code, one.message, one.where.inside}; }

  const Plan* plan_;
  const Surroundings* surroundings_;
  Scene original_;
  Diagnostics diagnostics_;
  std::multiset<Words> told_of_input_;  ///< by evaluators, and not of the output yet
  Result result_;
  std::size_t steps_ = 0;
  double done_ = 0;
  bool watches_memory_ = false;
  std::uint64_t peak_memory_ = 0;  ///< before the last watch began
};

}  // namespace foredraw

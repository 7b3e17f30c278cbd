#include <foredraw/report/comparison.h>

#include <algorithm>
#include <cmath>

namespace foredraw {

namespace {

std::optional<double> value_in(const Metrics& metrics, const std::string& figure) {
  const Figure* found = metrics.find(figure);
  return found != nullptr && std::isfinite(found->value()) ? std::optional(found->value()) : std::nullopt;
}

/// Stage by stage: the same pipeline has the same stages on every file.
void add(std::vector<StageRecord>& sums, const std::vector<StageRecord>& stages) {
  sums.resize(stages.size());
  for (std::size_t i = 0; i < stages.size(); ++i) {
    StageRecord& sum = sums[i];
    sum.use = stages[i].use;
    sum.text = stages[i].text;
    sum.kind = stages[i].kind;
    sum.loops_over = stages[i].loops_over;
    sum.seconds += stages[i].seconds;
    sum.changed += stages[i].changed;
    sum.candidates += stages[i].candidates;
    sum.rounds.resize(stages[i].rounds.size());
    for (std::size_t round = 0; round < sum.rounds.size(); ++round) sum.rounds[round] += stages[i].rounds[round];
    if (stages[i].memory) sum.memory = std::max(sum.memory.value_or(0), *stages[i].memory);
  }
}

}  // namespace

double stages_seconds(const Report& report) {
  double seconds = 0;
  for (const StageRecord& stage : report.stages) seconds += stage.seconds;
  return seconds;
}

std::vector<double> rounds_of(const Report& report) {
  std::vector<double> sums;
  for (const StageRecord& stage : report.stages) {
    const std::vector<double> once{stage.seconds};
    const std::vector<double>& rounds = stage.rounds.empty() ? once : stage.rounds;
    sums.resize(rounds.size());
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += rounds[i];
  }
  return sums;
}

std::optional<double> value_of(const Branch& branch, const std::string& figure) {
  if (branch.is_lost) return std::nullopt;
  return figure == "time" ? stages_seconds(branch.report) : value_in(branch.report.after.metrics, figure);
}

std::optional<double> input_value(const Comparison& comparison, const std::string& figure) {
  const auto branch = std::ranges::find(comparison.branches, false, &Branch::is_lost);
  if (branch == comparison.branches.end()) return std::nullopt;
  return value_in(branch->report.before.metrics, figure);
}

std::optional<Comparison> sum_of(std::span<const Comparison> comparisons) {
  Comparison sum;
  std::size_t count = 0;
  for (const Comparison& comparison : comparisons) {
    if (comparison.is_lost()) continue;
    ++count;
    sum.fronts = comparison.fronts;
    sum.input.bytes += comparison.input.bytes;
    sum.branches.resize(comparison.branches.size());
    for (std::size_t i = 0; i < sum.branches.size(); ++i) {
      const Report& report = comparison.branches[i].report;
      sum.branches[i].name = comparison.branches[i].name;
      sum.branches[i].is_lost = sum.branches[i].is_lost || comparison.branches[i].is_lost;
      Report& whole = sum.branches[i].report;
      whole.command = report.command;
      whole.pipeline = report.pipeline;
      whole.seed = report.seed;
      whole.threads = report.threads;
      whole.machine = report.machine;
      whole.optimized = report.optimized;
      whole.seconds += report.seconds;
      whole.peak_memory = std::max(whole.peak_memory, report.peak_memory);
      whole.before.add(report.before);
      whole.after.add(report.after);
      add(whole.stages, report.stages);
    }
  }
  if (count < 2) return std::nullopt;
  for (Branch& branch : sum.branches) {
    if (branch.is_lost) branch.report = {};  // some of the files are not all of them
  }
  sum.input.path = "all " + std::to_string(count) + " files";
  return sum;
}

}  // namespace foredraw

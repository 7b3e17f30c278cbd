#include <foredraw/report/comparison.h>

#include <algorithm>
#include <cmath>

namespace foredraw {

namespace {

std::optional<double> value_in(const Metrics& metrics, const std::string& figure) {
  const std::size_t dot = figure.find('.');
  if (dot == std::string::npos) return std::nullopt;
  const Figure* found = metrics.find(figure.substr(0, dot), figure.substr(dot + 1));
  return found != nullptr && std::isfinite(found->value()) ? std::optional(found->value()) : std::nullopt;
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

}  // namespace foredraw

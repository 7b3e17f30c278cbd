#include "levels.h"

#include <foredraw/collapses/collapse_limits.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace foredraw {

namespace {

/// Whether each comes strictly behind the one before; NaN comes behind nothing.
bool is_sorted(const std::vector<double>& values, auto is_before) {
  for (std::size_t i = 0; i + 1 < values.size(); ++i) {
    if (!is_before(values[i], values[i + 1])) return false;
  }
  return true;
}

}  // namespace

void check(const LevelGoals& goals) {
  const auto require = [](bool good, const char* mistake) {
    if (!good) throw std::invalid_argument(mistake);
  };
  require(!goals.ratios.empty() || !goals.errors.empty(), "give at least one of 'ratios' or 'errors'");
  require(goals.ratios.empty() || goals.errors.empty(), "give 'ratios' or 'errors', not both");
  require(std::ranges::all_of(goals.ratios, [](double ratio) { return ratio > 0 && ratio < 1; }),
          "each of 'ratios' must be above 0 and below 1");
  require(is_sorted(goals.ratios, std::greater<>()), "'ratios' must fall, from the finest level to the coarsest");
  require(std::ranges::all_of(goals.errors, [](double error) { return std::isfinite(error) && error >= 0; }),
          "each of 'errors' must be a distance, 0 or more");
  require(is_sorted(goals.errors, std::less<>()), "'errors' must rise, from the finest level to the coarsest");
}

std::vector<LevelCut> level_cuts(const JoinedMesh& mesh, const CollapseSequence& sequence, const Replay& run,
                                 const LevelGoals& goals, const Executor& executor, const std::atomic<bool>* cancel) {
  check(goals);
  const std::size_t most = collapses_that_leave_draws(sequence, mesh);
  std::vector<LevelCut> cuts;
  for (const double ratio : goals.ratios) {
    const auto triangles = static_cast<std::uint32_t>(std::ceil(ratio * run.triangles.front()));
    cuts.push_back({std::min(collapses_to(run, triangles), most), std::nullopt});
  }
  if (goals.errors.empty()) return cuts;
  const DrawDistances distances(mesh);
  std::size_t before = 0;
  for (const double error : goals.errors) {
    before = collapses_within(sequence, mesh, distances, error, before, most, {.cancel = cancel}, executor);
    cuts.push_back({before, before < most ? std::optional(error) : std::nullopt});
  }
  return cuts;
}

}  // namespace foredraw

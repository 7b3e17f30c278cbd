#include <foredraw/analysis/overdraw_figures.h>

#include <cmath>

namespace foredraw {

namespace {

/// Of a weighted mean of n samples, given the sum of their squared weighted deviations from it. Unweighted: the usual
/// sqrt(squares / (n * (n - 1))).
double standard_error(double squares, double n, double sum_of_weights) {
  return n < 2 ? 0 : std::sqrt(squares * n / (n - 1)) / sum_of_weights;
}

bool shows_something(const OverdrawCount& count) { return count.visible > 0; }

double ratio_of(const OverdrawCount& count) {
  return static_cast<double>(count.shaded) / static_cast<double>(count.visible);
}

}  // namespace

Estimate overdraw_ratio(std::span<const OverdrawCount> counts, std::span<const View> views) {
  const auto weight = [&](std::size_t i) { return views[i % views.size()].weight; };
  Estimate estimate;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    estimate.numerator += weight(i) * static_cast<double>(counts[i].shaded);
    estimate.denominator += weight(i) * static_cast<double>(counts[i].visible);
  }
  if (estimate.denominator == 0) return estimate;

  const double ratio = estimate.numerator / estimate.denominator;
  double squares = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double deviation =
        weight(i) * (static_cast<double>(counts[i].shaded) - ratio * static_cast<double>(counts[i].visible));
    squares += deviation * deviation;
  }
  estimate.error = standard_error(squares, static_cast<double>(counts.size()), estimate.denominator);
  return estimate;
}

Estimate overdraw_view_mean(std::span<const OverdrawCount> counts, std::span<const View> views) {
  const auto weight = [&](std::size_t i) { return views[i % views.size()].weight; };
  Estimate estimate;
  double n = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (!shows_something(counts[i])) continue;
    estimate.numerator += weight(i) * ratio_of(counts[i]);
    estimate.denominator += weight(i);
    n += 1;
  }
  double squares = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (!shows_something(counts[i])) continue;
    const double deviation = weight(i) * (ratio_of(counts[i]) - estimate.numerator / estimate.denominator);
    squares += deviation * deviation;
  }
  estimate.error = standard_error(squares, n, estimate.denominator);
  return estimate;
}

std::optional<std::size_t> worst_picture(std::span<const OverdrawCount> counts) {
  std::optional<std::size_t> worst;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (shows_something(counts[i]) && (!worst || ratio_of(counts[i]) > ratio_of(counts[*worst]))) worst = i;
  }
  return worst;
}

}  // namespace foredraw

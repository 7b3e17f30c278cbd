#include "overdraw_figures.h"

#include <cmath>

namespace foredraw {

namespace {

/// Of a mean, given the sum of the squared deviations of n samples from it.
double standard_error(double squares, double n) { return n < 2 ? 0 : std::sqrt(squares / (n * (n - 1))); }

bool shows_something(const OverdrawCount& count) { return count.visible > 0; }

double ratio_of(const OverdrawCount& count) {
  return static_cast<double>(count.shaded) / static_cast<double>(count.visible);
}

}  // namespace

Estimate overdraw_ratio(std::span<const OverdrawCount> views) {
  OverdrawCount sum;
  for (const OverdrawCount& count : views) sum += count;
  Estimate estimate{static_cast<double>(sum.shaded), static_cast<double>(sum.visible), 0};
  if (sum.visible == 0) return estimate;

  double squares = 0;
  for (const OverdrawCount& count : views) {
    const double deviation = static_cast<double>(count.shaded) - ratio_of(sum) * static_cast<double>(count.visible);
    squares += deviation * deviation;
  }
  const auto n = static_cast<double>(views.size());
  estimate.error = standard_error(squares, n) / (estimate.denominator / n);
  return estimate;
}

Estimate overdraw_view_mean(std::span<const OverdrawCount> views) {
  Estimate estimate;
  for (const OverdrawCount& count : views) {
    if (!shows_something(count)) continue;
    estimate.numerator += ratio_of(count);
    estimate.denominator += 1;
  }
  double squares = 0;
  for (const OverdrawCount& count : views) {
    if (!shows_something(count)) continue;
    const double deviation = ratio_of(count) - estimate.numerator / estimate.denominator;
    squares += deviation * deviation;
  }
  estimate.error = standard_error(squares, estimate.denominator);
  return estimate;
}

}  // namespace foredraw

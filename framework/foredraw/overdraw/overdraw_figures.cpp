#include <foredraw/overdraw/overdraw_figures.h>

#include <cmath>

namespace foredraw {

namespace {

/// Of a weighted mean of n samples, given the sum of their squared weighted deviations from it. Unweighted: the usual
/// sqrt(squares / (n * (n - 1))).
double standard_error(double squares, double n, double sum_of_weights) {
  return n < 2 ? 0 : std::sqrt(squares * n / (n - 1)) / sum_of_weights;
}

double ratio_of(const OverdrawCount& count) {
  return static_cast<double>(count.shaded) / static_cast<double>(count.visible);
}

}  // namespace

void ViewTally::add(const OverdrawCount& picture, double weight) {
  shaded += weight * static_cast<double>(picture.shaded);
  visible += weight * static_cast<double>(picture.visible);
  if (picture.visible == 0) return;
  ratios += weight * ratio_of(picture);
  pictures += weight;
}

ViewTally& ViewTally::operator+=(const ViewTally& other) {
  shaded += other.shaded;
  visible += other.visible;
  ratios += other.ratios;
  pictures += other.pictures;
  return *this;
}

Estimate overdraw_ratio(std::span<const ViewTally> tallies, std::span<const View> views) {
  const auto weight = [&](std::size_t i) { return views[i % views.size()].weight; };
  Estimate estimate;
  for (std::size_t i = 0; i < tallies.size(); ++i) {
    estimate.numerator += weight(i) * tallies[i].shaded;
    estimate.denominator += weight(i) * tallies[i].visible;
  }
  if (estimate.denominator == 0) return estimate;

  const double ratio = estimate.numerator / estimate.denominator;
  double squares = 0;
  for (std::size_t i = 0; i < tallies.size(); ++i) {
    const double deviation = weight(i) * (tallies[i].shaded - ratio * tallies[i].visible);
    squares += deviation * deviation;
  }
  estimate.error = standard_error(squares, static_cast<double>(tallies.size()), estimate.denominator);
  return estimate;
}

Estimate overdraw_view_mean(std::span<const ViewTally> tallies, std::span<const View> views) {
  const auto weight = [&](std::size_t i) { return views[i % views.size()].weight; };
  Estimate estimate;
  double n = 0;
  for (std::size_t i = 0; i < tallies.size(); ++i) {
    if (tallies[i].pictures == 0) continue;
    estimate.numerator += weight(i) * tallies[i].ratios;
    estimate.denominator += weight(i) * tallies[i].pictures;
    n += 1;
  }
  if (n == 0) return estimate;
  const double mean = estimate.numerator / estimate.denominator;
  double squares = 0;
  for (std::size_t i = 0; i < tallies.size(); ++i) {
    const double deviation = weight(i) * (tallies[i].ratios - mean * tallies[i].pictures);
    squares += deviation * deviation;
  }
  estimate.error = standard_error(squares, n, estimate.denominator);
  return estimate;
}

bool is_worse(const OverdrawCount& picture, const OverdrawCount& than) {
  return picture.visible > 0 && (than.visible == 0 || ratio_of(picture) > ratio_of(than));
}

}  // namespace foredraw

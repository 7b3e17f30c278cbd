#include <foredraw/analysis/sampled.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace foredraw {

Sampled mean_of(std::span<const double> values) {
  Sampled mean;
  const auto count = static_cast<double>(values.size());
  double squares = 0;
  for (const double value : values) mean.value += value / count;
  for (const double value : values) squares += (value - mean.value) * (value - mean.value);
  if (count > 1) mean.error = std::sqrt(squares / (count * (count - 1)));
  return mean;
}

Sampled rms_of(std::span<const double> values) {
  std::vector<double> squares;
  squares.reserve(values.size());
  for (const double value : values) squares.push_back(value * value);
  const Sampled mean = mean_of(squares);
  const double rms = std::sqrt(mean.value);
  return {rms, rms > 0 ? mean.error / (2 * rms) : 0};
}

Sampled quantile_of(std::vector<double> values, double part) {
  if (values.empty()) return {};
  std::ranges::sort(values);
  const auto count = static_cast<double>(values.size());
  const auto at = [&](double place) {
    return values[static_cast<std::size_t>(std::clamp(std::ceil(place) - 1, 0.0, count - 1))];
  };
  const double place = part * count, deviation = std::sqrt(part * (1 - part) * count);
  return {at(place), (at(place + deviation) - at(place - deviation)) / 2};
}

Sampled mean_of_both(const Sampled& a, const Sampled& b) {
  return {(a.value + b.value) / 2, std::sqrt(a.error * a.error + b.error * b.error) / 2};
}

Sampled rms_of_both(const Sampled& a, const Sampled& b) {
  const double rms = std::sqrt((a.value * a.value + b.value * b.value) / 2);
  const double of_a = a.value * a.error, of_b = b.value * b.error;
  return {rms, rms > 0 ? std::sqrt(of_a * of_a + of_b * of_b) / (2 * rms) : 0};
}

}  // namespace foredraw

#include <foredraw/analysis/surface_distance.h>

#include <foredraw/base/random.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace foredraw {

namespace {

/// The mean, and the standard error that it has if the values are independent.
Sampled mean_of(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  Sampled mean;
  double squares = 0;
  for (const double value : values) mean.value += value / count;
  for (const double value : values) squares += (value - mean.value) * (value - mean.value);
  if (count > 1) mean.error = std::sqrt(squares / (count * (count - 1)));
  return mean;
}

/// By order statistics: as many values are below a quantile as a binomial distribution says.
Sampled quantile_of(const std::vector<double>& sorted, double part) {
  const auto count = static_cast<double>(sorted.size());
  const auto at = [&](double place) {
    return sorted[static_cast<std::size_t>(std::clamp(std::ceil(place) - 1, 0.0, count - 1))];
  };
  const double deviation = std::sqrt(part * (1 - part) * count);
  return {at(part * count), (at(part * count + deviation) - at(part * count - deviation)) / 2};
}

/// In the sequence in which triangles use them.
std::vector<glm::dvec3> used_vertices(const Surface& surface) {
  std::vector<bool> is_used(surface.positions.size(), false);
  std::vector<glm::dvec3> points;
  for (std::size_t i = 0; i + 3 <= surface.indices.size(); i += 3) {
    const auto corners = surface.indices.subspan(i, 3);
    const bool is_finite = std::ranges::all_of(corners, [&](std::uint32_t v) {
      const glm::vec3& p = surface.positions[v];
      return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    });
    if (!is_finite) continue;
    for (const std::uint32_t v : corners) {
      if (!is_used[v]) points.emplace_back(surface.positions[v]);
      is_used[v] = true;
    }
  }
  return points;
}

std::vector<double> distances(const std::vector<glm::dvec3>& points, const ClosestPoints& to,
                              const Executor& executor) {
  std::vector<double> result;
  for (const Closest& closest : nearest_points(points, to, executor)) result.push_back(closest.distance);
  return result;
}

OneWayDistance one_way(const Surface& from, const ClosestPoints& to, std::size_t samples, std::uint64_t seed,
                       const Executor& executor) {
  std::vector<glm::dvec3> points;
  for (const SurfacePoint& point : points_on(from, samples, seed)) points.push_back(position_of(from, point));
  OneWayDistance result = summed_up(distances(points, to, executor));
  for (const double d : distances(used_vertices(from), to, executor)) result.largest = std::max(result.largest, d);
  return result;
}

}  // namespace

std::vector<Closest> nearest_points(std::span<const glm::dvec3> points, const ClosestPoints& to,
                                    const Executor& executor) {
  constexpr std::size_t at_a_time = 512;
  std::vector<Closest> result(points.size());
  executor.for_each((points.size() + at_a_time - 1) / at_a_time, [&](std::size_t part) {
    const std::size_t end = std::min(points.size(), (part + 1) * at_a_time);
    std::uint32_t hint = no_triangle;
    for (std::size_t i = part * at_a_time; i < end; ++i) {
      result[i] = to.nearest(points[i], hint);
      hint = result[i].triangle;
    }
  });
  return result;
}

OneWayDistance summed_up(std::vector<double> distances) {
  OneWayDistance result;
  if (distances.empty()) return result;
  result.mean = mean_of(distances);
  std::ranges::sort(distances);
  result.largest = distances.back();
  result.p99 = quantile_of(distances, 0.99);
  for (double& d : distances) d *= d;
  const Sampled square = mean_of(distances);
  result.rms.value = std::sqrt(square.value);
  if (result.rms.value > 0) result.rms.error = square.error / (2 * result.rms.value);
  return result;
}

Sampled rms_of_both(const Sampled& there, const Sampled& back) {
  Sampled both{std::sqrt((there.value * there.value + back.value * back.value) / 2)};
  const double of_there = there.value * there.error, of_back = back.value * back.error;
  if (both.value > 0) both.error = std::sqrt(of_there * of_there + of_back * of_back) / (2 * both.value);
  return both;
}

std::optional<SurfaceDistance> surface_distance(const Surface& a, const Surface& b,
                                                const SurfaceDistanceOptions& options, const Executor& executor) {
  const ClosestPoints of_a(a), of_b(b);
  if (of_a.empty() && of_b.empty()) return SurfaceDistance{};
  if (of_a.empty() || of_b.empty()) return std::nullopt;
  const std::size_t samples = std::max<std::size_t>(options.samples, 1);
  SurfaceDistance result;
  result.there = one_way(a, of_b, samples, derive_seed(options.seed, 0, 0), executor);
  result.back = one_way(b, of_a, samples, derive_seed(options.seed, 1, 0), executor);
  result.largest = std::max(result.there.largest, result.back.largest);
  const Sampled rms = rms_of_both(result.there.rms, result.back.rms);
  result.rms = rms.value;
  result.rms_error = rms.error;
  return result;
}

}  // namespace foredraw

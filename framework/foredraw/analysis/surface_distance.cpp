#include <foredraw/analysis/surface_distance.h>

#include <foredraw/base/random.h>
#include <foredraw/geometry/finite.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace foredraw {

namespace {

/// In the sequence in which triangles use them.
std::vector<glm::dvec3> used_vertices(const Surface& surface) {
  std::vector<bool> is_used(surface.positions.size(), false);
  std::vector<glm::dvec3> points;
  for (std::size_t i = 0; i + 3 <= surface.indices.size(); i += 3) {
    const auto corners = surface.indices.subspan(i, 3);
    if (!std::ranges::all_of(corners, [&](std::uint32_t v) { return is_finite(surface.positions[v]); })) continue;
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

OneWayDistance one_way_distance(const Surface& of, const ClosestPoints& to, std::size_t samples, std::uint64_t seed,
                                const Executor& executor) {
  std::vector<glm::dvec3> points;
  for (const SurfacePoint& point : points_on(of, std::max<std::size_t>(samples, 1), seed)) {
    points.push_back(position_of(of, point));
  }
  const std::vector<double> sampled = distances(points, to, executor);
  OneWayDistance result{0, mean_of(sampled), rms_of(sampled), quantile_of(sampled, 0.99)};
  for (const double d : sampled) result.largest = std::max(result.largest, d);
  return result;
}

std::optional<SurfaceDistance> surface_distance(const Surface& a, const Surface& b,
                                                const SurfaceDistanceOptions& options, const Executor& executor) {
  const ClosestPoints of_a(a), of_b(b);
  if (of_a.empty() && of_b.empty()) return SurfaceDistance{};
  if (of_a.empty() || of_b.empty()) return std::nullopt;
  SurfaceDistance result;
  result.there = one_way_distance(a, of_b, options.samples, derive_seed(options.seed, 0, 0), executor);
  result.back = one_way_distance(b, of_a, options.samples, derive_seed(options.seed, 1, 0), executor);
  for (const double d : distances(used_vertices(a), of_b, executor)) {
    result.there.largest = std::max(result.there.largest, d);
  }
  for (const double d : distances(used_vertices(b), of_a, executor)) {
    result.back.largest = std::max(result.back.largest, d);
  }
  result.largest = std::max(result.there.largest, result.back.largest);
  const Sampled rms = rms_of_both(result.there.rms, result.back.rms);
  result.rms = rms.value;
  result.rms_error = rms.error;
  return result;
}

}  // namespace foredraw

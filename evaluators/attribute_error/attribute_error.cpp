#include "attribute_error.h"

#include <foredraw/analysis/surface_distance.h>
#include <foredraw/analysis/surface_samples.h>
#include <foredraw/base/random.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace foredraw {

namespace {

glm::dvec3 between(std::span<const glm::vec3> carried, const Surface& surface, std::uint32_t triangle,
                   const glm::dvec3& weights) {
  glm::dvec3 sum(0);
  for (int c = 0; c < 3; ++c) {
    sum += weights[c] * glm::dvec3(carried[surface.indices[std::size_t{3} * triangle + static_cast<std::size_t>(c)]]);
  }
  return sum;
}

double uv_distance(const glm::dvec3& a, const glm::dvec3& b) { return glm::length(a - b); }

/// Not a number where one of them has no direction.
double degrees_between(const glm::dvec3& a, const glm::dvec3& b) {
  if (!(glm::dot(a, a) > 0) || !(glm::dot(b, b) > 0)) return std::numeric_limits<double>::quiet_NaN();
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * (180 / std::numbers::pi);
}

template <class Difference>
std::optional<Sampled> rms_over(const std::vector<SurfacePoint>& points, const Surface& of,
                                std::span<const glm::vec3> of_carried, const std::vector<Closest>& nearest,
                                const Surface& to, std::span<const glm::vec3> to_carried, Difference difference) {
  if (of_carried.empty() || to_carried.empty()) return std::nullopt;
  std::vector<double> differences;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double found = difference(between(of_carried, of, points[i].triangle, points[i].weights),
                                    between(to_carried, to, nearest[i].triangle, nearest[i].weights));
    if (std::isfinite(found)) differences.push_back(found);
  }
  if (differences.empty()) return std::nullopt;
  return rms_of(differences);
}

OneWayAttributeError one_way(const AttributedSurface& of, const AttributedSurface& to, const ClosestPoints& closest,
                             std::size_t samples, std::uint64_t seed, const Executor& executor) {
  const std::vector<SurfacePoint> points = points_on(of.surface, samples, seed);
  std::vector<glm::dvec3> positions;
  positions.reserve(points.size());
  for (const SurfacePoint& point : points) positions.push_back(position_of(of.surface, point));
  const std::vector<Closest> nearest = nearest_points(positions, closest, executor);
  return {rms_over(points, of.surface, of.uvs, nearest, to.surface, to.uvs, uv_distance),
          rms_over(points, of.surface, of.normals, nearest, to.surface, to.normals, degrees_between)};
}

std::optional<Sampled> both(const std::optional<Sampled>& a, const std::optional<Sampled>& b) {
  if (!a || !b) return std::nullopt;
  return rms_of_both(*a, *b);
}

}  // namespace

std::optional<Sampled> AttributeError::uv() const { return both(to_original.uv, from_original.uv); }

std::optional<Sampled> AttributeError::normal() const { return both(to_original.normal, from_original.normal); }

std::optional<AttributeError> attribute_error(const AttributedSurface& changed, const AttributedSurface& original,
                                              const AttributeErrorOptions& options, std::uint64_t seed,
                                              const Executor& executor) {
  const ClosestPoints of_changed(changed.surface), of_original(original.surface);
  if (of_changed.empty() != of_original.empty()) return std::nullopt;
  if (of_changed.empty()) return AttributeError{};
  const auto samples = static_cast<std::size_t>(options.samples);
  return AttributeError{one_way(changed, original, of_original, samples, derive_seed(seed, 0, 0), executor),
                        one_way(original, changed, of_changed, samples, derive_seed(seed, 1, 0), executor)};
}

}  // namespace foredraw

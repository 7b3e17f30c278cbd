#include "cast_heights.h"

#include <foredraw/runtime/displaced_surface.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace foredraw::processors::displacement_bake {

namespace {

/// A surface that a ray meets so many times as far away as it is near lies on another fold.
constexpr double most_slope = 3;

std::vector<Blocks> all(std::size_t triangles, Blocks side) { return std::vector<Blocks>(triangles, side); }

/// A point of the cage, the same bits whichever triangle asks.
struct Place {
  glm::dvec3 point, direction;
};

Place place_on(const Cage& cage, const std::array<std::uint32_t, 3>& corners, const std::array<float, 3>& weights) {
  float position[3][3], direction[3][3], point[3], along[3];
  for (std::size_t c = 0; c < 3; ++c) {
    std::memcpy(position[c], &cage.positions[corners[c]], sizeof(position[c]));
    std::memcpy(direction[c], &cage.directions[corners[c]], sizeof(direction[c]));
  }
  foredraw_weighted(position, weights.data(), point);
  foredraw_weighted(direction, weights.data(), along);
  return {{point[0], point[1], point[2]}, {along[0], along[1], along[2]}};
}

}  // namespace

Target::Target(const Surface& surface)
    : fronts_(surface.positions, surface.indices, all(surface.indices.size() / 3, Blocks::front)),
      backs_(surface.positions, surface.indices, all(surface.indices.size() / 3, Blocks::back)),
      points_(surface) {}

double Target::height_from(const glm::dvec3& point, const glm::dvec3& direction) const {
  if (!std::isfinite(point.x + point.y + point.z)) return 0;
  const Closest closest = points_.nearest(point);
  if (closest.triangle == no_triangle || closest.distance == 0) return 0;
  const auto above = backs_.first({point, direction}), below = fronts_.first({point, -direction});
  const double up = above ? above->way : INFINITY, down = below ? below->way : INFINITY;
  if (std::min(up, down) <= most_slope * closest.distance) return up <= down ? up : -down;
  return glm::dot(closest.point - point, direction);
}

std::vector<float> cast_heights(const Cage& cage, const TessellatedMesh& mesh, const Target& target,
                                const Executor& executor) {
  constexpr std::size_t step = 1024;
  std::vector<float> heights(mesh.vertices(), 0.0f);
  executor.for_each((heights.size() + step - 1) / step, [&](std::size_t s) {
    for (std::size_t v = s * step; v < std::min(heights.size(), (s + 1) * step); ++v) {
      const auto corner = static_cast<std::uint32_t>(v);
      std::array<std::uint32_t, 3> corners = {corner, corner, corner};
      std::array<float, 3> weights = {1, 0, 0};
      if (v >= mesh.kept) {
        const SurfaceSample& sample = mesh.samples[v - mesh.kept];
        std::memcpy(corners.data(), &cage.indices[3 * std::size_t{sample.triangle}], sizeof(corners));
        weights = sample.at.coordinates();
      }
      const Place place = place_on(cage, corners, weights);
      const double length = glm::length(place.direction);
      if (length > 0) heights[v] = static_cast<float>(target.height_from(place.point, place.direction / length));
    }
  });
  return heights;
}

}  // namespace foredraw::processors::displacement_bake

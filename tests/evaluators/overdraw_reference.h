#pragma once
// What overdraw_raster must count, found without cleverness.

#include "../../evaluators/overdraw_raster/overdraw_raster.h"

#include "support/covers_pixel.h"
#include "support/meshes.h"

#include <foredraw/analysis/camera.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

namespace foredraw {

/// Every pixel asked of every triangle, in wide integers; depth as the exact fraction that the plane through the
/// corners has there, rounded down.
inline OverdrawCount overdraw_by_asking(const testing::TestMesh& mesh, const glm::dvec3& direction, int size) {
  std::vector<glm::vec3> used;
  for (const std::uint32_t index : mesh.indices) used.push_back(mesh.positions[index]);
  glm::dvec3 least(used[0]);
  glm::dvec3 most(used[0]);
  for (const glm::dvec3 p : used) {
    least = glm::min(least, p);
    most = glm::max(most, p);
  }
  const glm::dvec3 centre = (least + most) / 2.0;
  double radius = 0;
  for (const glm::dvec3 p : used) radius = std::max(radius, glm::length(p - centre));

  const Camera camera({direction}, size);
  std::map<std::pair<int, int>, std::vector<__int128>> fragments;  // depths in the order of drawing
  for (std::size_t t = 0; t < used.size(); t += 3) {
    std::array<Corner, 3> c;
    for (std::size_t i = 0; i < 3; ++i) c[i] = camera.project((glm::dvec3(used[t + i]) - centre) / radius);
    const auto cross = [](const Corner& p, const Corner& q, __int128 x, __int128 y) {
      return (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
    };
    const __int128 area = cross(c[0], c[1], c[2].x, c[2].y);
    if (area <= 0) continue;  // turned away
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        if (!covers_pixel(c[0], c[1], c[2], x, y)) continue;
        const __int128 u = 256 * x + 128;
        const __int128 v = 256 * y + 128;
        const __int128 depth = cross(c[1], c[2], u, v) * c[0].depth + cross(c[2], c[0], u, v) * c[1].depth +
                               cross(c[0], c[1], u, v) * c[2].depth;
        fragments[{x, y}].push_back(depth / area);
      }
    }
  }
  OverdrawCount count;
  for (const auto& [pixel, depths] : fragments) {
    ++count.visible;
    for (std::size_t i = 0; i < depths.size(); ++i) {
      const auto nearest = std::min_element(depths.begin(), depths.begin() + static_cast<std::ptrdiff_t>(i));
      if (i == 0 || depths[i] < *nearest) ++count.shaded;
      if (i > 0 && depths[i] == *nearest) ++count.ties;
    }
  }
  return count;
}

}  // namespace foredraw

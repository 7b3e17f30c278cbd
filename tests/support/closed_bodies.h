#pragma once
// Bodies that are closed to the bit: where a seam would be, vertices are shared.

#include "support/meshes.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace foredraw::testing {

/// Outwards, around y, of a profile (radius, height) from below to above: vertices of radius 0 stand `slices` times in
/// one place. Closed if the profile begins and ends at radius 0.
inline TestMesh turned_body(const std::vector<std::pair<float, float>>& profile, std::uint32_t slices) {
  TestMesh mesh;
  for (const auto& [radius, height] : profile) {
    for (std::uint32_t i = 0; i < slices; ++i) {
      const float a = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(slices);
      mesh.positions.emplace_back(radius * std::cos(a) + 0.f, height, 0.f - radius * std::sin(a));
    }
  }
  for (std::uint32_t j = 0; j + 1 < profile.size(); ++j) {
    for (std::uint32_t i = 0; i < slices; ++i) {
      const std::uint32_t a = j * slices + i, b = j * slices + (i + 1) % slices, c = a + slices, d = b + slices;
      if (profile[j].first > 0) mesh.indices.insert(mesh.indices.end(), {a, b, d});
      if (profile[j + 1].first > 0) mesh.indices.insert(mesh.indices.end(), {a, d, c});
    }
  }
  return mesh;
}

inline TestMesh closed_sphere(std::uint32_t slices, std::uint32_t stacks, float radius = 1) {
  std::vector<std::pair<float, float>> profile;
  for (std::uint32_t i = 0; i <= stacks; ++i) {
    const float a = std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(stacks);
    profile.emplace_back(i == 0 || i == stacks ? 0.f : radius * std::sin(a), -radius * std::cos(a));
  }
  return turned_body(profile, slices);
}

inline TestMesh closed_cylinder(std::uint32_t slices, float radius, float half_height) {
  return turned_body({{0, -half_height}, {radius, -half_height}, {radius, half_height}, {0, half_height}}, slices);
}

inline TestMesh closed_torus(std::uint32_t slices, std::uint32_t sides, float radius, float tube) {
  TestMesh mesh;
  for (std::uint32_t i = 0; i < slices; ++i) {
    for (std::uint32_t j = 0; j < sides; ++j) {
      const float u = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(slices);
      const float v = 2 * std::numbers::pi_v<float> * static_cast<float>(j) / static_cast<float>(sides);
      const float r = radius + tube * std::cos(v);
      mesh.positions.emplace_back(r * std::cos(u), tube * std::sin(v), -r * std::sin(u));
      const std::uint32_t next = (i + 1) % slices, up = (j + 1) % sides;
      const std::uint32_t a = i * sides + j, b = next * sides + j, c = i * sides + up, d = next * sides + up;
      mesh.indices.insert(mesh.indices.end(), {a, b, d, a, d, c});
    }
  }
  return mesh;
}

}  // namespace foredraw::testing

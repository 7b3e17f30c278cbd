#pragma once
// Meshes with a map of noise: rough in some places, flat in others.

#include "support/displaced.h"

#include <foredraw/base/random.h>
#include <foredraw/displaced/height_map.h>

#include <algorithm>
#include <cmath>

namespace foredraw::testing {

/// Hills of all widths from half the map to some texels; a third of it is 0.
inline std::vector<std::uint16_t> noise(std::uint32_t size, std::uint64_t seed) {
  std::vector<double> heights(std::size_t{size} * size, -0.4);
  Random random(seed);
  for (std::uint32_t hill = 0; hill < 200; ++hill) {
    const double width = size * 0.3 / (1 + 0.1 * hill), x0 = size * random.unit(), y0 = size * random.unit();
    const double rise = (random.unit() - 0.3) * 4 / (4 + 0.1 * hill);
    for (std::uint32_t y = 0; y < size; ++y) {
      for (std::uint32_t x = 0; x < size; ++x) {
        const double u = (x + 0.5 - x0) / width, v = (y + 0.5 - y0) / width, inside = 1 - u * u - v * v;
        if (inside > 0) heights[std::size_t{y} * size + x] += rise * inside * inside;
      }
    }
  }
  std::vector<std::uint16_t> texels;
  for (const double height : heights)
    texels.push_back(static_cast<std::uint16_t>(std::lround(65535 * std::clamp(height, 0.0, 1.0))));
  return texels;
}

inline Image noise_image(std::uint32_t size, std::uint64_t seed) {
  const std::vector<std::uint16_t> texels = noise(size, seed);
  return height_image(size, size, [&](std::uint32_t x, std::uint32_t y) { return texels[y * size + x]; });
}

/// A sphere whose triangles share no vertex; each has a place of its own on the map, turned by its number.
struct SeamedSphere {
  TestMesh mesh;
  std::vector<glm::vec2> uv;
};

inline SeamedSphere seamed_sphere(std::uint32_t slices, std::uint32_t stacks) {
  const TestMesh whole = sphere(slices, stacks);
  SeamedSphere made;
  Random random(11);
  for (std::size_t t = 0; t < whole.indices.size() / 3; ++t) {
    const float u = static_cast<float>(random.unit()), v = static_cast<float>(random.unit());
    const glm::vec2 corners[3] = {{u, v}, {u + 0.1f, v + 0.02f}, {u + 0.03f, v + 0.12f}};
    for (std::size_t c = 0; c < 3; ++c) {
      made.mesh.indices.push_back(static_cast<std::uint32_t>(made.mesh.positions.size()));
      made.mesh.positions.push_back(whole.positions[whole.indices[3 * t + c]]);
      made.uv.push_back(corners[(c + t) % 3]);
    }
  }
  return made;
}

/// What the technique is given of one draw.
struct NoisyMesh {
  TestMesh mesh;
  HeightMap map;
  std::vector<std::array<std::int32_t, 2>> places;
  foredraw_height_map sampled;

  NoisyMesh(TestMesh of, const std::vector<glm::vec2>& uv, HeightMap heights)
      : mesh(std::move(of)), map(std::move(heights)) {
    sampled = foredraw::sampled(map, {});
    for (const glm::vec2& at : uv)
      places.push_back({foredraw_height_place(at.x, map.width), foredraw_height_place(at.y, map.height)});
  }
  NoisyMesh(const NoisyMesh&) = delete;
};

inline std::vector<glm::vec2> square_uv(const TestMesh& grid, float columns, float rows) {
  std::vector<glm::vec2> uv;
  for (const glm::vec3& at : grid.positions) uv.emplace_back(at.x / columns, at.y / rows);
  return uv;
}

}  // namespace foredraw::testing

#pragma once
// A torus whose layout is cut into charts, of any size, and a map for it.

#include "support/displaced.h"

#include <foredraw/io/image/images.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <cstring>
#include <numbers>

namespace foredraw::testing {

/// A torus of squares in two triangles each, whose layout is cut into charts of so many squares along each edge.
struct ChartedTorus {
  std::uint32_t columns = 0, rows = 0;  ///< of charts
  std::uint32_t squares = 0;            ///< along an edge of a chart
};

/// About so many triangles, in six charts, as scans are laid out.
inline ChartedTorus torus_of(std::uint64_t triangles) {
  return {3, 2, static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(triangles) / 12)))};
}

/// The same in charts of 4,608 triangles: 1.4 per cent of its edges lie on seams.
inline ChartedTorus torus_of_small_charts(std::uint64_t triangles) {
  constexpr std::uint32_t squares = 48;
  const double charts = static_cast<double>(triangles) / (2.0 * squares * squares);
  const auto rows = static_cast<std::uint32_t>(std::lround(std::sqrt(charts / 1.25)));
  return {static_cast<std::uint32_t>(std::lround(charts / rows)), rows, squares};
}

inline constexpr float margin = 0.05f;  // around a chart, of its place in the map

/// Charts in a row of the map.
inline std::uint32_t charts_across(const ChartedTorus& torus) {
  return static_cast<std::uint32_t>(std::ceil(std::sqrt(torus.columns * torus.rows)));
}

/// Of all seams together, in texels.
inline double seam_length(const ChartedTorus& torus, std::uint32_t map) {
  return 2.0 * torus.columns * torus.rows * map * (1 - 2 * margin) / charts_across(torus);
}

/// Charts lie beside one another in the map, each somewhere else than its neighbours on the torus.
inline Scene scene_of(const ChartedTorus& torus, Image map) {
  const std::uint32_t charts = torus.columns * torus.rows, side = torus.squares + 1;
  const std::uint32_t across = charts_across(torus);
  constexpr float radius = 1, tube = 0.4f;
  TestMesh mesh;
  std::vector<glm::vec3> normals;
  std::vector<glm::vec2> uvs;
  const auto angle = [&](std::uint32_t at, std::uint32_t whole) {
    return 2 * std::numbers::pi_v<float> * static_cast<float>(at % whole) / static_cast<float>(whole);
  };
  for (std::uint32_t chart = 0; chart < charts; ++chart) {
    const auto base = static_cast<std::uint32_t>(mesh.positions.size());
    const auto place = static_cast<std::uint32_t>(std::uint64_t{chart} * 7919 % charts);
    for (std::uint32_t j = 0; j < side; ++j) {
      for (std::uint32_t i = 0; i < side; ++i) {
        const float u = angle(chart % torus.columns * torus.squares + i, torus.columns * torus.squares);
        const float v = angle(chart / torus.columns * torus.squares + j, torus.rows * torus.squares);
        normals.emplace_back(std::cos(v) * std::cos(u), -std::sin(v), std::cos(v) * std::sin(u));
        mesh.positions.push_back(radius * glm::vec3(std::cos(u), 0, std::sin(u)) + tube * normals.back());
        const glm::vec2 inside(static_cast<float>(i) / static_cast<float>(torus.squares),
                               static_cast<float>(j) / static_cast<float>(torus.squares));
        uvs.push_back((glm::vec2(place % across, place / across) + margin + (1 - 2 * margin) * inside) /
                      static_cast<float>(across));
      }
    }
    for (std::uint32_t j = 0; j + 1 < side; ++j) {
      for (std::uint32_t i = 0; i + 1 < side; ++i) {
        const std::uint32_t a = base + j * side + i, b = a + 1, c = a + side, d = c + 1;
        mesh.indices.insert(mesh.indices.end(), {a, b, c, c, b, d});
      }
    }
  }
  Scene scene = displaced_scene(mesh, uvs, std::move(map), 0.02f);
  VertexStreams vertices = *scene.draws[0].full().vertices;
  vertices.base.push_back(float_stream("NORMAL", normals));
  scene.draws[0].full().vertices = std::make_shared<const VertexStreams>(std::move(vertices));
  return scene;
}

/// As a file has it: a PNG of 16 bits, with hills that repeat.
inline Image png_map(std::uint32_t size) {
  Texels texels{{size, size, 1, 16}, {}};
  texels.bytes.resize(2 * std::size_t{size} * size);
  for (std::uint32_t y = 0; y < size; ++y) {
    for (std::uint32_t x = 0; x < size; ++x) {
      const auto height = static_cast<std::uint16_t>(32768 + 8 * ((x ^ y) % 2048) - 4 * (y % 1024));
      std::memcpy(&texels.bytes[2 * (std::size_t{y} * size + x)], &height, 2);
    }
  }
  Image image{.name = "heights", .media_type = "image/png", .bytes = Shared(encode_png(texels))};
  image.facts = texels.facts;
  return image;
}

}  // namespace foredraw::testing

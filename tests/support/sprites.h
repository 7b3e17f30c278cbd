#pragma once
// Sprites on disk and in memory, and polygons in the place of their quads.

#include <foredraw/scene/scene.h>

#include "support/image_builder.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <vector>

namespace foredraw::testing {

inline void put_bytes(const std::filesystem::path& path, const std::vector<std::byte>& bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

/// Discs side by side, each as wide as the image is high: opaque within, clear without. Four channels.
inline std::vector<std::uint16_t> discs(std::uint32_t width, std::uint32_t height) {
  std::vector<std::uint16_t> values;
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      const double u = (x % height + 0.5) / height * 2 - 1, v = (y + 0.5) / height * 2 - 1;
      const bool is_in = u * u + v * v < 0.81;
      for (const int value : {230, 120 + static_cast<int>(60 * v), 60, is_in ? 255 : 0}) {
        values.push_back(static_cast<std::uint16_t>(value));
      }
    }
  }
  return values;
}

inline std::vector<std::byte> disc_png(std::uint32_t width, std::uint32_t height) {
  return png_of({width, height, 4, 8}, discs(width, height));
}

template <class T>
Shared<std::byte> shared_bytes(const std::vector<T>& values) {
  const auto bytes = std::as_bytes(std::span(values));
  return Shared<std::byte>({bytes.begin(), bytes.end()});
}

/// A regular polygon in the place of the draw's quad: as wide and high as the quad times `reach`, corners
/// counter-clockwise, cut into a fan. The plane and the image stay where they are.
inline void trim(Draw& draw, int corners, float reach = 0.95f) {
  const VertexStreams& quad = *draw.levels[0].vertices;
  const std::vector<glm::vec3> p = decode_vec3(*quad.find("POSITION")), t = decode_vec3(*quad.find("TEXCOORD_0"));
  std::vector<glm::vec3> positions;
  std::vector<glm::vec2> texcoords;
  for (int i = 0; i < corners; ++i) {
    const double angle = 6.283185307179586 * i / corners;
    const float a = 0.5f + 0.5f * reach * static_cast<float>(std::cos(angle));
    const float b = 0.5f + 0.5f * reach * static_cast<float>(std::sin(angle));
    positions.push_back(p[0] + a * (p[1] - p[0]) + b * (p[3] - p[0]));
    texcoords.emplace_back(t[0] + a * (t[1] - t[0]) + b * (t[3] - t[0]));
  }
  std::vector<std::uint32_t> indices;
  for (std::uint32_t i = 2; i < static_cast<std::uint32_t>(corners); ++i) {
    for (const std::uint32_t corner : {0u, i - 1, i}) indices.push_back(corner);
  }
  VertexStreams streams = quad;
  streams.count = static_cast<std::uint32_t>(corners);
  streams.base[0].bytes = shared_bytes(positions);
  streams.base[1].bytes = shared_bytes(texcoords);
  draw.levels[0].vertices = std::make_shared<const VertexStreams>(std::move(streams));
  draw.levels[0].orders[0].indices = Shared<std::uint32_t>(std::move(indices));
  draw.traits.add(traits::trimmed);
}

}  // namespace foredraw::testing

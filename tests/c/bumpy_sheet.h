#pragma once
// A sheet with bumps that hide one another, in an interleaved buffer with indices of 16 bits.

#include <foredraw/c/mesh.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace foredraw::testing {

struct BumpySheet {
  struct Vertex {
    std::uint32_t colour;
    float position[3];
  };
  enum Corners { shared, own_corners };

  /// Of cells x cells squares. `own_corners`: no triangle shares a vertex.
  explicit BumpySheet(std::uint32_t cells, Corners corners = shared) {
    const std::uint32_t points = cells + 1;
    for (std::uint32_t i = 0; i < points * points; ++i) {
      const std::uint32_t x = i % points, y = i / points;
      const float height = static_cast<float>((x * 7 + y * 5) % 11 + (x / 4 + y / 4) % 2 * 9);
      vertices.push_back({i % 3, {static_cast<float>(x), height * 0.3f, static_cast<float>(y)}});
    }
    for (std::uint32_t y = 0; y < cells; ++y) {
      for (std::uint32_t x = 0; x < cells; ++x) {
        const std::uint32_t a = y * points + x;
        for (const std::uint32_t corner : {a, a + points, a + 1, a + 1, a + points, a + points + 1}) {
          indices.push_back(static_cast<std::uint16_t>(corner));
        }
      }
    }
    if (corners == shared) return;
    std::vector<Vertex> own;
    for (std::uint16_t& index : indices) {
      own.push_back(vertices[index]);
      index = static_cast<std::uint16_t>(own.size() - 1);
    }
    vertices = own;
  }

  foredraw_triangles triangles() const {
    return {indices.data(), indices.size(), sizeof(std::uint16_t), static_cast<std::uint32_t>(vertices.size())};
  }
  foredraw_positions positions() const { return {vertices[0].position, sizeof(Vertex)}; }
  std::vector<glm::vec3> places() const {
    std::vector<glm::vec3> all;
    for (const Vertex& vertex : vertices) all.push_back({vertex.position[0], vertex.position[1], vertex.position[2]});
    return all;
  }

  std::vector<Vertex> vertices;
  std::vector<std::uint16_t> indices;
};

}  // namespace foredraw::testing

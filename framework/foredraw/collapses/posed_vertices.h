#pragma once
// How poses move the vertices of a mesh.

#include <glm/mat4x3.hpp>

#include <cstdint>
#include <vector>

namespace foredraw {

/// A mesh in a few poses. Vertices are moved by affine maps: a position x comes to lie at map * (x, 1).
struct PosedVertices {
  std::vector<double> weights;     ///< [pose] how much it counts; of sum 1
  std::vector<glm::dmat4x3> maps;  ///< [vertex * poses + pose]; finite

  std::size_t poses() const { return weights.size(); }
  const glm::dmat4x3* of(std::uint32_t vertex) const { return maps.data() + vertex * poses(); }
};

}  // namespace foredraw

#pragma once
// What is drawn: the triangles of a subject, ready for every view.

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// The triangles of one draw call, in the order in which they are drawn. Front faces turn counter-clockwise.
struct RasterPart {
  std::span<const glm::vec3> positions;
  std::span<const std::uint32_t> indices;  ///< three a triangle, each below the number of positions
  bool culls_back_faces = true;
  bool is_mirrored = false;  ///< positions were moved by a transform that turns front faces clockwise
};

/// A part as every view draws it.
struct PreparedPart {
  struct Triangle {
    std::array<std::uint32_t, 3> corners;
    std::uint32_t number;  ///< counted through all parts, those that cover nothing too
  };

  std::vector<glm::dvec3> positions;  ///< in radii from the centre of the sphere around all parts
  std::vector<Triangle> triangles;    ///< those that may cover something: three corners, all of them finite
  bool culls_back_faces = true;
  bool is_mirrored = false;
};

/// All parts, in one bounding sphere. O(positions + triangles).
std::vector<PreparedPart> prepared(std::span<const RasterPart> parts);

}  // namespace foredraw

#pragma once
// What is drawn: the triangles of a subject, ready for every view.

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace foredraw {

struct Mask;

/// The triangles of one draw call, in the order in which they are drawn. Front faces turn counter-clockwise.
struct RasterPart {
  std::span<const glm::vec3> positions;
  std::span<const std::uint32_t> indices;  ///< three a triangle, each below the number of positions
  bool culls_back_faces = true;
  bool is_mirrored = false;                    ///< positions were moved by a transform that turns front faces clockwise
  std::shared_ptr<const Mask> mask = nullptr;  ///< of its vertices; none: the surface has no holes
  /// [triangle] which triangle of the draw it belongs to, where a triangle of the draw is shown as several; rising.
  std::span<const std::uint32_t> owners = {};
  std::size_t owner_count = 0;  ///< the draw's triangles, where there are owners

  /// Of the draw. Whoever counts fragments, counts them for these.
  std::size_t triangle_count() const { return owners.empty() ? indices.size() / 3 : owner_count; }
};

/// A part as every view draws it: number after number, as vector registers take them, and padded with places in the
/// centre and triangles without area, so that whole registers always do.
struct PreparedPart {
  static constexpr std::size_t padding = 16;

  std::array<std::vector<double>, 3> positions;       ///< [axis][vertex], in radii from the centre of the sphere
  std::array<std::vector<std::uint32_t>, 3> corners;  ///< [corner][triangle], front faces counter-clockwise; those left
                                                      ///< that may cover something: three corners, all of them finite
  std::vector<std::uint32_t>
      numbers;               ///< [triangle] of its owner, counted through all parts, those that cover nothing too
  std::uint32_t behind = 0;  ///< added to the number of a triangle that is drawn from behind
  bool culls_back_faces = true;
  std::shared_ptr<const Mask> mask;

  std::uint32_t number(std::size_t triangle, bool from_behind) const {
    return numbers[triangle] + (from_behind ? behind : 0);
  }
  glm::dvec3 position(std::size_t vertex) const {
    return {positions[0][vertex], positions[1][vertex], positions[2][vertex]};
  }
  std::size_t vertex_count() const { return positions[0].size(); }  ///< with padding
  std::size_t triangle_count() const { return numbers.size(); }     ///< with padding
};

/// All parts, in one bounding sphere. O(positions + triangles).
std::vector<PreparedPart> prepared(std::span<const RasterPart> parts);

}  // namespace foredraw

#pragma once
// Which layout of 128 bits is the best for vertices of a kind.

#include <foredraw/geometry/box.h>
#include <foredraw/packing/packed_vertices.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <limits>
#include <optional>

namespace foredraw::processors::vertex_pack {

/// No layout that is chosen has more for u or v.
inline constexpr std::uint32_t most_uv_bits = 20;

/// What is packed, and what matters of it.
struct Demand {
  Box<glm::dvec3> box;  ///< of all positions, finite
  bool normals = false, tangents = false, uvs = false;
  glm::dvec2 uv_extent{0};       ///< the largest one of the draws that share the layout
  double displacement = 0;       ///< A: the largest displacement along the normal, in units of positions
  double slope = 0;              ///< G: the largest slope of its height, in units of positions for 1 of uv
  double most_angle_error = 90;  ///< of normals, and of tangents at right angles to them; degrees
  double most_uv_error = 1e30;   ///< of u and v each, where the extent is the largest one
  bool is_spherical = false;
};

/// The layout, with the lattice of positions, that moves a displaced point the least: E = |dp| + A |dn| + G |duv| from
/// the bounds of packed_bounds(), over all numbers of bits for which fields find room without crossing a word, and
/// which keep the limits of directions and texture coordinates. Of equal ones the one with fewer bits for normals, then
/// for u and v. The tangent gets what is left of its word. Nothing where there is none. Texture coordinates get their
/// lattice from set_uv_lattice(); until then it is that of 0 to the demanded extent.
std::optional<PackedLayout> best_layout(const Demand& demand);

/// The lattice of texture coordinates from `least` to `most`: steps of any size, as fine as the bits allow. False where
/// floats can not hold it.
bool set_uv_lattice(PackedLayout& layout, const glm::dvec2& least, const glm::dvec2& most);

}  // namespace foredraw::processors::vertex_pack

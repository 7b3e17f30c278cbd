#pragma once
// Texture coordinates as small whole numbers, which KHR_texture_transform of the materials' textures scales back.

#include <foredraw/scene/vertex_groups.h>

#include <memory>
#include <span>
#include <vector>

namespace foredraw {

/// Of a set of texture coordinates: multiples of a step, the same along u and v, stored as unsigned numbers.
struct TexcoordGrid {
  std::uint32_t set = 0;  ///< TEXCOORD_n
  double step = 1;        ///< of 6 significant bits
  glm::dvec2 first{0};    ///< of u and v the multiple that is stored as 0
  bool is_wide = false;   ///< 16 bits each, else 8

  ScaledTexcoords scaled() const { return {set, first * step, glm::dvec2(step)}; }
};

/// What is to become whole numbers. Lists of grids are by set.
struct IntegerTexcoords {
  std::vector<std::vector<TexcoordGrid>> of_groups;     ///< [group]
  std::vector<std::vector<TexcoordGrid>> of_materials;  ///< [material of the scene]
};

/// The coarsest grids on which coordinates are at most `tolerance` off, as points; no grids where it is not above 0.
/// `groups`: whose vertices may change. Draws of one material have one grid, as do draws of the same vertices; all that
/// hang together so stay where one of these holds:
/// - a level of a draw may not change, lacks the set, has no floats for it, some that are not finite, or morph targets;
/// - a draw has no material, or one of which the file keeps the spaces, or does not tell that it looks the set up:
///   nobody would scale back;
/// - 16 bits do not hold it, or it lies so far from 0 that a shader's floats would round offset + step * number.
/// Where the scene has products, which may hold coordinates, all stay.
IntegerTexcoords find_integer_texcoords(const Scene& scene, std::span<const VertexGroup> groups, double tolerance);

struct IntegerVertices {
  std::shared_ptr<const VertexStreams> vertices;  ///< as many, in the same sequence
  double largest = 0;  ///< distance by which a coordinate is off, as a shader's floats have it
};

/// The streams with the sets of these grids as whole numbers.
IntegerVertices with_integer_texcoords(const VertexStreams& vertices, std::span<const TexcoordGrid> grids);

/// The materials with all that their textures need of the new coordinates.
void scale_textures(std::vector<Material>& materials, const IntegerTexcoords& planned);

}  // namespace foredraw

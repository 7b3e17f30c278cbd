#pragma once
// A mesh whose triangles are divided as a tessellator divides them.

#include <foredraw/displaced/tessellation_pattern.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace foredraw {

/// A place on a mesh.
struct SurfaceSample {
  std::uint32_t triangle = 0;
  TessellationPoint at;  ///< by the weights of its corners
  friend bool operator==(const SurfaceSample&, const SurfaceSample&) = default;
};

struct TessellatedMesh {
  std::uint32_t kept = 0;              ///< vertices of the source: they are the first ones, with the numbers they had
  std::vector<SurfaceSample> samples;  ///< where vertex `kept` + i lies on the source
  std::vector<std::uint32_t> indices;  ///< the triangles of the source's first triangle, those of its second, ...

  std::size_t vertices() const { return kept + samples.size(); }
};

/// [triangle] `levels`, whose outer level e is of the edge from corner (e + 1) % 3 to (e + 2) % 3, as in shaders.
///
/// An edge is known by the numbers of its two vertices. All triangles that share it have to give it the same
/// effective_level(); to get it, compute levels from the two vertices alone, and treat both alike. Points on it are
/// made once, by the first triangle, so that the mesh has no cracks where the source has none. Vertices at the same
/// position with different numbers, as along seams of textures, are different here; give their edges the same levels,
/// and the points on both sides lie in the same places. Triangles with an outer level of 0 are left out, as a
/// tessellator leaves them out. With levels of 1 and equal or fractional odd spacing the indices stay as they are.
///
/// Throws std::invalid_argument where there are not three indices for each of `levels`, an index is not below
/// `vertices`, or triangles do not agree on an edge; std::length_error where vertices could not be numbered in 32 bits.
/// Whoever wants to know beforehand how much there will be sums up tessellation_counts().
///
/// O(triangles), but for edges of one vertex, which are sorted. Memory beside the result: 40 bytes for each triangle of
/// the source, and at most 100 MB of patterns.
TessellatedMesh tessellated_mesh(std::span<const std::uint32_t> indices, std::uint32_t vertices,
                                 std::span<const TessellationLevels> levels, TessellationSpacing spacing);

/// The edge e of a triangle t is called 3t + e.
struct LevelDisagreement {
  std::size_t edge = 0, other = 0;  ///< the other one comes first in the mesh
};

/// The first edge that has another effective_level() in an earlier triangle; none: tessellated_mesh() takes the levels.
/// With indices of welded() vertices in place of the mesh's own, seams are asked too. Throws std::invalid_argument as
/// tessellated_mesh() does.
std::optional<LevelDisagreement> level_disagreement(std::span<const std::uint32_t> indices, std::uint32_t vertices,
                                                    std::span<const TessellationLevels> levels,
                                                    TessellationSpacing spacing);

}  // namespace foredraw

#pragma once
// Levels of detail of a divided mesh: each with half as many parts to an edge as the one before.

#include <foredraw/displaced/tessellated_mesh.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace foredraw {

/// [triangle] Half of each level, and 1 at least: what two triangles agree on, they still agree on.
std::vector<TessellationLevels> halved(std::span<const TessellationLevels> levels);

/// The triangles of `coarse` by the vertices of `fine`: both are tessellated_mesh() of one source. None where a point
/// of the coarse one is no point of the fine one. Levels that are powers of two, halved any number of times, have all
/// their points among those before, with equal spacing. O(n log n).
std::optional<std::vector<std::uint32_t>> by_vertices_of(const TessellatedMesh& fine, const TessellatedMesh& coarse);

}  // namespace foredraw

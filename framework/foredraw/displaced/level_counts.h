#pragma once
// How many triangles levels make, and of which.

#include <foredraw/displaced/tessellation_pattern.h>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// Of all triangles together. `levels`: [triangle]
std::uint64_t count_triangles(std::span<const TessellationLevels> levels, TessellationSpacing spacing);

/// [triangle of tessellated_mesh() by these levels] the one that it lies on; rising.
std::vector<std::uint32_t> sources_of(std::span<const TessellationLevels> levels, TessellationSpacing spacing);

}  // namespace foredraw

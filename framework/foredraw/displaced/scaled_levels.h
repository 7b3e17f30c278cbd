#pragma once
// Levels that a stage stored, for the tessellator.

#include <foredraw/displaced/tessellation_levels.h>
#include <foredraw/displaced/tessellation_pattern.h>

#include <cstdint>
#include <vector>

namespace foredraw {

/// [triangle] With `scale` taken from the power of two of each, but not below 0.
std::vector<TessellationLevels> scaled_levels(const DrawTessellation& stored, std::uint32_t scale);

}  // namespace foredraw

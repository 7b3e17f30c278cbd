#pragma once
// Levels as bytes: powers of two alone.

#include <foredraw/displaced/tessellation_levels.h>
#include <foredraw/displaced/tessellation_pattern.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// [triangle] levels of a triangle list by one number each, log2 of the level inside. An edge has the finest level of
/// the triangles that lie at it, so that both sides of a seam agree.
std::vector<TessellationLevels> baked_levels(std::span<const std::uint8_t> logs, std::span<const std::uint32_t> indices,
                                             std::span<const glm::vec3> positions);

}  // namespace foredraw

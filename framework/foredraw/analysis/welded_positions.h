#pragma once
// Vertices at the same position are one, whatever else they have.

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// [vertex] the first one at the same position, bit by bit; of the two zeros one. O(n log n).
std::vector<std::uint32_t> welded(std::span<const glm::vec3> positions);

}  // namespace foredraw

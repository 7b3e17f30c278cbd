#pragma once
// Which triangles bound a body, so that nobody outside sees their backs.

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// [triangle] whether it belongs to a closed component that faces outwards: vertices are welded by their positions, bit
/// by bit; every edge is used as often one way as the other; and the volume that the component bounds is above 0. It
/// says nothing of components that pass through themselves, nor of other poses: a picture has the last word.
/// O(n log n).
std::vector<bool> closed_outwards(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices);

}  // namespace foredraw

#pragma once
#include <glm/vec2.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace foredraw::processors::particle_trim {

/// A convex polygon cut into triangles whose inner edges are as short as can be in all: graphics processors shade in
/// blocks of 2 x 2 pixels, and those that such an edge crosses are shaded twice. Numbers of corners, in their
/// direction. O(corners^3) by dynamic programming (Klincsek 1980).
std::vector<std::array<std::uint32_t, 3>> fewest_inner_edges(std::span<const glm::dvec2> corners);

}  // namespace foredraw::processors::particle_trim

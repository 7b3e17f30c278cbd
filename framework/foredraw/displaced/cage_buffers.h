#pragma once
// What the shaders of a displaced surface read of its cage.

#include <foredraw/runtime/displaced_cage.h>
#include <foredraw/scene/vertex_streams.h>

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// [vertex] `directions`: displacement_directions(); `places`: height_places(). Throws std::invalid_argument where
/// there are not as many of each.
std::vector<foredraw_cage_vertex> cage_vertices(std::span<const glm::vec3> positions,
                                                std::span<const glm::vec3> directions,
                                                std::span<const std::array<std::int32_t, 2>> places);

/// [vertex] The four largest influences, over their sum; of equal weights the smaller joint. Joints that are not below
/// `joints` move nothing. A vertex that none moves gets joint number `joints`: in glTF it stays with its node, whose
/// map comes behind those of the joints.
std::vector<foredraw_cage_skin> cage_skin(const VertexStreams& vertices, std::uint32_t joints);

}  // namespace foredraw

#pragma once
// A draw as its map of heights moves it.

#include <foredraw/displaced/baked_heights.h>
#include <foredraw/displaced/height_map.h>
#include <foredraw/displaced/tessellated_mesh.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// What a tessellated mesh looks up in a map: [vertex] of the result, by how much it moves along its direction, in
/// units at rest. `places`: [vertex of the source] height_places().
std::vector<float> displacements(const TessellatedMesh& mesh, std::span<const std::uint32_t> source,
                                 std::span<const std::array<std::int32_t, 2>> places, const foredraw_height_map& map,
                                 float factor, float offset);

/// The same of heights that are stored: offset + factor * height / (2^bits - 1). `bits`: 1 to 16.
std::vector<float> height_displacements(std::span<const std::uint16_t> heights, std::uint32_t bits, float factor,
                                        float offset);

/// The mesh of baked heights.
TessellatedMesh tessellated_mesh(const DrawHeights& heights, const Level& level);

/// [vertex] of the result, in the pose that positions and directions ([vertex of the source]) are in: as
/// foredraw_displaced_point() has them.
std::vector<glm::vec3> displaced_positions(const TessellatedMesh& mesh, std::span<const std::uint32_t> source,
                                           std::span<const glm::vec3> positions, std::span<const glm::vec3> directions,
                                           std::span<const float> displacements);

/// The least at which `displacement-seams` makes both sides of a seam equal.
inline constexpr double usual_texels_per_part = 1.5;

/// [triangle] Levels as fine as the map: the largest power of two of parts to an edge, each at least so many texels
/// long, up to 64; of the two sides of a seam the coarser one's. `positions`: the source's. Inside, as the finest edge.
std::vector<TessellationLevels> levels_by_texels(std::span<const std::uint32_t> source,
                                                 std::span<const glm::vec3> positions,
                                                 std::span<const std::array<std::int32_t, 2>> places,
                                                 double texels_per_part);

/// [3t + e] first_edges() of edges known by where they lie, and not by their vertices' numbers: both sides of a seam
/// are one.
std::vector<std::uint32_t> edges_at_places(std::span<const std::uint32_t> source, std::span<const glm::vec3> positions);

}  // namespace foredraw

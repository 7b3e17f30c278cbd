#pragma once
#include <foredraw/analysis/analyses.h>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// [vertex] the first vertex with the same bytes in every stream and morph target; itself where there is none before.
/// O(vertices).
std::vector<std::uint32_t> first_of_equals(const VertexStreams& vertices);

/// How many of the vertices that the indices name are equal to another one that they name, and could be left out.
std::size_t count_equal_vertices(const VertexStreams& vertices, std::span<const std::uint32_t> indices,
                                 Analyses& analyses);

}  // namespace foredraw

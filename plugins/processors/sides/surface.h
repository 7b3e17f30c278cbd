#pragma once
// How the triangles of a draw hang together: what touches what, and where one sees behind them.

#include "sides.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw::processors::sides {

/// A draw's triangles over vertices that are welded by their positions, bit by bit.
struct Surface {
  std::vector<std::uint32_t> indices;    ///< of welded vertices
  std::vector<bool> is_closed;           ///< [triangle] closed_outwards()
  std::vector<std::uint32_t> component;  ///< [triangle] numbers from 0 on

  std::vector<std::uint32_t> at_vertex;  ///< triangles, vertex by vertex
  std::vector<std::uint32_t> first_at;   ///< [vertex] its first place in at_vertex; and the end

  /// A triangle's edge.
  struct Edge {
    std::uint32_t low = 0, high = 0;  ///< welded vertices
    std::int32_t way = 0;             ///< 1 where the triangle runs from low to high, else -1
    std::uint32_t triangle = 0;
  };
  std::vector<Edge> edges;  ///< sorted by their vertices: those of neighbours stand together

  /// An edge that is used more often one way than the other: there the surface ends.
  struct Rim {
    std::uint32_t low = 0, high = 0;  ///< welded vertices
    std::uint32_t opening = 0;        ///< rims that hang together have the same number
  };
  std::vector<Rim> rims;                     ///< component by component, opening by opening
  std::vector<std::uint32_t> first_rim;      ///< [component] its first place in rims; and the end
  std::vector<std::uint32_t> first_of_hole;  ///< [opening] its first place in rims; and the end

  std::span<const std::uint32_t> around(std::uint32_t vertex) const {
    return std::span(at_vertex).subspan(first_at[vertex], first_at[vertex + 1] - first_at[vertex]);
  }
  std::span<const Rim> rims_of(std::uint32_t of) const {
    return std::span(rims).subspan(first_rim[of], first_rim[of + 1] - first_rim[of]);
  }
  std::span<const Rim> opening(std::uint32_t number) const {
    return std::span(rims).subspan(first_of_hole[number], first_of_hole[number + 1] - first_of_hole[number]);
  }
};

/// O(n log n).
Surface surface_of(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices);

/// Adds to each triangle's sides ([triangle]) those of its neighbours, which share an edge with it.
void add_neighbours(const Surface& surface, std::span<Side> sides);

/// Makes each triangle's value ([triangle]) the mean of its own and those of its neighbours.
void smooth(const Surface& surface, std::span<double> values);

/// Adds both sides of each triangle that has an edge where the surface ends.
void add_rims(const Surface& surface, std::span<Side> sides);

}  // namespace foredraw::processors::sides

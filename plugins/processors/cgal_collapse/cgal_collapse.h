#pragma once
// The edge collapse of CGAL. Lindstrom, Turk: Fast and Memory Efficient Polygonal Simplification, Visualization 1998;
// Garland, Heckbert: Surface Simplification Using Quadric Error Metrics, SIGGRAPH 1997.

#include <foredraw/collapses/collapse_sequence.h>

#include <glm/vec3.hpp>

#include <atomic>
#include <span>

namespace foredraw {

enum class CgalCost {
  lindstrom_turk,    ///< volumes and areas of today's triangles
  garland_heckbert,  ///< squared distances from the planes of all triangles that ever were
};

struct CgalCollapseOptions {
  CgalCost cost = CgalCost::lindstrom_turk;
  bool keep_sides = true;                     ///< refuse what turns a triangle by more than 90 degrees
  std::size_t least = 0;                      ///< triangles to stop at
  const std::atomic<bool>* cancel = nullptr;  ///< once it is true the sequence ends
};

/// The collapses, cheapest first, until no more than `least` triangles are left or no edge may go. `indices` holds
/// three a triangle, each below the number of positions; any triangles will do. Where they are no manifold, points
/// stay.
CollapseSequence cgal_collapse(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                               const CgalCollapseOptions& options = {});

struct Plugin;
Plugin cgal_collapse_plugin();

}  // namespace foredraw

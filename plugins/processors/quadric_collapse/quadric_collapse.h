#pragma once
// Quadric collapse: a mesh made coarser edge by edge, the one that costs least first. Sources: Hoppe, Progressive
// Meshes, SIGGRAPH 1996 (the sequence); Garland, Heckbert 1997 (quadrics); Lindstrom, Turk 1998 (memoryless cost, the
// volume kept); Hoppe 1999 (attributes).

#include <foredraw/base/parallel.h>
#include <foredraw/collapses/attribute_rows.h>
#include <foredraw/collapses/collapse_sequence.h>
#include <foredraw/collapses/posed_vertices.h>

#include <glm/vec3.hpp>

#include <atomic>
#include <span>

namespace foredraw {

enum class CollapsePlacement {
  optimal,   ///< where the cost is least
  endpoint,  ///< at one of the two points, so that all levels share one vertex buffer
};

struct QuadricCollapseOptions {
  CollapsePlacement placement = CollapsePlacement::optimal;
  double memory = 0.1;     ///< weight of the planes of all faces that ever were, beside those of today's faces; 0 to 1
  double deviation = 0.3;  ///< weight of how far the surface moves, beside distances from planes; 0 to 1
  double border = 10;      ///< weight of borders: planes upright on the faces beside them
  double seam = 3;         ///< weight of seams
  double parts = 0.02;     ///< whole pieces go whose diagonal is at most this share of the mesh's; 0 to 1
  double poses = 1;        ///< weight of the surface in poses, beside the one at rest
  std::size_t least = 0;   ///< triangles to stop at
  /// What vertices carry that come to lie at neither of both places is solved for beside the place; false: it is
  /// blended along the edge. Of endpoint placement it is one of both.
  bool solves = true;
  const std::atomic<bool>* cancel = nullptr;  ///< once it is true the sequence ends
  const Executor* executor = nullptr;         ///< for large meshes; the sequence is the same without
};

/// The collapses, cheapest first, until no more than `least` triangles are left or no edge may go. `indices` holds
/// three a triangle, each below the number of positions; any triangles will do. `attributes` of the vertices count
/// beside distances. `stream[vertex]` says which vertices may take each other's place; none: all may. In the poses of
/// `posed`, if any, distances count like those at rest; vertices at one place should move alike.
CollapseSequence quadric_collapse(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                                  const QuadricCollapseOptions& options = {}, AttributeRows attributes = {},
                                  std::span<const std::uint32_t> stream = {}, const PosedVertices& posed = {});

struct Plugin;
Plugin quadric_collapse_plugin();

}  // namespace foredraw

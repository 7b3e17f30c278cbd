#pragma once
// A mesh made coarser edge by edge, by the energy of what is left. Hoppe: Progressive Meshes, SIGGRAPH 1996, section 4;
// the fit of positions after Hoppe, DeRose, Duchamp, McDonald, Stuetzle: Mesh Optimization, SIGGRAPH 1993.

#include <foredraw/collapses/collapse_sequence.h>

#include <glm/vec3.hpp>

#include <atomic>
#include <span>

namespace foredraw {

struct EnergyCollapseOptions {
  double distance = 1;                        ///< weight of Edist: squared distances of points of the original surface
  double spring = 1;                          ///< weight of Espring: squared lengths of edges, by factors that fall
  double scalar = 1e-6;                       ///< weight of Escalar: squared differences of attributes at those points
  double discontinuity = 1;                   ///< weight of Edisc: squared distances of points of borders and seams
  std::uint32_t samples = 8;                  ///< points for each triangle of the original, 1 to 100
  std::uint32_t rounds = 3;                   ///< times that points are projected and the place is solved for, 0 to 20
  std::uint64_t seed = 0;                     ///< of the points
  std::size_t least = 0;                      ///< triangles to stop at
  const std::atomic<bool>* cancel = nullptr;  ///< once it is true the sequence ends
};

/// Numbers of vertices that are blended: [vertex * width]. Differences of 1 are large.
struct VertexScalars {
  std::span<const float> values;
  std::size_t width = 0;
};

/// The collapses, the one that adds the least energy first, until no more than `least` triangles are left or no edge
/// may go. Distances are measured in box diagonals. `indices` holds three a triangle, each below the number of
/// positions; any triangles will do. Slow: about a millisecond for each edge that is looked at.
CollapseSequence energy_collapse(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                                 const VertexScalars& scalars = {}, const EnergyCollapseOptions& options = {});

struct Plugin;
Plugin energy_collapse_plugin();

}  // namespace foredraw

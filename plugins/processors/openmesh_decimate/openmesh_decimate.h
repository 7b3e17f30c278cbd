#pragma once
// The decimater of OpenMesh: quadrics that are never forgotten, joined points at one of the two. Garland, Heckbert:
// Surface Simplification Using Quadric Error Metrics, SIGGRAPH 1997; Botsch, Steinberg, Bischoff, Kobbelt: OpenMesh, a
// generic and efficient polygon mesh data structure, OpenSG Symposium 2002.

#include <foredraw/collapses/collapse_sequence.h>

#include <glm/vec3.hpp>

#include <atomic>
#include <optional>
#include <span>

namespace foredraw {

/// What is not set allows everything.
struct OpenmeshDecimateOptions {
  double normal_flipping = 90;             ///< degrees that a triangle may turn in one collapse; 180: any
  std::optional<double> normal_deviation;  ///< degrees across the cone of all normals that a triangle stands for
  std::optional<double> aspect_ratio;      ///< longest side over height; worse triangles may only become better
  std::optional<double> roundness;         ///< from 0 to 1, which an equilateral triangle has
  std::optional<double> edge_length;       ///< longest edge that may collapse, as a share of the box's diagonal
  std::optional<double> hausdorff;  ///< farthest that original points come to lie, as a share of the box's diagonal
  std::size_t least = 0;            ///< triangles to stop at
  const std::atomic<bool>* cancel = nullptr;  ///< once it is true the sequence ends
};

/// The collapses, cheapest first, until no more than `least` triangles are left or no edge may go. `indices` holds
/// three a triangle, each below the number of positions; any triangles will do. Where they are no manifold, points
/// stay. `normal_deviation` asks libm for angles: its answers may differ between processors.
CollapseSequence openmesh_decimate(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                                   const OpenmeshDecimateOptions& options = {});

struct Plugin;
Plugin openmesh_decimate_plugin();

}  // namespace foredraw

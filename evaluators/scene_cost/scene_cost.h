#pragma once
// What a frame costs that draws all of a scene, counted from the scene alone.

#include <foredraw/base/parallel.h>
#include <foredraw/scene/scene.h>

#include <cstdint>

namespace foredraw {

struct SceneCostOptions {
  int cache_size = 16;  ///< entries of the FIFO that vertices are shaded with, 3 to 65535
};

struct SceneCost {
  std::uint64_t draws = 0;      ///< draw calls, of an engine that batches nothing by itself
  std::uint64_t instances = 0;  ///< placed primitives: a primitive counts as often as it is seen
  std::uint64_t indices = 0;    ///< read by all draw calls
  double shaded = 0;            ///< vertices that miss the cache; whole, but where a draw has several orders

  double triangles_shaded = 0;  ///< of these, those of triangle lists
  std::uint64_t triangles = 0;

  // Bytes that the draw calls refer to. A stream counts once, however many share it.
  std::uint64_t vertex_bytes = 0;    ///< morph targets too
  std::uint64_t index_bytes = 0;     ///< two an index where the draw has fewer than 65,536 vertices, else four
  std::uint64_t instance_bytes = 0;  ///< 48 for each placed mesh: a 3 x 4 matrix of floats

  /// Draw calls if primitives of equal content and of the same material were drawn by instancing, one call for each.
  /// Mirrored ones wind the other way and have a call of their own; what is skinned, bends by weights of its own node
  /// or is blended (its order counts) stays by itself.
  std::uint64_t draws_if_instanced = 0;
};

/// Nodes place meshes. A scene without nodes shows each of its meshes once. What has no indices draws nothing and costs
/// nothing. O(nodes + instances + indices), the draws shared out over the threads.
SceneCost scene_cost(const Scene& scene, const SceneCostOptions& options, const Executor& executor);
SceneCost scene_cost(const Scene& scene, const SceneCostOptions& options = {});

struct Plugin;
Plugin scene_cost_plugin();

}  // namespace foredraw

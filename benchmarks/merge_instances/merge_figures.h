#pragma once
// What merging a scene comes to, and the time it takes.

#include <plugins/processors/merge_instances/merge_scene.h>

#include <string>

namespace foredraw::bench {

struct MergeFigures {
  std::size_t sets = 0;
  std::size_t groups = 0;
  std::string frequencies;  ///< of each set: "90+1131"
  double padding = 0;       ///< padded index entries, of all that are drawn
  double slot_bytes = 0;    ///< for each placed primitive that is merged
  std::size_t merged = 0;   ///< placed primitives
  double milliseconds = 0;  ///< all of merge_scene(): the median
  double packing = 0;       ///< of that, pack_instances(), milliseconds: the median
};

/// Pushes the merged draws of all that the scene shows onto Scene::merged.
MergeFigures merge(Scene& scene, const MergeSceneOptions& options, int threads, int rounds);

}  // namespace foredraw::bench

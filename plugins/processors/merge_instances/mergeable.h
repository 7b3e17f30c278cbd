#pragma once
// Which draws of a scene can share a merged draw, where they are placed, and what merging them saves and costs.

#include "frequency.h"
#include "seen_boxes.h"

#include <foredraw/base/parallel.h>
#include <foredraw/instances/merged_instances.h>
#include <foredraw/scene/poses.h>
#include <foredraw/scene/scene.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace foredraw::processors::merge_instances {

struct MergeablePlacement {
  std::uint32_t mesh = 0;  ///< its number in the set
  MergedPlace place;
  glm::mat4 world{1};
  Box<glm::vec3> box;  ///< in the world
};

/// A draw of the set, as often as it is placed.
struct MergeableMesh {
  DrawId draw = 0;
  std::uint64_t indices = 0;
  std::uint64_t placed = 0;
  std::uint64_t shaded = 0;  ///< vertices of one drawing by its index buffer, through a FIFO cache of 16
  double acmr() const { return indices == 0 ? 0 : static_cast<double>(shaded) / (static_cast<double>(indices) / 3); }
};

/// Draws of one vertex layout whose materials look alike, or are of one kind.
struct MergeableSet {
  std::optional<MaterialId> material;  ///< of the first
  std::vector<MergeableMesh> meshes;
  std::vector<MergeablePlacement> placements;
  std::string why_not;  ///< why these are not worth a merged draw; empty: they are
};

/// A draw, or one placement of it, that stays as it is.
struct LeftAlone {
  DrawId draw = 0;
  std::optional<NodeId> node;  ///< none: wherever it is placed
  std::string why;
};

/// Which materials one shader can draw.
enum class SharedMaterials : std::uint8_t {
  alike,  ///< those that say the same, whatever they are called
  kind,   ///< those that differ in factors and textures alone: the shader looks up each instance's, as in an array
};

struct MergeableOptions {
  SharedMaterials materials = SharedMaterials::alike;
  /// Skinned draws too, animated or not. Their joints place them, by whoever draws: transforms are the identity, and
  /// boxes hold what the poses show.
  bool skinned = false;
  Poses poses = rest_pose;
  /// What a draw call costs, in calls of the vertex shader. A merged draw calls it for each index entry, where an index
  /// buffer calls it for each vertex that the cache lacks; a mesh whose extra calls cost more than its draw is left
  /// alone.
  double draw_cost = 4096;
  std::uint64_t least_placements = 2;  ///< of a set
};

struct MergeableScene {
  std::vector<MergeableSet> sets;  ///< in the sequence of their first draws
  std::vector<LeftAlone> left_alone;
};

/// Of `draws` (rising), those that can be merged: triangle lists of opaque or masked materials, of one level and one
/// order, that are not skinned (unless asked), morphed, moved by an animation (or below a node that is) or tied to an
/// extension; placed by an affine transform that has an inverse, and shown. Sets where nothing is to be saved say so in
/// `why_not`, with the figures.
MergeableScene mergeable_scene(const Scene& scene, std::span<const DrawId> draws, const MergeableOptions& options,
                               const Executor& executor);

}  // namespace foredraw::processors::merge_instances

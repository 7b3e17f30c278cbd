#pragma once
// Many meshes with many instances each, drawn as a few draws without a vertex stored twice.

#include <foredraw/base/parallel.h>
#include <foredraw/geometry/box.h>
#include <foredraw/instances/merged_instances.h>

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace foredraw {

/// What the frequencies of slots are chosen for.
enum class FrequencyGoal : std::uint8_t {
  fewest_slots,  ///< as few slot records as a limit of padding allows
  least_cost,    ///< padding and records at their prices
};

struct MergeInstancesOptions {
  int multiple = 3;     ///< of the frequency, in index entries; a multiple of 3
  int frequencies = 2;  ///< of slots, at most, 1 to 4; each is a draw of each group
  FrequencyGoal goal = FrequencyGoal::fewest_slots;
  double most_padding = 0.02;             ///< of all entries drawn; goal fewest_slots
  double padded_cost = 12;                ///< bytes; goal least_cost
  double slot_byte_cost = 2;              ///< bytes; goal least_cost
  double draw_cost = 4096;                ///< of a draw call, in calls of the vertex shader
  std::int64_t most_indices = 1 << 24;    ///< of a group
  std::int64_t most_instances = 1 << 16;  ///< of a group
  double most_size = 0;                   ///< of a group's box, its longest side in the scene's units; 0: any
  double view_distance = 0;               ///< of cameras, in the scene's units; 0: a quarter of its diagonal
  bool cut_well = true;                   ///< cut meshes where few vertices are shared
};

namespace processors::merge_instances {

/// A mesh whose vertices lie in a buffer together with the others'.
struct PackedMesh {
  std::string_view name;                   ///< for messages
  std::span<const std::uint32_t> indices;  ///< a triangle list, from 0 to below `vertices`
  std::uint32_t first_vertex = 0;          ///< in the shared buffer
  std::uint32_t vertices = 0;
};

struct PlacedMesh {
  std::uint32_t mesh = 0;
  glm::mat4 world{1};
  Box<glm::vec3> box;  ///< in the world; finite
};

/// The buffers, and what they come to.
struct PackedInstances {
  std::vector<std::uint32_t> indices;       ///< into the shared vertex buffer
  std::vector<MergedSlot> slots;            ///< draw after draw
  std::vector<MergedTransform> transforms;  ///< [instance], group after group
  std::vector<std::uint32_t> placed;        ///< [instance] its number among those that were given
  std::vector<MergedGroup> groups;          ///< instances that lie together
  std::vector<MergedDraw> draws;            ///< group after group, frequencies rising in each

  std::uint64_t drawn_entries = 0;   ///< of all draws, without padding
  std::uint64_t padded_entries = 0;  ///< of all draws
  std::uint64_t mirrored = 0;        ///< instances that are turned inside out
  std::uint64_t fetched = 0;         ///< different vertices of each slot that is drawn, over all
  std::uint64_t fetched_plain = 0;   ///< the same if slots were cut without a look at vertices

  std::size_t bytes() const { return 4 * indices.size() + 8 * slots.size() + 48 * transforms.size(); }
};

}  // namespace processors::merge_instances

/// Merges meshes of one vertex layout, drawn with one shader: chooses the frequencies, the groups that are culled
/// together, and fills the buffers that runtime/merge_instances.h reads. A mesh that nothing places takes no room.
/// Deterministic at any number of threads. Throws std::invalid_argument where an option is out of its range, a mesh's
/// indices lead out of its vertices, or a transform is not affine or has no inverse; std::length_error where 32 bits
/// cannot number the entries or slots. Source: Persson, "Graphics Gems for Games", SIGGRAPH 2012, "Merge-Instancing".
processors::merge_instances::PackedInstances merge_instances(
    std::span<const processors::merge_instances::PackedMesh> meshes,
    std::span<const processors::merge_instances::PlacedMesh> placed, const MergeInstancesOptions& options,
    const Executor& executor);

struct Plugin;
Plugin merge_instances_plugin();

}  // namespace foredraw

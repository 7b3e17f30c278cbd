#pragma once
// Draws merged into few, beside the nodes and meshes that show the same: whoever knows nothing of them draws those.

#include <foredraw/scene/scene.h>

#include <glm/vec3.hpp>

#include <array>
#include <memory>
#include <optional>
#include <string>

namespace foredraw {

/// A record of 8 bytes: the slot's first entry in the index buffer, and the instance that it is drawn for.
struct MergedSlot {
  std::uint32_t index_offset = 0;
  std::uint32_t instance = 0;
  friend bool operator==(const MergedSlot&, const MergedSlot&) = default;
};

/// Three rows of four: what a position (x, y, z, 1) is multiplied with from the left.
using MergedTransform = std::array<float, 12>;

/// What of the scene an instance stands for.
struct MergedPlace {
  std::uint32_t node = 0;
  std::uint32_t primitive = 0;  ///< the draw's number in the node's mesh
  std::uint32_t instance = 0;   ///< its number among the node's; 0 where the node is drawn once
  friend auto operator<=>(const MergedPlace&, const MergedPlace&) = default;
};

/// Where a draw's vertices begin in the merged buffer.
struct MergedMesh {
  std::uint32_t draw = 0;
  std::uint32_t first_vertex = 0;
  friend bool operator==(const MergedMesh&, const MergedMesh&) = default;
};

/// slot_count * frequency vertices are drawn, without an index buffer bound.
struct MergedDraw {
  std::uint32_t group = 0;
  std::uint32_t frequency = 0;  ///< index entries of a slot: a multiple of 3
  std::uint32_t first_slot = 0;
  std::uint32_t slot_count = 0;  ///< slot_count * frequency is below 2^32
  friend bool operator==(const MergedDraw&, const MergedDraw&) = default;
};

/// Instances that lie together, to be culled together.
struct MergedGroup {
  glm::vec3 least{0}, most{0};  ///< of what is drawn, in the world
  std::uint32_t first_instance = 0;
  std::uint32_t instance_count = 0;
  friend bool operator==(const MergedGroup&, const MergedGroup&) = default;
};

/// Draws of one vertex layout, drawn with one shader. Vertex v of a draw belongs to slot first_slot + v / frequency,
/// and is entry index_offset + v % frequency of the index buffer. What fills a slot up is a triangle whose corners are
/// one. The triangles of instances that a transform turns inside out have their second and third corners exchanged.
/// runtime/merge_instances.h is the one definition. Source: Persson, "Graphics Gems for Games", SIGGRAPH 2012.
struct MergedInstances {
  std::optional<MaterialId> material;             ///< of all, or the first where instances have their own
  std::shared_ptr<const VertexStreams> vertices;  ///< all meshes', one behind the other
  std::vector<MergedMesh> meshes;                 ///< whose vertices these are
  Shared<std::uint32_t> indices;                  ///< into the vertices: a triangle list, slot after slot
  Shared<MergedSlot> slots;                       ///< draw after draw
  Shared<MergedTransform> transforms;             ///< [instance] to the world
  Shared<MergedPlace> places;                     ///< [instance]
  Shared<std::uint32_t> materials;                ///< [instance]; empty: all have `material`
  std::vector<MergedGroup> groups;
  std::vector<MergedDraw> draws;  ///< group after group
};
bool operator==(const MergedInstances& a, const MergedInstances& b);

/// The product of merge-instances, beside the nodes that show the same.
struct MergedDraws {
  static constexpr std::string_view product = "merged-draws";
  std::vector<MergedInstances> sets;
  friend bool operator==(const MergedDraws&, const MergedDraws&) = default;
};

/// Of the scene; empty where nothing is merged.
std::span<const MergedInstances> merged_sets(const Scene& scene);

/// What merged draws show of the scene; sorted.
std::vector<MergedPlace> merged_places(const Scene& scene);

/// What is wrong, as the rest of a sentence that begins with the name of these: buffers of unequal lengths, what leads
/// out of them, draws that are too long. Whether the places exist is the scene's to say.
std::optional<std::string> mistake_in(const MergedInstances& merged);

}  // namespace foredraw

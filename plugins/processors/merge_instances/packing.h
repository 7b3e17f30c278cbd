#pragma once
// The buffers of merged draws: one index buffer in which each mesh lies once, cut into slots; records that say which
// slot is drawn for which instance; and each instance's transform, once.

#include "frequency.h"

#include <foredraw/base/parallel.h>
#include <foredraw/scene/merged_instances.h>

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace foredraw::merging {

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
};

/// What a transform makes of a mesh. Only plain and mirrored ones can be merged.
enum class Placing : std::uint8_t {
  plain,
  mirrored,  ///< turned inside out: its determinant is negative
  singular,  ///< flat, or so nearly that the sign of its determinant is not certain
  not_finite,
  not_affine,  ///< its last row is not 0 0 0 1
};
Placing placing_of(const glm::mat4& world);
std::string_view to_text(Placing placing);

struct PackedInstances {
  std::vector<std::uint32_t> indices;            ///< into the shared vertex buffer
  std::vector<MergedSlot> slots;                 ///< draw after draw
  std::vector<MergedTransform> transforms;       ///< [instance], group after group
  std::vector<std::uint32_t> placed;             ///< [instance] its number among those that were given
  std::vector<std::uint32_t> first_instance{0};  ///< [group] and the end
  std::vector<MergedDraw> draws;                 ///< group after group, frequencies rising in each

  std::uint64_t drawn_entries = 0;   ///< of all draws, without padding
  std::uint64_t padded_entries = 0;  ///< of all draws
  std::uint64_t mirrored = 0;        ///< instances that are turned inside out
  std::uint64_t fetched = 0;         ///< different vertices of each slot that is drawn, over all
  std::uint64_t fetched_plain = 0;   ///< the same if slots were cut without a look at vertices

  std::size_t bytes() const { return 4 * indices.size() + 8 * slots.size() + 48 * transforms.size(); }
};

struct PackOptions {
  bool cut_well = true;  ///< cuts fall where few vertices are shared; the sequence of triangles stays
  std::uint64_t most_entries = 0xffffffff;  ///< of the index buffer, and of what one draw draws: offsets have 32 bits
};

/// `groups`: numbers of placed meshes, group after group, each group's from first[g] to first[g + 1]. Each mesh is cut
/// at its frequency. In a group instances are sorted by mesh. Triangles keep their corners and their sequence in the
/// mesh.
///
/// Padding repeats the last index of a slot's last triangle, so that it costs no other vertex and draws nothing.
///
/// A mesh that is placed mirrored lies in the index buffer a second time, the second and third corner of each triangle
/// exchanged: with the transform, which turns it inside out, it faces as glTF says, and one draw with one front face
/// draws all. Its first corner, which flat shading may go by, stays the first.
///
/// Draws that would have more entries than `most_entries` become several. Throws std::length_error, with the mesh's
/// name, where the index buffer would; std::invalid_argument where an index is not below the mesh's vertices, a mesh's
/// vertices reach beyond 2^32, or a transform is neither plain nor mirrored. Meshes without triangles draw nothing.
PackedInstances pack_instances(std::span<const PackedMesh> meshes, std::span<const PlacedMesh> placed,
                               std::span<const std::uint32_t> groups, std::span<const std::uint32_t> first,
                               const FrequencyChoice& frequencies, const PackOptions& options,
                               const Executor& executor);

}  // namespace foredraw::merging

#pragma once
// The buffers of merged draws: one index buffer in which each mesh lies once, cut into slots; records that say which
// slot is drawn for which instance; and each instance's transform, once.

#include "frequency.h"
#include "merge_instances.h"
#include "spatial_groups.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace foredraw::processors::merge_instances {

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

struct PackOptions {
  bool cut_well = true;  ///< cuts fall where few vertices are shared; the sequence of triangles stays
  std::uint64_t most_entries = 0xffffffff;  ///< of the index buffer, and of what one draw draws: offsets have 32 bits
};

/// `groups`: of the placed meshes. Each mesh is cut at its frequency. In a group instances are sorted by mesh.
/// Triangles keep their corners and their sequence in the mesh.
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
                               const SpatialGroups& groups, const FrequencyChoice& frequencies,
                               const PackOptions& options, const Executor& executor);

}  // namespace foredraw::processors::merge_instances

#include "merge_instances.h"

#include "packing.h"

#include <foredraw/base/this_thread.h>
#include <foredraw/c/checked_input.h>
#include <foredraw/geometry/finite.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

using namespace foredraw;
using namespace foredraw::processors::merge_instances;

namespace {

/// What an answer points to.
struct Owner {
  PackedInstances packed;
  std::vector<foredraw_merged_slot> slots;
  std::vector<foredraw_merged_draw> draws;
  std::vector<foredraw_merged_group> groups;
};

glm::mat4 matrix_of(const float (&rows)[12]) {
  glm::mat4 matrix(1);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) matrix[column][row] = rows[4 * row + column];
  }
  return matrix;
}

/// Of all that triangles use, where the matrix moves it; empty where something is not finite.
Box<glm::vec3> box_of(const c::CheckedTriangles& triangles, std::span<const glm::vec3> positions,
                      const glm::mat4& world) {
  Box<glm::vec3> box;
  for (const std::uint32_t index : triangles.indices()) {
    const glm::vec3 place(world * glm::vec4(positions[index], 1));
    if (!is_finite(place)) return {};
    box.add(place);
  }
  return box;
}

void fill(foredraw_merged& merged, std::unique_ptr<Owner> owner) {
  PackedInstances& packed = owner->packed;
  for (const MergedSlot& slot : packed.slots) owner->slots.push_back({slot.index_offset, slot.instance});
  for (const MergedDraw& draw : packed.draws) {
    owner->draws.push_back({draw.group, draw.frequency, draw.first_slot, draw.slot_count});
  }
  for (const MergedGroup& group : packed.groups) {
    owner->groups.push_back({{group.least.x, group.least.y, group.least.z},
                             {group.most.x, group.most.y, group.most.z},
                             group.first_instance,
                             group.instance_count});
  }
  merged = {};
  merged.indices = packed.indices.data();
  merged.slots = owner->slots.data();
  merged.transforms = packed.transforms.empty() ? nullptr : packed.transforms.front().data();
  merged.placed = packed.placed.data();
  merged.draws = owner->draws.data();
  merged.groups = owner->groups.data();
  merged.index_count = packed.indices.size();
  merged.slot_count = packed.slots.size();
  merged.instance_count = static_cast<std::uint32_t>(packed.transforms.size());
  merged.draw_count = static_cast<std::uint32_t>(packed.draws.size());
  merged.group_count = static_cast<std::uint32_t>(packed.groups.size());
  merged.owner = owner.release();
}

}  // namespace

int foredraw_merge_instances(foredraw_merged* merged, const foredraw_packed_mesh* meshes, uint32_t mesh_count,
                             const foredraw_placed_mesh* placed, uint32_t placed_count, uint32_t frequencies,
                             double most_size) {
  return c::guarded([&]() -> int {
    if (merged == nullptr) return FOREDRAW_NULL_POINTER;
    if ((meshes == nullptr && mesh_count > 0) || (placed == nullptr && placed_count > 0)) return FOREDRAW_NULL_POINTER;
    MergeInstancesOptions options;
    if (const int status = c::take_option(frequencies, 1, 4, options.frequencies)) return status;
    if (!(most_size >= 0 && std::isfinite(most_size))) return FOREDRAW_OPTION_RANGE;
    options.most_size = most_size;

    std::vector<c::CheckedTriangles> given;
    std::vector<PackedMesh> packed;
    std::vector<std::vector<glm::vec3>> positions;
    given.reserve(mesh_count);
    for (const foredraw_packed_mesh& mesh : std::span(meshes, mesh_count)) {
      const c::CheckedTriangles& triangles = given.emplace_back(&mesh.triangles);
      if (triangles.status() != FOREDRAW_DONE) return triangles.status();
      if (const int status = c::positions_status(&mesh.positions, triangles.vertex_count())) return status;
      if (triangles.indices().size() > 0xffffffff || mesh.first_vertex > 0xffffffff - mesh.triangles.vertex_count) {
        return FOREDRAW_TOO_LARGE;
      }
      positions.push_back(
          c::elements_at<glm::vec3>(mesh.positions.first, mesh.positions.stride, triangles.vertex_count()));
      packed.push_back({"", triangles.indices(), mesh.first_vertex, mesh.triangles.vertex_count});
    }
    std::vector<PlacedMesh> places;
    std::vector<std::uint32_t> number;  // [place] among those that were given: meshes of nothing are not placed
    for (std::uint32_t i = 0; i < placed_count; ++i) {
      const foredraw_placed_mesh& place = placed[i];
      if (place.mesh >= mesh_count) return FOREDRAW_INDEX_RANGE;
      if (packed[place.mesh].indices.empty()) continue;
      const glm::mat4 world = matrix_of(place.transform);
      const Placing placing = placing_of(world);
      const Box<glm::vec3> box = box_of(given[place.mesh], positions[place.mesh], world);
      const bool is_good = placing == Placing::plain || placing == Placing::mirrored;
      if (!is_good || box.is_empty()) return FOREDRAW_NO_TRANSFORM;
      places.push_back({place.mesh, world, box});
      number.push_back(i);
    }
    auto owner = std::make_unique<Owner>();
    try {
      if (!places.empty()) owner->packed = merge_instances(packed, places, options, on_this_thread());
    } catch (const std::length_error&) {
      return FOREDRAW_TOO_LARGE;
    }
    for (std::uint32_t& place : owner->packed.placed) place = number[place];
    fill(*merged, std::move(owner));
    return FOREDRAW_DONE;
  });
}

void foredraw_merged_free(foredraw_merged* merged) {
  if (merged == nullptr) return;
  delete static_cast<Owner*>(merged->owner);
  *merged = {};
}

#include "placed_draws.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <stdexcept>

namespace foredraw::bench {

namespace {

void number_groups(const Scene& scene, std::vector<PlacedDraw>& placed) {
  std::uint32_t number = 0;
  for (const MergedInstances& merged : merged_sets(scene)) {
    for (const MergedGroup& group : merged.groups) {
      ++number;
      for (const MergedPlace& place : merged.places.view().subspan(group.first_instance, group.instance_count)) {
        const auto found = std::ranges::lower_bound(placed, place, {}, &PlacedDraw::place);
        if (found != placed.end() && found->place == place) found->group = number;
      }
    }
  }
}

}  // namespace

std::vector<PlacedDraw> placed_draws(const Scene& scene) {
  const std::vector<glm::mat4> worlds = world_transforms(scene);
  std::vector<PlacedDraw> placed;
  placed.reserve(scene.nodes.size());
  for (NodeId n = 0; n < scene.nodes.size(); ++n) {
    const Node& node = scene.nodes[n];
    if (!node.mesh) continue;
    const std::vector<DrawId>& draws = scene.meshes[*node.mesh].draws;
    const auto instances = static_cast<std::uint32_t>(std::max<std::size_t>(1, node.instances.size()));
    for (std::uint32_t primitive = 0; primitive < draws.size(); ++primitive) {
      const Draw& draw = scene.draws[draws[primitive]];
      if (draw.topology != Topology::triangles || draw.levels[0].orders[0].indices.empty()) continue;
      for (std::uint32_t i = 0; i < instances; ++i) {
        PlacedDraw& one = placed.emplace_back();
        one.place = {n, primitive, i};
        one.draw = draws[primitive];
        one.world = node.instances.empty() ? worlds[n] : worlds[n] * node.instances.view()[i].matrix();
        one.is_mirrored = glm::determinant(glm::dmat3(one.world)) < 0;
      }
    }
  }
  number_groups(scene, placed);
  return placed;
}

std::vector<PlacedDraw> in_sequence(std::span<const PlacedDraw> placed, std::span<const MergedPlace> sequence) {
  std::vector<PlacedDraw> ordered;
  ordered.reserve(sequence.size());
  for (const MergedPlace& place : sequence) {
    const auto found = std::ranges::lower_bound(placed, place, {}, &PlacedDraw::place);
    if (found == placed.end() || found->place != place) {
      throw std::runtime_error("node " + std::to_string(place.node) + " does not show instance " +
                               std::to_string(place.instance) + " of primitive " + std::to_string(place.primitive));
    }
    ordered.push_back(*found);
  }
  return ordered;
}

std::uint32_t hash_of(const MergedPlace& place) {
  const std::uint32_t words[] = {place.node, place.primitive, place.instance};
  return static_cast<std::uint32_t>(content_hash(std::span<const std::uint32_t>(words)).low);
}

std::vector<std::uint32_t> hashes_of_looks(const Scene& scene) {
  std::vector<std::uint32_t> hashes;
  for (MaterialId id = 0; id < scene.materials.size(); ++id) {
    const auto& look = scene.materials[id].look;
    hashes.push_back(look ? static_cast<std::uint32_t>(look->low) : id);
  }
  hashes.push_back(~std::uint32_t{0});
  return hashes;
}

std::uint32_t look_of(const Scene& scene, DrawId draw) {
  return scene.draws[draw].material.value_or(static_cast<MaterialId>(scene.materials.size()));
}

MergedTransform rows_of(const glm::mat4& world) {
  MergedTransform rows;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) rows[static_cast<std::size_t>(4 * row + column)] = world[column][row];
  }
  return rows;
}

}  // namespace foredraw::bench

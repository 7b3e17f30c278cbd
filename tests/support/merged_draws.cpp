#include "support/merged_draws.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <map>

namespace foredraw::testing {

namespace {

DrawId draw_at(const Scene& scene, const MergedPlace& place) {
  return scene.meshes[*scene.nodes[place.node].mesh].draws[place.primitive];
}

/// Vertices one behind the other, those that several draws share once.
class Joined {
 public:
  std::uint32_t first_of(const std::shared_ptr<const VertexStreams>& own) {
    const auto [first, is_new] = first_.try_emplace(own.get(), count_);
    if (!is_new) return first->second;
    bytes_.resize(own->base.size());
    for (std::size_t s = 0; s < own->base.size(); ++s) {
      const auto bytes = own->base[s].bytes.view();
      bytes_[s].insert(bytes_[s].end(), bytes.begin(), bytes.end());
    }
    like_ = own;
    count_ += own->count;
    return first->second;
  }

  std::shared_ptr<const VertexStreams> take() {
    VertexStreams streams;
    streams.count = count_;
    for (std::size_t s = 0; s < bytes_.size(); ++s) {
      streams.base.push_back({like_->base[s].semantic, like_->base[s].format, Shared<std::byte>(std::move(bytes_[s]))});
    }
    return std::make_shared<const VertexStreams>(std::move(streams));
  }

 private:
  std::map<const VertexStreams*, std::uint32_t> first_;
  std::vector<std::vector<std::byte>> bytes_;
  std::shared_ptr<const VertexStreams> like_;
  std::uint32_t count_ = 0;
};

MergedTransform rows_of(const glm::mat4& matrix) {
  MergedTransform rows;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) rows[static_cast<std::size_t>(4 * row + column)] = matrix[column][row];
  }
  return rows;
}

}  // namespace

std::vector<MergedPlace> all_places(const Scene& scene) {
  std::vector<MergedPlace> places;
  for (NodeId n = 0; n < scene.nodes.size(); ++n) {
    const Node& node = scene.nodes[n];
    if (!node.mesh) continue;
    for (std::uint32_t p = 0; p < scene.meshes[*node.mesh].draws.size(); ++p) {
      for (std::uint32_t i = 0; i < std::max<std::size_t>(1, node.instances.size()); ++i) places.push_back({n, p, i});
    }
  }
  return places;
}

MergedInstances merged_by_hand(const Scene& scene, const std::vector<MergedPlace>& places, const MergeByHand& how) {
  MergedInstances merged;
  std::vector<std::uint32_t> indices;
  Joined vertices;
  struct Slots {
    std::uint32_t frequency = 0, first = 0, count = 0;
  };
  const std::vector<glm::mat4> worlds = world_transforms(scene);
  const auto world_of = [&](const MergedPlace& place) {
    const auto instances = scene.nodes[place.node].instances.view();
    return worlds[place.node] * (instances.empty() ? glm::mat4(1) : instances[place.instance].matrix());
  };
  const auto is_mirrored = [](const glm::mat4& world) { return glm::determinant(glm::dmat3(world)) < 0; };
  std::map<DrawId, std::map<bool, Slots>> slots_of;  // mirrored or not
  for (const MergedPlace& place : places) slots_of[draw_at(scene, place)][is_mirrored(world_of(place))];
  std::size_t k = 0;
  for (auto& [id, sides] : slots_of) {
    const Level& level = scene.draws[id].levels[0];
    const std::uint32_t first = vertices.first_of(level.vertices);
    merged.meshes.push_back({id, first});
    const std::uint32_t frequency = how.frequencies[k++ % how.frequencies.size()];
    for (auto& [is_turned, slots] : sides) {
      slots = {frequency, static_cast<std::uint32_t>(indices.size()), 0};
      const auto own = level.orders[0].indices.view();
      for (std::size_t i = 0; i < own.size(); i += 3) {
        for (const std::size_t c : {0, is_turned ? 2 : 1, is_turned ? 1 : 2}) indices.push_back(first + own[i + c]);
      }
      while ((indices.size() - slots.first) % frequency != 0) indices.push_back(indices.back());
      slots.count = static_cast<std::uint32_t>(indices.size() - slots.first) / frequency;
    }
  }
  std::vector<MergedSlot> slots;
  std::vector<MergedTransform> transforms;
  std::vector<std::uint32_t> materials;
  for (std::uint32_t g = 0; g < how.groups; ++g) {
    const auto first = static_cast<std::uint32_t>(places.size() * g / how.groups);
    const auto end = static_cast<std::uint32_t>(places.size() * (g + 1) / how.groups);
    const float number = static_cast<float>(g);
    merged.groups.push_back({glm::vec3(-number, 0.1f, -1e10f), glm::vec3(number + 0.3f), first, end - first});
    std::map<std::uint32_t, std::vector<MergedSlot>> by_frequency;
    for (std::uint32_t i = first; i < end; ++i) {
      const DrawId id = draw_at(scene, places[i]);
      const glm::mat4 world = world_of(places[i]);
      transforms.push_back(rows_of(world));
      materials.push_back(scene.draws[id].material.value_or(0));
      const Slots& cut = slots_of[id][is_mirrored(world)];
      for (std::uint32_t s = 0; s < cut.count; ++s)
        by_frequency[cut.frequency].push_back({cut.first + s * cut.frequency, i});
    }
    for (const auto& [frequency, own] : by_frequency) {
      merged.draws.push_back(
          {g, frequency, static_cast<std::uint32_t>(slots.size()), static_cast<std::uint32_t>(own.size())});
      slots.insert(slots.end(), own.begin(), own.end());
    }
  }
  merged.material = scene.draws[slots_of.begin()->first].material;
  merged.vertices = vertices.take();
  merged.indices = Shared(std::move(indices));
  merged.slots = Shared(std::move(slots));
  merged.transforms = Shared(std::move(transforms));
  merged.places = Shared(std::vector<MergedPlace>(places));
  if (how.materials) merged.materials = Shared(std::move(materials));
  return merged;
}

Scene with_merged(Scene scene, const std::vector<MergedInstances>& merged) {
  std::vector<MergedInstances> sets = merged_of(scene);
  for (const MergedInstances& set : merged) {
    sets.push_back(set);
    for (const MergedMesh& mesh : set.meshes) scene.draws[mesh.draw].traits.add(traits::extended);
  }
  scene.products.set(MergedDraws{std::move(sets)});
  return scene;
}

}  // namespace foredraw::testing

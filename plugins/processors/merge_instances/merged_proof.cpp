#include "merged_proof.h"

#include <foredraw/analysis/moved_nodes.h>
#include <foredraw/runtime/merge_instances.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace foredraw::processors::merge_instances {

namespace {

std::string numbered(const char* what, std::size_t number) { return what + (" " + std::to_string(number)); }

constexpr std::uint64_t spare = std::uint64_t{16} << 20;  ///< bytes or entries that may be looked at again

/// Whoever wrote the file may have rounded otherwise.
bool is_near(const MergedTransform& transform, const glm::mat4& world) {
  for (int row = 0; row < 3; ++row) {
    float most = 0;
    for (int column = 0; column < 4; ++column) most = std::max(most, std::abs(world[column][row]));
    for (int column = 0; column < 4; ++column) {
      const float off = transform[static_cast<std::size_t>(4 * row + column)] - world[column][row];
      if (!(std::abs(off) <= 1e-5f * most)) return false;
    }
  }
  return true;
}

bool is_padding(std::span<const std::uint32_t> entries, std::size_t triangle) {
  return entries[3 * triangle] == entries[3 * triangle + 1] && entries[3 * triangle] == entries[3 * triangle + 2];
}

/// The first triangle from `at` on that is drawn.
std::size_t next_drawn(std::span<const std::uint32_t> indices, std::size_t at) {
  while (at < indices.size() / 3 && is_padding(indices, at)) ++at;
  return at;
}

struct HashOfCompared {
  std::size_t operator()(const MergedProof::Compared& one) const {
    std::uint64_t hash = one.offset * 0x9e3779b97f4a7c15u + one.frequency;
    hash = (hash ^ (hash >> 29)) * 0xbf58476d1ce4e5b9u + one.draw;
    hash = (hash ^ (hash >> 32)) * 0x94d049bb133111ebu + 2 * std::uint64_t{one.triangle} + (one.is_mirrored ? 1 : 0);
    return hash ^ (hash >> 31);
  }
};

struct DrawnSlot {
  MergedSlot slot;
  std::uint32_t frequency = 0;
};

/// Each instance's slots as they lie in the index buffer: their sequence in a draw is free.
std::vector<DrawnSlot> in_sequence(const MergedInstances& set) {
  std::vector<DrawnSlot> slots;
  for (const MergedDraw& draw : set.draws) {
    for (const MergedSlot& slot : set.slots.view().subspan(draw.first_slot, draw.slot_count)) {
      slots.push_back({slot, draw.frequency});
    }
  }
  std::ranges::stable_sort(slots, {},
                           [](const DrawnSlot& one) { return std::pair(one.slot.instance, one.slot.index_offset); });
  return slots;
}

}  // namespace

MergedProof::MergedProof(const Scene& scene) : scene_(scene), worlds_(world_transforms(scene)), bytes_left_(spare) {
  std::set<const std::byte*> counted;
  for (const Draw& draw : scene.draws) {
    for (const VertexStream& stream : draw.levels[0].vertices->base) {
      if (counted.insert(stream.bytes.view().data()).second) bytes_left_ += stream.bytes.size();
    }
  }
}

std::string MergedProof::difference(const MergedInstances& set) {
  std::string found = vertices(set);
  if (found.empty()) found = placings(set);
  if (found.empty()) found = triangles(set);
  return found;
}

std::string MergedProof::vertices(const MergedInstances& set) {
  first_vertex_.clear();
  for (const MergedMesh& mesh : set.meshes) {
    const Draw& draw = scene_.draws[mesh.draw];
    const VertexStreams& own = *draw.levels[0].vertices;
    if (!first_vertex_.emplace(mesh.draw, mesh.first_vertex).second) return "names " + draw.name + " twice";
    if (draw.topology != Topology::triangles) return "holds " + draw.name + ", which is not a triangle list";
    if (own.base.size() != set.vertices->base.size() || !own.morph_targets.empty()) {
      return "does not have the attributes of " + draw.name;
    }
    if (!same_.emplace(&own, set.vertices.get(), mesh.first_vertex).second) continue;
    for (const VertexStream& stream : own.base) {
      const VertexStream* merged = set.vertices->find(stream.semantic);
      if (merged == nullptr || merged->format != stream.format) return "does not have the attributes of " + draw.name;
      if (stream.bytes.size() > bytes_left_) return "names the same vertices too often to check";
      bytes_left_ -= stream.bytes.size();
      const std::size_t from = std::size_t{mesh.first_vertex} * stream.format.bytes;
      if (!std::ranges::equal(stream.bytes.view(), merged->bytes.view().subspan(from, stream.bytes.size()))) {
        return "has a " + stream.semantic + " that differs from that of " + draw.name;
      }
    }
  }
  return {};
}

std::string MergedProof::placings(const MergedInstances& set) const {
  const auto look = [&](MaterialId id) { return scene_.materials[id].look; };
  const std::vector<bool> moved = moved_nodes(scene_);
  for (std::size_t i = 0; i < set.places.size(); ++i) {
    const MergedPlace& place = set.places.view()[i];
    const Node& node = scene_.nodes[place.node];
    const std::string where = numbered("instance", i) + " (" + numbered("primitive", place.primitive) + " of " +
                              numbered("node", place.node) + ")";
    const DrawId id = draw_at(place);
    if (!first_vertex_.contains(id)) return where + " belongs to no primitive of the set";
    const auto own = node.instances.view();
    if (node.skin && !own.empty()) return where + " is both skinned and instanced";
    if (!node.is_shown) return where + " has a node that is not shown";
    if (!node.skin && moved[place.node]) return where + " is static, but its node moves";
    glm::mat4 world = own.empty() ? worlds_[place.node] : worlds_[place.node] * own[place.instance].matrix();
    if (node.skin) world = glm::mat4(1);  // its joints place it
    if (!is_near(set.transforms.view()[i], world)) return where + " is not where its node is";
    const std::optional<MaterialId> is = set.materials.empty() ? set.material : std::optional(set.materials.view()[i]);
    const std::optional<MaterialId> wanted = scene_.draws[id].material;
    const bool looks_alike = is == wanted || (is && wanted && look(*is) && look(*is) == look(*wanted));
    if (!looks_alike) return where + " does not have the material of its primitive";
  }
  return {};
}

std::optional<std::uint32_t> MergedProof::triangle_after(const Compared& slot,
                                                         std::span<const std::uint32_t> drawn) const {
  const auto own = scene_.draws[slot.draw].levels[0].orders[0].indices.view();
  const std::uint32_t first = first_vertex_.at(slot.draw);
  std::size_t at = slot.triangle;
  for (std::size_t t = 0; t < drawn.size() / 3; ++t) {
    if (is_padding(drawn, t)) continue;
    if (at >= own.size() / 3) return std::nullopt;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t corner = c == 0 || !slot.is_mirrored ? c : 3 - c;
      if (drawn[3 * t + c] != first + own[3 * at + corner]) return std::nullopt;
    }
    at = next_drawn(own, at + 1);
  }
  return static_cast<std::uint32_t>(at);
}

std::string MergedProof::triangles(const MergedInstances& set) {
  const auto entries = set.indices.view();
  std::uint64_t left = entries.size() + spare;
  std::unordered_map<Compared, std::uint32_t, HashOfCompared> known;  // the mesh's triangle that comes after
  std::vector<std::uint32_t> reached(set.places.size());
  std::vector<std::uint8_t> mirrored(set.places.size());
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const auto own = scene_.draws[draw_at(set.places.view()[i])].levels[0].orders[0].indices.view();
    reached[i] = static_cast<std::uint32_t>(next_drawn(own, 0));
    mirrored[i] = foredraw_merged_is_mirrored(set.transforms.view()[i].data()) != 0;
  }
  const auto differs = [](std::uint32_t instance) {
    return numbered("instance", instance) + " does not draw the triangles of its primitive";
  };
  for (const auto& [slot, frequency] : in_sequence(set)) {
    const DrawId id = draw_at(set.places.view()[slot.instance]);
    const Compared one{slot.index_offset, frequency, id, reached[slot.instance], mirrored[slot.instance] != 0};
    const auto [after, is_new] = known.try_emplace(one, 0);
    if (is_new) {
      if (frequency > left) return "draws the same indices in too many ways to check";
      left -= frequency;
      const auto end = triangle_after(one, entries.subspan(slot.index_offset, frequency));
      if (!end) return differs(slot.instance);
      after->second = *end;
    }
    reached[slot.instance] = after->second;
  }
  for (std::uint32_t i = 0; i < reached.size(); ++i) {
    const auto own = scene_.draws[draw_at(set.places.view()[i])].levels[0].orders[0].indices.view();
    if (reached[i] != own.size() / 3) return differs(i);
  }
  return {};
}

}  // namespace foredraw::processors::merge_instances

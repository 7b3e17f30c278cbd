#include <foredraw/scene/vertex_groups.h>

#include <foredraw/scene/reorder.h>

#include <algorithm>
#include <map>

namespace foredraw {

std::vector<VertexGroup> vertex_groups(const Scene& scene) {
  std::vector<VertexGroup> groups;
  std::map<const VertexStreams*, std::size_t> group_of;
  for (DrawId id = 0; id < scene.draws.size(); ++id) {
    const auto& levels = scene.draws[id].levels;
    for (std::size_t level = 0; level < levels.size(); ++level) {
      const auto [at, is_new] = group_of.emplace(levels[level].vertices.get(), groups.size());
      if (is_new) groups.push_back({levels[level].vertices, {}});
      groups[at->second].users.push_back({id, level});
    }
  }
  return groups;
}

std::vector<HeldDraw> keep_groups_of(std::vector<VertexGroup>& groups, std::span<const DrawId> draws) {
  const auto may_change = [&](const VertexGroup::User& user) { return std::ranges::binary_search(draws, user.draw); };
  std::vector<HeldDraw> held;
  for (const VertexGroup& group : groups) {
    const auto by = std::ranges::find_if_not(group.users, may_change);
    if (by == group.users.end()) continue;
    for (const VertexGroup::User& user : group.users) {
      if (may_change(user)) held.push_back({user.draw, by->draw});
    }
  }
  std::erase_if(groups, [&](const VertexGroup& group) { return !std::ranges::all_of(group.users, may_change); });
  return held;
}

std::vector<std::span<const std::uint32_t>> index_streams_of(const Scene& scene, const VertexGroup& group) {
  std::vector<std::span<const std::uint32_t>> streams;
  for (const VertexGroup::User& user : group.users) {
    for (const IndexStream& stream : scene.draws[user.draw].levels[user.level].orders) {
      streams.push_back(stream.indices.view());
    }
  }
  return streams;
}

void move_vertices(Scene& scene, const VertexGroup& group, std::span<const std::uint32_t> destination,
                   std::uint32_t count) {
  const auto moved = std::make_shared<const VertexStreams>(with_vertices_moved(*group.vertices, destination, count));
  for (const VertexGroup::User& user : group.users) {
    scene.draws[user.draw] = with_vertices_moved(scene.draws[user.draw], user.level, moved, destination);
  }
}

}  // namespace foredraw

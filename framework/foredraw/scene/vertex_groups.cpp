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

std::vector<Draw> with_vertices_moved(const Scene& scene, const VertexGroup& group,
                                      std::span<const std::uint32_t> destination, std::uint32_t count) {
  const auto moved = std::make_shared<const VertexStreams>(with_vertices_moved(*group.vertices, destination, count));
  std::vector<Draw> draws;
  const Level* first_before = nullptr;
  for (const VertexGroup::User& user : group.users) {
    const Level& before = scene.draws[user.draw].levels[user.level];
    draws.push_back(with_vertices_moved(scene.draws[user.draw], user.level, moved, destination));
    if (first_before == nullptr) first_before = &before;
    // Thousands of draws may share a great many vertices: a table for each would fill the memory.
    if (before.vertex_destination.is(first_before->vertex_destination)) {
      draws.back().levels[user.level].vertex_destination =
          draws.front().levels[group.users.front().level].vertex_destination;
    }
  }
  return draws;
}

void move_vertices(Scene& scene, const VertexGroup& group, std::span<const std::uint32_t> destination,
                   std::uint32_t count) {
  // One after the other: a draw whose levels share vertices is a user for each of them.
  std::vector<Draw> draws = with_vertices_moved(scene, group, destination, count);
  for (std::size_t i = 0; i < draws.size(); ++i) {
    Draw& draw = scene.draws[group.users[i].draw];
    draw.levels[group.users[i].level] = std::move(draws[i].levels[group.users[i].level]);
  }
}

}  // namespace foredraw

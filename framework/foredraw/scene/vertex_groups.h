#pragma once
#include <foredraw/scene/scene.h>

namespace foredraw {

/// One VertexStreams and everybody who draws from it. Whoever moves its vertices has to renumber all of them.
struct VertexGroup {
  using User = DrawLevel;
  std::shared_ptr<const VertexStreams> vertices;
  std::vector<User> users;  ///< in draw order
};

/// The groups of a scene, by first user.
std::vector<VertexGroup> vertex_groups(const Scene& scene);

/// A draw whose vertices must stay, for the sake of another one that shares them.
struct HeldDraw {
  DrawId draw = 0;
  DrawId by = 0;
};

/// Takes the groups out that somebody uses who is not among `draws` (rising). Answers with the draws that are among
/// them and are held back by that.
std::vector<HeldDraw> keep_groups_of(std::vector<VertexGroup>& groups, std::span<const DrawId> draws);

/// Every index stream of a group, in draw, level and order.
std::vector<std::span<const std::uint32_t>> index_streams_of(const Scene& scene, const VertexGroup& group);

/// The draws of all users, in that order, with the group's vertices moved as the function of that name does for one
/// draw.
std::vector<Draw> with_vertices_moved(const Scene& scene, const VertexGroup& group,
                                      std::span<const std::uint32_t> destination, std::uint32_t count);

/// Moves the group's vertices as with_vertices_moved() does, for all of its users. The certificate is the caller's.
void move_vertices(Scene& scene, const VertexGroup& group, std::span<const std::uint32_t> destination,
                   std::uint32_t count);

}  // namespace foredraw

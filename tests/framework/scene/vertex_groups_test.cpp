#include <foredraw/scene/vertex_groups.h>

#include "support/meshes.h"

#include <gtest/gtest.h>

namespace foredraw::vertex_groups_test {
namespace {

using Numbers = std::vector<std::uint32_t>;

IndexStream stream_of(const Numbers& indices) { return {.indices = Shared<std::uint32_t>(indices)}; }

Numbers indices(const Scene& scene, DrawId draw, std::size_t level = 0, std::size_t order = 0) {
  const auto view = scene.draws[draw].levels[level].orders[order].indices.view();
  return {view.begin(), view.end()};
}

/// Draws 0 and 2 share vertices; so does the second level of draw 0. Draw 1 has equal vertices of its own.
Scene shared_scene() {
  const testing::TestMesh mesh = {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {0, 1, 2}};
  Scene scene =
      testing::scene_of({testing::draw_of(mesh, "A"), testing::draw_of(mesh, "B"), testing::draw_of(mesh, "C")});
  Level coarse = scene.draws[0].levels[0];
  coarse.orders = {stream_of({2, 1, 0}), stream_of({1, 2, 0})};
  scene.draws[0].levels.push_back(coarse);
  scene.draws[2].levels[0].vertices = scene.draws[0].levels[0].vertices;
  scene.draws[2].levels[0].orders = {stream_of({0, 2, 1})};
  return scene;
}

TEST(VertexGroups, GatherWhoDrawsFromTheSameStreams) {
  const Scene scene = shared_scene();
  const std::vector<VertexGroup> groups = vertex_groups(scene);
  ASSERT_EQ(groups.size(), 2u) << "equal streams that are not shared stay apart";
  EXPECT_EQ(groups[0].vertices, scene.draws[0].levels[0].vertices);
  ASSERT_EQ(groups[0].users.size(), 3u);
  EXPECT_EQ(groups[0].users[0].draw, 0u);
  EXPECT_EQ(groups[0].users[0].level, 0u);
  EXPECT_EQ(groups[0].users[1].draw, 0u);
  EXPECT_EQ(groups[0].users[1].level, 1u);
  EXPECT_EQ(groups[0].users[2].draw, 2u);
  EXPECT_EQ(groups[0].users[2].level, 0u);
  ASSERT_EQ(groups[1].users.size(), 1u);
  EXPECT_EQ(groups[1].users[0].draw, 1u);
}

TEST(VertexGroups, IndexStreamsInDrawLevelAndOrder) {
  const Scene scene = shared_scene();
  const auto streams = index_streams_of(scene, vertex_groups(scene)[0]);
  std::vector<Numbers> copies;
  for (const auto& stream : streams) copies.emplace_back(stream.begin(), stream.end());
  EXPECT_EQ(copies, (std::vector<Numbers>{{0, 1, 2}, {2, 1, 0}, {1, 2, 0}, {0, 2, 1}}));
}

TEST(VertexGroups, MoveVerticesMovesForAllOfThem) {
  Scene scene = shared_scene();
  const Scene before = scene;
  const VertexGroup group = vertex_groups(scene)[0];
  move_vertices(scene, group, Numbers{2, 0, 1}, 3);
  EXPECT_EQ(indices(scene, 0), (Numbers{2, 0, 1}));
  EXPECT_EQ(indices(scene, 0, 1, 0), (Numbers{1, 0, 2}));
  EXPECT_EQ(indices(scene, 0, 1, 1), (Numbers{0, 1, 2}));
  EXPECT_EQ(indices(scene, 2), (Numbers{2, 1, 0}));
  EXPECT_EQ(indices(scene, 1), (Numbers{0, 1, 2})) << "the other group";
  EXPECT_EQ(scene.draws[1].levels[0].vertices, before.draws[1].levels[0].vertices);
  EXPECT_EQ(vertex_groups(scene)[0].users.size(), 3u) << "shared as before";
  const auto positions = decode_vec3(scene.draws[2].levels[0].vertices->base[0]);
  EXPECT_EQ(positions, (std::vector<glm::vec3>{{1, 0, 0}, {2, 0, 0}, {0, 0, 0}}));
  EXPECT_EQ(scene.draws[0].levels[1].vertex_destination.view()[0], 2u);
}

TEST(VertexGroups, EmptySceneHasNone) { EXPECT_TRUE(vertex_groups({}).empty()); }

}  // namespace
}  // namespace foredraw::vertex_groups_test

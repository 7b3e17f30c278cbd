#include <foredraw/viewing/posed_positions.h>

#include "support/meshes.h"

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec4.hpp>

namespace foredraw::posed_positions_test {
namespace {

using Positions = std::vector<glm::vec3>;

template <class T>
VertexStream stream_of(std::string semantic, Component component, std::uint8_t components, bool normalized,
                       const std::vector<T>& values) {
  const auto bytes = std::as_bytes(std::span<const T>(values));
  const Format format{component, components, normalized, static_cast<std::uint16_t>(components * sizeof(T))};
  return {std::move(semantic), format, Shared<std::byte>({bytes.begin(), bytes.end()})};
}

/// Two vertices at (1, 0, 0) and (2, 0, 0), shown by node 0.
Scene two_vertices() {
  testing::TestMesh mesh;
  mesh.positions = {{1, 0, 0}, {2, 0, 0}};
  return testing::scene_of(mesh);
}

void change_vertices(Scene& scene, const std::function<void(VertexStreams&)>& change) {
  VertexStreams streams = *scene.draws[0].levels[0].vertices;
  change(streams);
  scene.draws[0].levels[0].vertices = std::make_shared<const VertexStreams>(streams);
}

Positions at_rest(const Scene& scene, std::optional<NodeId> node) {
  return posed_positions(scene, {0, node}, posed_nodes(scene));
}

TEST(PosedPositions, are_as_stored_without_a_node) {
  Scene scene = two_vertices();
  scene.nodes[0].transform.translation = {5, 0, 0};
  EXPECT_EQ(at_rest(scene, {}), (Positions{{1, 0, 0}, {2, 0, 0}}));
}

TEST(PosedPositions, follow_the_node_and_its_parents) {
  Scene scene = two_vertices();
  scene.nodes[0].transform.scale = {-1, 1, 1};
  Node parent;
  parent.transform.translation = {0, 3, 0};
  parent.children = {0};
  scene.nodes.push_back(parent);
  EXPECT_EQ(at_rest(scene, 0), (Positions{{-1, 3, 0}, {-2, 3, 0}}));
}

TEST(PosedPositions, add_morph_targets_at_the_nodes_weights_else_the_meshs) {
  Scene scene = two_vertices();
  change_vertices(scene, [](VertexStreams& streams) {
    const auto target = [](std::vector<float> offsets) {
      return std::vector{stream_of("NORMAL", Component::float32, 3, false, std::vector<float>(6, 99.0f)),
                         stream_of("POSITION", Component::float32, 3, false, offsets)};
    };
    streams.morph_targets = {target({0, 2, 0, 0, 0, 0}), target({0, 0, 0, 0, 0, 4})};
  });
  scene.meshes[0].weights = {0.5f, 0};
  EXPECT_EQ(at_rest(scene, 0), (Positions{{1, 1, 0}, {2, 0, 0}}));
  scene.nodes[0].weights = {0, 0.25f};
  EXPECT_EQ(at_rest(scene, 0), (Positions{{1, 0, 0}, {2, 0, 1}}));
}

/// Joints 1 (moved up by 2) and 2 (moved up by 4), and a node whose own transform must not matter.
Scene skinned_vertices() {
  Scene scene = two_vertices();
  scene.nodes.resize(3);
  scene.nodes[0].skin = 0;
  scene.nodes[0].transform.translation = {50, 0, 0};
  scene.nodes[1].transform.translation = {0, 2, 0};
  scene.nodes[2].transform.translation = {0, 4, 0};
  scene.skins.resize(1);
  scene.skins[0].joints = {1, 2};
  scene.skins[0].inverse_bind_matrices = {glm::mat4(1), glm::translate(glm::mat4(1), {0, 0, -1})};
  return scene;
}

TEST(PosedPositions, follow_joints_by_weights_of_all_sets) {
  Scene scene = skinned_vertices();
  change_vertices(scene, [](VertexStreams& streams) {
    const auto add = [&](const char* n, std::vector<std::uint8_t> joints, std::vector<std::uint8_t> weights) {
      streams.base.push_back(stream_of(std::string("JOINTS_") + n, Component::uint8, 4, false, joints));
      streams.base.push_back(stream_of(std::string("WEIGHTS_") + n, Component::uint8, 4, true, weights));
    };
    // Weights of the second vertex sum to 2: half and half over both sets.
    add("0", {0, 0, 0, 0, 0, 0, 0, 0}, {255, 0, 0, 0, 255, 0, 0, 0});
    add("1", {0, 0, 0, 0, 9, 1, 0, 0}, {0, 0, 0, 0, 0, 255, 0, 0});
  });
  EXPECT_EQ(at_rest(scene, 0), (Positions{{1, 2, 0}, {2, 3, -0.5f}}));
}

TEST(PosedPositions, follow_the_node_where_no_joint_has_a_weight) {
  const Scene scene = skinned_vertices();
  EXPECT_EQ(at_rest(scene, 0), (Positions{{51, 0, 0}, {52, 0, 0}}));
}

/// By targets, joints and nodes, and where no joint has a weight.
TEST(VertexMaps, move_stored_positions_to_posed_ones) {
  Scene scene = skinned_vertices();
  scene.nodes[0].weights = {0.5f};
  scene.nodes[1].transform.rotation = glm::quat(0.5f, 0.5f, 0.5f, 0.5f);
  change_vertices(scene, [](VertexStreams& streams) {
    streams.base.push_back(
        stream_of("JOINTS_0", Component::uint8, 4, false, std::vector<std::uint8_t>{0, 1, 0, 0, 0, 0, 0, 0}));
    streams.base.push_back(
        stream_of("WEIGHTS_0", Component::uint8, 4, true, std::vector<std::uint8_t>{155, 100, 0, 0, 0, 0, 0, 0}));
    streams.morph_targets = {
        {stream_of("POSITION", Component::float32, 3, false, std::vector<float>{1, 2, 3, -4, 5, 6})}};
  });
  const auto expect_moved = [&](std::optional<NodeId> node) {
    const auto maps = vertex_maps(scene, {0, node}, posed_nodes(scene));
    const Positions stored = {{1, 0, 0}, {2, 0, 0}}, want = at_rest(scene, node);
    ASSERT_EQ(maps.size(), 2u);
    for (std::size_t v = 0; v < 2; ++v) {
      const glm::dvec3 at = maps[v] * glm::dvec4(stored[v], 1);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(at[c], want[v][c], 1e-5) << v;
    }
  };
  expect_moved(0);
  expect_moved(std::nullopt);
  scene.nodes[0].skin.reset();
  expect_moved(0);
}

TEST(PosedPositions, are_none_without_a_position_stream) {
  Scene scene = two_vertices();
  change_vertices(scene, [](VertexStreams& streams) { streams.base.clear(); });
  EXPECT_TRUE(at_rest(scene, 0).empty());
}

}  // namespace
}  // namespace foredraw::posed_positions_test

#include "evaluators/scene_cost/scene_cost.h"

#include "support/edit_product.h"
#include "support/merged_draws.h"
#include "support/meshes.h"

#include <foredraw/analysis/vertex_cache.h>
#include <foredraw/instances/merged_instances.h>
#include <foredraw/scene/order_table.h>
#include <foredraw/technique/plugin.h>

#include <gtest/gtest.h>

#include <map>

namespace foredraw::scene_cost_test {
namespace {

using testing::draw_of;
using testing::grid;
using testing::scene_of;

/// A mesh of both draws, seen as often as asked, each time elsewhere; no other mesh is seen.
Scene two_primitives(std::size_t times) {
  Scene scene = scene_of({draw_of(grid(4, 3), "floor"), draw_of(grid(2, 1), "wall")});
  scene.meshes = {{"house", {0, 1}, {}}};
  scene.nodes.assign(times, {});
  for (std::size_t i = 0; i < times; ++i) {
    scene.nodes[i].mesh = 0;
    scene.nodes[i].transform.translation.x = static_cast<float>(i);
  }
  return scene;
}

std::uint64_t misses(const testing::TestMesh& mesh, std::uint32_t cache) {
  return count_fifo(mesh.indices, mesh.positions.size(), cache).misses;
}

TEST(SceneCost, every_node_draws_each_primitive_of_its_mesh) {
  const SceneCost cost = scene_cost(two_primitives(5));
  EXPECT_EQ(cost.draws, 10u);
  EXPECT_EQ(cost.instances, 10u);
  EXPECT_EQ(cost.draws_if_instanced, 2u);
  EXPECT_EQ(cost.indices, 5u * 3 * (24 + 4));
  EXPECT_EQ(cost.triangles, 5u * (24 + 4));
  EXPECT_EQ(cost.shaded, 5.0 * static_cast<double>(misses(grid(4, 3), 16) + misses(grid(2, 1), 16)));
  EXPECT_EQ(cost.triangles_shaded, cost.shaded);
}

TEST(SceneCost, bytes_are_of_streams_and_each_counts_once) {
  const SceneCost cost = scene_cost(two_primitives(5));
  EXPECT_EQ(cost.vertex_bytes, 12u * (20 + 6));
  EXPECT_EQ(cost.index_bytes, 2u * 3 * (24 + 4));
  EXPECT_EQ(cost.instance_bytes, 5u * 48);
  Scene alike = two_primitives(1);
  alike.draws.push_back(alike.draws[0]);
  alike.meshes.push_back({"shed", {2}, {}});
  alike.nodes.push_back({});
  alike.nodes.back().mesh = 1;
  EXPECT_EQ(scene_cost(alike).vertex_bytes, cost.vertex_bytes);
  EXPECT_EQ(scene_cost(alike).index_bytes, cost.index_bytes);
  alike.draws[2] = draw_of(grid(4, 3));
  EXPECT_EQ(scene_cost(alike).vertex_bytes, cost.vertex_bytes + 12 * 20) << "equal, but there twice";
}

TEST(SceneCost, indices_take_four_bytes_where_two_do_not_reach) {
  const Scene scene = scene_of(grid(255, 255));  // 65,536 vertices: the last number says where a strip begins anew
  EXPECT_EQ(scene_cost(scene).index_bytes, 4u * 3 * 2 * 255 * 255);
  EXPECT_EQ(scene_cost(scene_of(grid(254, 255))).index_bytes, 2u * 3 * 2 * 254 * 255);
}

TEST(SceneCost, gpu_instancing_is_one_call_for_each_primitive) {
  Scene scene = two_primitives(2);
  scene.nodes[1].instances = Shared<Transform>(std::vector<Transform>(7));
  const SceneCost cost = scene_cost(scene);
  EXPECT_EQ(cost.draws, 4u);
  EXPECT_EQ(cost.instances, 16u);
  EXPECT_EQ(cost.draws_if_instanced, 2u);
  EXPECT_EQ(cost.indices, 8u * 3 * (24 + 4));
  EXPECT_EQ(cost.instance_bytes, 8u * 48);
}

TEST(SceneCost, equal_primitives_can_be_instances_of_one_and_others_not) {
  Scene scene = scene_of({draw_of(grid(4, 3)), draw_of(grid(4, 3)), draw_of(grid(3, 4)), draw_of(grid(4, 3))});
  scene.materials.resize(2);
  for (Draw& draw : scene.draws) draw.material = 0;
  EXPECT_EQ(scene_cost(scene).draws_if_instanced, 2u);
  scene.draws[1].material = 1;
  EXPECT_EQ(scene_cost(scene).draws_if_instanced, 3u);
  scene.draws[3].material = 1;
  EXPECT_EQ(scene_cost(scene).draws_if_instanced, 3u);
  scene.materials[1].alpha_mode = AlphaMode::blend;
  EXPECT_EQ(scene_cost(scene).draws_if_instanced, 4u);
  EXPECT_EQ(scene_cost(scene).draws, 4u);
}

TEST(SceneCost, mirrored_instances_wind_the_other_way) {
  Scene scene = two_primitives(4);
  scene.nodes[1].transform.scale = {-1, 1, 1};
  EXPECT_EQ(scene_cost(scene).draws_if_instanced, 4u);
  scene.nodes[1].transform.scale = {-1, 1, -1};
  EXPECT_EQ(scene_cost(scene).draws_if_instanced, 2u);
  std::vector<Transform> mirrored(2);
  mirrored[0].scale.y = -1;
  scene.nodes[1].instances = Shared<Transform>(mirrored);
  EXPECT_EQ(scene_cost(scene).draws_if_instanced, 4u);
  scene.nodes[0].children = {1};  // twice mirrored, or not at all
  scene.nodes[0].transform.scale.z = -3;
  scene.nodes[1].instances = {};
  scene.nodes[1].transform.scale = {1, -1, 1};
  EXPECT_EQ(scene_cost(scene).draws_if_instanced, 4u);
  scene.nodes[0].mesh.reset();
  EXPECT_EQ(scene_cost(scene).draws_if_instanced, 2u);
}

TEST(SceneCost, what_is_skinned_or_morphed_stays_by_itself) {
  Scene scene = two_primitives(3);
  scene.nodes[0].skin = 0;
  scene.skins.push_back({"skin", {0}, {glm::mat4(1)}});
  EXPECT_EQ(scene_cost(scene).draws_if_instanced, 2u + 2u);
  VertexStreams morphed = *scene.draws[1].levels[0].vertices;
  morphed.morph_targets = {morphed.base};
  scene.draws[1].levels[0].vertices = std::make_shared<const VertexStreams>(morphed);
  EXPECT_EQ(scene_cost(scene).draws_if_instanced, 1u + 1u + 3u);
}

TEST(SceneCost, what_draws_nothing_costs_nothing) {
  EXPECT_EQ(scene_cost({}).draws, 0u);
  Scene scene = two_primitives(1);
  scene.draws[0].levels[0].orders[0].indices = {};
  scene.draws[1].levels[0].orders[0].indices = {};
  scene.meshes.push_back({"unseen", {0, 1}, {}});
  EXPECT_EQ(scene_cost(scene).draws, 0u);
  EXPECT_EQ(scene_cost(scene).vertex_bytes + scene_cost(scene).instance_bytes, 0u);
}

TEST(SceneCost, without_nodes_each_mesh_is_there_once) {
  Scene scene = two_primitives(0);
  EXPECT_EQ(scene_cost(scene).draws, 2u);
  EXPECT_EQ(scene_cost(scene).instances, 2u);
}

TEST(SceneCost, orders_are_shaded_as_their_table_serves_them) {
  Scene scene = scene_of(grid(40, 40));
  Level& level = scene.draws[0].levels[0];
  IndexStream shuffled;
  shuffled.indices = Shared<std::uint32_t>(testing::shuffled(grid(40, 40), 3).indices);
  level.orders.push_back(shuffled);
  const double plain = scene_cost(scene).shaded;
  const std::uint64_t bytes = scene_cost(scene).index_bytes;
  OrderTable table;
  table.draws = {0};
  table.theta_steps = 2;
  table.order = {0, 1};
  testing::edit<DrawOrders>(scene)->tables.push_back(table);
  const double half = scene_cost(scene).shaded;
  testing::edit<DrawOrders>(scene)->tables[0].order = {1, 1};
  const double worse = scene_cost(scene).shaded;
  EXPECT_NEAR(half, (plain + worse) / 2, 1);
  EXPECT_GT(worse, 1.5 * plain);
  EXPECT_EQ(scene_cost(scene).index_bytes, bytes);
  testing::edit<DrawOrders>(scene)->tables[0].order = {0, 1};
  EXPECT_EQ(scene_cost(scene).index_bytes, 2 * bytes);
}

TEST(SceneCost, points_and_lines_are_shaded_but_have_no_triangles) {
  Scene scene = scene_of(grid(4, 3));
  scene.draws[0].topology = Topology::points;
  const SceneCost cost = scene_cost(scene);
  EXPECT_GT(cost.shaded, 0);
  EXPECT_EQ(cost.triangles, 0u);
  EXPECT_EQ(cost.triangles_shaded, 0);
}

/// Two meshes of 24 and 4 triangles, each placed five times, in slots of 30 indices: three and one of them.
TEST(SceneCost, merged_draws_stand_for_what_they_show) {
  const Scene plain = two_primitives(5);
  const std::vector<MergedPlace> places = testing::all_places(plain);
  Scene scene = testing::with_merged(plain, {testing::merged_by_hand(plain, places, {.frequencies = {30}})});
  const SceneCost cost = scene_cost(scene);
  EXPECT_EQ(cost.draws, 2u) << "of two groups";
  EXPECT_EQ(cost.draws_if_instanced, 2u);
  EXPECT_EQ(cost.instances, 10u);
  EXPECT_EQ(cost.indices, 5u * (3 + 1) * 30);
  EXPECT_EQ(cost.shaded, 5.0 * (3 + 1) * 30) << "padding too, and no cache";
  EXPECT_EQ(cost.triangles, 5u * (3 + 1) * 10);
  EXPECT_EQ(cost.vertex_bytes, 12u * (20 + 6));
  EXPECT_EQ(cost.index_bytes, 4u * (3 + 1) * 30);
  EXPECT_EQ(cost.instance_bytes, 10u * 48 + 5 * (3 + 1) * 8);
  testing::edit<MergedDraws>(scene)->sets[0].materials = Shared(std::vector<std::uint32_t>(10));
  EXPECT_EQ(scene_cost(scene).instance_bytes, cost.instance_bytes + 10 * 4);
}

TEST(SceneCost, what_is_merged_in_part_is_drawn_in_part) {
  Scene plain = two_primitives(5);
  plain.nodes[4].instances = Shared<Transform>(std::vector<Transform>(7));
  std::vector<MergedPlace> places = testing::all_places(plain);
  // Left: the second primitive of the first two nodes, and two of seven instances of both of the last one.
  std::erase_if(places, [](const MergedPlace& place) {
    return (place.node < 2 && place.primitive == 1) || (place.node == 4 && place.instance >= 5);
  });
  const Scene scene =
      testing::with_merged(plain, {testing::merged_by_hand(plain, places, {.frequencies = {30}, .groups = 1})});
  const SceneCost cost = scene_cost(scene);
  EXPECT_EQ(cost.draws, 1u + 2 + 2);
  EXPECT_EQ(cost.draws_if_instanced, 1u + 2);
  EXPECT_EQ(cost.instances, 11u * 2);
  const std::uint64_t slots = 9 * 3 + 7 * 1, left = 2 * 3 * 24 + 4 * 3 * 4;
  EXPECT_EQ(cost.indices, slots * 30 + left);
  EXPECT_EQ(cost.shaded, static_cast<double>(slots * 30 + 2 * misses(grid(4, 3), 16) + 4 * misses(grid(2, 1), 16)));
  EXPECT_EQ(cost.vertex_bytes, 12u * (20 + 6)) << "of which those that are left draw a part";
  EXPECT_EQ(cost.index_bytes, 4u * (3 + 1) * 30 + 2u * 3 * (24 + 4));
  EXPECT_EQ(cost.instance_bytes, 16u * 48 + slots * 8 + (1 + 1 + 2) * 48);
}

TEST(SceneCost, what_the_file_does_not_show_costs_nothing) {
  Scene scene = two_primitives(3);
  scene.nodes[1].is_shown = false;
  EXPECT_EQ(scene_cost(scene).draws, 4u);
  for (Node& node : scene.nodes) node.is_shown = false;
  EXPECT_EQ(scene_cost(scene).draws, 0u);
}

TEST(SceneCost, threads_change_nothing_and_the_plugin_tells_the_figures) {
  const Scene scene = two_primitives(3);
  testing::RunFixture fixture;
  const Technique technique = scene_cost_plugin().create({{"cache-size", std::int64_t{3}}});
  std::get<std::unique_ptr<Evaluator>>(technique)->evaluate(scene, fixture.run);
  std::map<std::string, Measured> figures;
  for (const Measured& figure : fixture.findings.measured) figures[figure.metric] = figure;
  const SceneCost cost = scene_cost(scene, {.cache_size = 3}, Executor(2));
  EXPECT_EQ(cost.shaded, 3.0 * static_cast<double>(misses(grid(4, 3), 3) + misses(grid(2, 1), 3)));
  EXPECT_EQ(figures.at("shaded").numerator, cost.shaded);
  EXPECT_EQ(figures.at("acmr").denominator, 3.0 * 28);
  EXPECT_EQ(figures.at("draws").numerator, 6);
  EXPECT_EQ(figures.at("bytes").numerator, figures.at("of-vertices.bytes").numerator +
                                               figures.at("of-indices.bytes").numerator +
                                               figures.at("of-instances.bytes").numerator);
}

}  // namespace
}  // namespace foredraw::scene_cost_test

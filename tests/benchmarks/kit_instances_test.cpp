// The stages for scenes of many instances, on the scenes that the kits of the corpus make, through the file.
#include "layout.h"

#include "evaluators/scene_cost/scene_cost.h"
#include "plugins/processors/gpu_instances/gpu_instances.h"
#include "plugins/processors/merge_instances/merge_scene.h"
#include "support/edit_product.h"
#include "support/meshes.h"
#include "support/products.h"

#include <foredraw/instances/merged_instances.h>
#include <foredraw/io/gltf/gltf.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>

namespace foredraw::bench::kit_instances_test {
namespace {

Scene through_file(const Scene& scene) {
  Diagnostics diagnostics;
  const ProductRows rows = testing::built_in_products();
  const auto files = encode_gltf(scene, "made.glb", diagnostics, {.products = rows});
  auto read = files ? read_gltf(files->front().bytes, "made.glb", {}, diagnostics, {.products = rows}) : std::nullopt;
  if (!read) throw std::runtime_error(to_text(diagnostics));
  return *read;
}

Scene space(double mirrored) {
  const Kit kit = read_kit(testing::project_file("benchmarks/corpus/scenes/kenney_space_kit"));
  return through_file(placed_scene(kit, space_layout(kit, {.instances = 3000, .mirrored = mirrored}), "space"));
}

/// Those that a pipeline would let a stage change.
std::vector<DrawId> free_draws(const Scene& scene) {
  std::vector<DrawId> draws;
  for (DrawId id = 0; id < scene.draws.size(); ++id) {
    if (!scene.draws[id].traits.has(traits::extended)) draws.push_back(id);
  }
  return draws;
}

/// [draw] The places where it is drawn, a matrix each, by their translations: nothing stands twice at one place.
using Matrix = std::array<float, 16>;
std::map<DrawId, std::vector<Matrix>> places_of(const Scene& scene) {
  std::map<DrawId, std::vector<Matrix>> places;
  const std::vector<glm::mat4> world = world_transforms(scene);
  for (NodeId n = 0; n < scene.nodes.size(); ++n) {
    const Node& node = scene.nodes[n];
    if (!node.mesh) continue;
    std::vector<glm::mat4> drawn;
    for (const Transform& instance : node.instances.view()) drawn.push_back(world[n] * instance.matrix());
    if (drawn.empty()) drawn.push_back(world[n]);
    for (const glm::mat4& m : drawn) {
      Matrix numbers{};
      std::copy_n(&m[0][0], 16, numbers.begin());
      for (const DrawId id : scene.meshes[*node.mesh].draws) places[id].push_back(numbers);
    }
  }
  for (auto& [id, matrices] : places) {
    std::ranges::sort(matrices, {}, [](const Matrix& m) { return std::array{m[12], m[13], m[14], m[0]}; });
  }
  return places;
}

void expect_same_places(const Scene& before, const Scene& after) {
  const auto was = places_of(before), is = places_of(after);
  ASSERT_EQ(was.size(), is.size());
  for (const auto& [id, matrices] : was) {
    const std::vector<Matrix>& now = is.at(id);
    ASSERT_EQ(now.size(), matrices.size()) << before.draws[id].name;
    for (std::size_t i = 0; i < now.size(); ++i) {
      float greatest = 0, difference = 0;
      for (std::size_t k = 0; k < 16; ++k) {
        greatest = std::max(greatest, std::abs(matrices[i][k]));
        difference = std::max(difference, std::abs(matrices[i][k] - now[i][k]));
      }
      ASSERT_LE(difference, 1e-6f * greatest) << before.draws[id].name << " at its place " << i;
    }
  }
}

TEST(KitInstances, each_mesh_is_drawn_by_a_node_and_stands_where_it_stood) {
  const Scene plain = space(0);
  Scene made = plain;
  const InstancedNodes nodes = gpu_instances(made, free_draws(made), {.least = 2});
  const Scene after = through_file(made);
  expect_same_places(plain, after);
  const SceneCost was = scene_cost(plain), is = scene_cost(after);
  EXPECT_EQ(is.instances, was.instances);
  EXPECT_EQ(is.indices, was.indices);
  EXPECT_GE(was.draws, 3000u);
  EXPECT_LE(is.draws, after.draws.size());
  EXPECT_EQ(after.nodes.size(), plain.nodes.size() + nodes.meshes.size());
  for (std::size_t n = plain.nodes.size(); n < after.nodes.size(); ++n) {
    EXPECT_EQ(after.nodes[n].instances, made.nodes[n].instances);
  }
}

TEST(KitInstances, mirrored_ones_stay) {
  const Scene plain = space(0.3);
  Scene made = plain;
  gpu_instances(made, free_draws(made));
  const Scene after = through_file(made);
  expect_same_places(plain, after);
  EXPECT_LT(scene_cost(after).draws, scene_cost(plain).draws / 2);
  EXPECT_GT(scene_cost(after).draws, 3000 / 5u);
}

/// With the draws of the meshes merged whose number is `even` or not; as merge-instances does it.
Scene merged_half(const Scene& plain, bool even) {
  std::vector<DrawId> draws;
  for (MeshId m = even ? 0 : 1; m < plain.meshes.size(); m += 2) {
    draws.insert(draws.end(), plain.meshes[m].draws.begin(), plain.meshes[m].draws.end());
  }
  std::ranges::sort(draws);
  Scene scene = plain;
  const MergedScene sets = merge_scene(plain, draws, {}, Executor(2));
  for (const MergedSet& set : sets.merged) {
    testing::edit<MergedDraws>(scene)->sets.push_back(merged_instances(plain, set));
    for (const processors::merge_instances::MergeableMesh& mesh : set.set.meshes)
      scene.draws[mesh.draw].traits.add(traits::extended);
  }
  return scene;
}

/// What is merged stays for whoever knows nothing of merged draws; the meshes that are not are instanced.
TEST(KitInstances, what_merging_left_is_instanced) {
  const Scene plain = space(0);
  for (const bool even : {true, false}) {
    const Scene merged = merged_half(plain, even);
    ASSERT_FALSE(merged_sets(merged).empty());
    Scene made = merged;
    gpu_instances(made, free_draws(made));
    const Scene after = through_file(made);
    expect_same_places(plain, after);
    EXPECT_EQ(merged_places(after), merged_places(merged));
    for (const MergedPlace& place : merged_places(after)) {
      EXPECT_EQ(after.nodes[place.node].mesh, plain.nodes[place.node].mesh);
    }
    const std::uint64_t by_merging = scene_cost(merged).draws;
    EXPECT_LT(by_merging, scene_cost(plain).draws);
    EXPECT_LT(scene_cost(after).draws, by_merging / 2);
    EXPECT_EQ(scene_cost(after).instances, 3000u);
  }
}

/// Though a caller may give all draws: what merged draws show is not taken away from under them.
TEST(KitInstances, merged_places_stay_whatever_draws_are_given) {
  Scene scene = merged_half(space(0), true);
  std::vector<DrawId> draws;
  for (DrawId id = 0; id < scene.draws.size(); ++id) draws.push_back(id);
  gpu_instances(scene, draws);
  for (const MergedPlace& place : merged_places(scene)) EXPECT_TRUE(scene.nodes[place.node].mesh.has_value());
}

/// The other way round merging weighs what instancing left: there are never more draws than by instancing alone.
TEST(KitInstances, what_is_instanced_is_merged_where_that_saves_more) {
  Scene made = space(0);
  gpu_instances(made, free_draws(made));
  const std::uint64_t by_instancing = scene_cost(made).draws;
  const MergedScene sets = merge_scene(made, free_draws(made), {}, Executor(2));
  for (const MergedSet& set : sets.merged)
    testing::edit<MergedDraws>(made)->sets.push_back(merged_instances(made, set));
  const Scene after = through_file(made);
  EXPECT_LE(scene_cost(after).draws, by_instancing);
  EXPECT_EQ(scene_cost(after).instances, 3000u);
}

}  // namespace
}  // namespace foredraw::bench::kit_instances_test

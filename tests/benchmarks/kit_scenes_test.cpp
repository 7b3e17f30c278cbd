// Scenes of many instances that are made of the kits of the corpus.
#include "gpu_instancing.h"
#include "layout.h"

#include "evaluators/scene_cost/scene_cost.h"
#include "support/gltf_builder.h"
#include "support/meshes.h"

#include <foredraw/io/gltf/gltf.h>

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

namespace foredraw::bench::kit_scenes_test {
namespace {

Kit city_kit() { return read_kit(testing::project_file("benchmarks/corpus/scenes/kaykit_city")); }
Kit space_kit() { return read_kit(testing::project_file("benchmarks/corpus/scenes/kenney_space_kit")); }

std::vector<std::byte> written(const Scene& scene) {
  Diagnostics diagnostics;
  const auto files = encode_gltf(scene, "made.glb", diagnostics);
  if (!files) throw std::runtime_error(to_text(diagnostics));
  return files->front().bytes;
}

Scene read_again(const Scene& scene) {
  Diagnostics diagnostics;
  auto read = read_gltf(written(scene), "made.glb", {}, diagnostics);
  if (!read) throw std::runtime_error(to_text(diagnostics));
  return *read;
}

TEST(KitScenes, materials_of_equal_content_are_one_and_keep_all_that_they_say) {
  const Kit city = city_kit();
  EXPECT_EQ(city.models.size(), 10u);
  EXPECT_EQ(city.scene.meshes.size(), 18u);
  EXPECT_EQ(city.scene.materials.size(), 1u);
  EXPECT_EQ(city.scene.images.size(), 1u);
  EXPECT_TRUE(city.scene.images[0].facts.has_value());
  const testing::GltfJson json = testing::json_of(written(placed_scene(city, {}, "empty")));
  EXPECT_EQ(json["materials"][0]["pbrMetallicRoughness"]["roughnessFactor"], 0.4000000059604645);
  EXPECT_EQ(json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"], 0);

  const Kit space = space_kit();
  EXPECT_EQ(space.models.size(), 12u);
  const testing::GltfJson of_space = testing::json_of(written(placed_scene(space, {}, "empty")));
  std::set<std::string> colours;
  for (const auto& material : of_space["materials"]) {
    colours.insert(material["pbrMetallicRoughness"]["baseColorFactor"].dump());
  }
  EXPECT_EQ(colours.size(), of_space["materials"].size());
  EXPECT_GT(colours.size(), 5u);
}

TEST(KitScenes, models_stand_at_the_origin_with_all_their_parts) {
  const Kit space = space_kit();
  const KitModel& alien = space.models[space.model("alien")];
  EXPECT_EQ(alien.nodes.size(), 7u);
  EXPECT_EQ(alien.primitives, 18u);
  EXPECT_EQ(alien.nodes[0].transform.translation, glm::vec3(0));
  EXPECT_EQ(alien.nodes[0].children.size(), 6u);
  EXPECT_EQ(alien.nodes[4].transform.scale, glm::vec3(0.26f));
  EXPECT_THROW(space.model("taxi"), std::runtime_error);
  EXPECT_THROW(read_kit(testing::project_file("docs")), std::runtime_error);
}

TEST(KitScenes, there_are_as_many_primitives_as_were_asked_for) {
  const Kit city = city_kit(), space = space_kit();
  for (const std::uint64_t instances : {1, 700, 10'000}) {
    for (const Scene& scene : {placed_scene(city, city_layout(city, {.instances = instances}), "city"),
                               placed_scene(space, space_layout(space, {.instances = instances}), "space")}) {
      const SceneCost cost = scene_cost(scene);
      EXPECT_GE(cost.draws, instances);
      EXPECT_LT(cost.draws, instances + 20);
      EXPECT_EQ(cost.instances, cost.draws);
    }
  }
}

TEST(KitScenes, the_seed_decides_and_a_larger_scene_holds_the_smaller_one) {
  for (const bool is_city : {true, false}) {
    const Kit kit = is_city ? city_kit() : space_kit();
    const auto placed = [&](const LayoutOptions& options) {
      return written(placed_scene(kit, is_city ? city_layout(kit, options) : space_layout(kit, options), "scene"));
    };
    EXPECT_EQ(placed({.instances = 500, .seed = 3}), placed({.instances = 500, .seed = 3}));
    EXPECT_NE(placed({.instances = 500, .seed = 3}), placed({.instances = 500, .seed = 4}));
    const auto few = is_city ? city_layout(kit, {.instances = 500}) : space_layout(kit, {.instances = 500});
    const auto many = is_city ? city_layout(kit, {.instances = 5000}) : space_layout(kit, {.instances = 5000});
    ASSERT_LT(few.size(), many.size());
    for (std::size_t i = 0; i < few.size(); ++i) {
      EXPECT_EQ(few[i].model, many[i].model);
      EXPECT_EQ(few[i].transform.translation, many[i].transform.translation);
    }
  }
}

TEST(KitScenes, models_are_mirrored_as_often_as_asked) {
  const Kit kit = city_kit();
  const auto part = [&](double mirrored) {
    const auto placements = city_layout(kit, {.instances = 4000, .mirrored = mirrored});
    const auto count = std::ranges::count_if(placements, [](const Placement& p) { return p.transform.scale.x < 0; });
    return static_cast<double>(count) / static_cast<double>(placements.size());
  };
  EXPECT_EQ(part(0), 0);
  EXPECT_NEAR(part(0.25), 0.25, 0.05);
  EXPECT_EQ(part(1), 1);
}

TEST(KitScenes, gpu_instancing_shows_the_same_by_one_node_for_each_mesh) {
  const Kit kit = space_kit();
  const Scene plain = placed_scene(kit, space_layout(kit, {.instances = 2000, .mirrored = 0.3}), "space");
  const Scene instanced = read_again(with_gpu_instancing(plain));
  const SceneCost before = scene_cost(plain), after = scene_cost(instanced);
  EXPECT_EQ(after.instances, before.instances);
  EXPECT_EQ(after.indices, before.indices);
  EXPECT_EQ(after.instance_bytes, before.instance_bytes);
  EXPECT_EQ(after.draws_if_instanced, before.draws_if_instanced);
  EXPECT_LE(after.draws, instanced.draws.size());
  EXPECT_LE(instanced.nodes.size(), instanced.meshes.size());
  Scene sheared = plain;
  sheared.nodes[0].matrix = glm::mat4(1);
  (*sheared.nodes[0].matrix)[0][1] = 0.5f;
  sheared.nodes[0].mesh = 0;
  EXPECT_THROW(with_gpu_instancing(sheared), std::runtime_error);
}

}  // namespace
}  // namespace foredraw::bench::kit_scenes_test

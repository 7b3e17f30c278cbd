// Which nodes may lose their mesh to another one that draws it many times, and such scenes written and read again.
#include <gtest/gtest.h>

#include "framework/io/gltf/edits.h"
#include "support/gltf_builder.h"

namespace foredraw::kept_meshes_test {
namespace {

using namespace foredraw::testing;

/// A ribbon that nodes 0, 2 and 3 place, 2 below 1, and 4 once more, by itself.
GltfBuilder placed_ribbon() {
  GltfBuilder builder = ribbon(2);
  builder.json["nodes"][0]["name"] = "first";
  builder.json["nodes"][0]["translation"] = {1, 2, 3};
  builder.add("nodes", {{"translation", {10, 0, 0}}, {"children", {2}}});
  builder.add("nodes", {{"mesh", 0}, {"extras", {{"tag", 7}}}});
  builder.add("nodes", {{"mesh", 0}, {"scale", {2, 2, 2}}});
  builder.add("nodes", {{"mesh", 0}});
  builder.json["scenes"] = {{{"nodes", {0, 1, 3, 4}}}};
  builder.json["scene"] = 0;
  return builder;
}

std::string kept(const GltfBuilder& builder) {
  std::string kept;
  for (const Node& node : read(builder).nodes) kept += node.keeps_mesh ? 'k' : '.';
  return kept;
}

/// The scene with the mesh of nodes 0, 2 and 3 drawn by a new one.
Scene with_instances(Scene scene) {
  Node node;
  node.name = "ribbons";
  node.mesh = scene.nodes[0].mesh;
  std::vector<Transform> transforms{scene.nodes[0].transform, scene.nodes[1].transform, scene.nodes[3].transform};
  node.instances = Shared<Transform>(transforms);
  for (const NodeId id : {0, 2, 3}) scene.nodes[id].mesh.reset();
  scene.nodes.push_back(node);
  return scene;
}

TEST(GltfKeptMeshes, a_mesh_taken_from_nodes_is_written_and_read_again) {
  const Scene scene = with_instances(read(placed_ribbon()));
  const Scene again = read(write(scene));
  ASSERT_EQ(again.nodes.size(), 6u);
  EXPECT_EQ(again.nodes[5].instances, scene.nodes[5].instances);
  for (NodeId id = 0; id < 6; ++id) {
    EXPECT_EQ(again.nodes[id].mesh, scene.nodes[id].mesh);
    EXPECT_EQ(again.nodes[id].name, scene.nodes[id].name);
    EXPECT_EQ(again.nodes[id].local(), scene.nodes[id].local());
    EXPECT_EQ(again.nodes[id].children, scene.nodes[id].children);
  }
  EXPECT_EQ(write(again), write(scene));

  const GltfJson json = written(scene), before = placed_ribbon().json;
  EXPECT_EQ(json["scenes"][0]["nodes"], GltfJson::array({0, 1, 3, 4, 5}));
  EXPECT_EQ(json["nodes"][2].dump(), R"({"extras":{"tag":7}})") << "all but the mesh";
  EXPECT_EQ(json["nodes"][4], before["nodes"][4]);
  EXPECT_EQ(json["meshes"], before["meshes"]);
  EXPECT_EQ(json["extensionsRequired"], GltfJson::array({"EXT_mesh_gpu_instancing"}));
}

TEST(GltfKeptMeshes, instancing_that_was_optional_is_required) {
  GltfBuilder builder = placed_ribbon();
  const auto places = builder.add_values(std::vector<float>{1, 0, 0, 2, 0, 0}, "VEC3");
  builder.json["nodes"][4]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"TRANSLATION", places}};
  builder.json["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
  EXPECT_EQ(kept(builder), ".....");
  const GltfJson json = written(with_instances(read(builder)));
  EXPECT_EQ(json["extensionsUsed"], builder.json["extensionsUsed"]);
  EXPECT_EQ(json["extensionsRequired"], builder.json["extensionsUsed"]);
}

TEST(GltfKeptMeshes, what_the_default_scene_alone_shows_may_go) {
  GltfBuilder builder = placed_ribbon();
  EXPECT_EQ(kept(builder), ".....");
  builder.json.erase("scene");
  EXPECT_EQ(kept(builder), ".....") << "the first scene is the one that is shown";
  builder.json["scenes"].push_back({{"nodes", {1}}});
  EXPECT_EQ(kept(builder), ".kk..");
  builder.json["scene"] = 1;
  EXPECT_EQ(kept(builder), "kkkkk") << "two show 1 and 2, and the default one none of the others";
  builder.json["scenes"] = {{{"nodes", {0, 2, 3, 3}}}};
  builder.json["scene"] = 0;
  EXPECT_EQ(kept(builder), ".kkkk") << "without its parent, and twice";
  builder.json.erase("scene");
  builder.json.erase("scenes");
  EXPECT_EQ(kept(builder), "kkkkk");
}

TEST(GltfKeptMeshes, extensions_keep_what_they_may_speak_of) {
  const auto with = [](auto&& change) {
    GltfBuilder builder = placed_ribbon();
    change(builder.json);
    return kept(builder);
  };
  const GltfJson some = {{"visible", false}};
  EXPECT_EQ(with([&](GltfJson& j) { j["nodes"][1]["extensions"]["KHR_node_visibility"] = some; }), ".kk..");
  EXPECT_EQ(with([&](GltfJson& j) { j["nodes"][3]["extensions"]["ACME_tag"] = some; }), "...k.");
  EXPECT_EQ(with([&](GltfJson& j) { j["nodes"][3]["extensions"]["KHR_lights_punctual"] = some; }), ".....");
  EXPECT_EQ(with([&](GltfJson& j) { j["nodes"][3]["extras"]["ACME_tag"] = some; }), ".....");
  EXPECT_EQ(with([&](GltfJson& j) { j["extensions"]["ACME_tags"] = some; }), "kkkkk");
  EXPECT_EQ(with([&](GltfJson& j) { j["scenes"][0]["extensions"]["ACME_tags"] = some; }), "kkkkk");
  EXPECT_EQ(with([&](GltfJson& j) { j["extensions"]["KHR_materials_variants"] = some; }), ".....");
}

TEST(GltfKeptMeshes, animations_that_aim_by_a_pointer_keep_nodes_alone) {
  const auto aimed = [](const char* pointer) {
    GltfBuilder builder = placed_ribbon();
    const auto times = builder.add_values(std::vector<float>{0, 1}, "SCALAR");
    builder.json["accessors"][times]["min"] = {0.0f};
    builder.json["accessors"][times]["max"] = {1.0f};
    GltfJson target{{"path", "pointer"}};
    target["extensions"]["KHR_animation_pointer"] = {{"pointer", pointer}};
    builder.add("animations", {{"samplers", {{{"input", times}, {"output", times}}}},
                               {"channels", {{{"sampler", 0}, {"target", target}}}}});
    return kept(builder);
  };
  EXPECT_EQ(aimed("/materials/0/alphaCutoff"), ".....");
  EXPECT_EQ(aimed("/nodes/1/translation"), "kkkkk");
}

TEST(GltfKeptMeshes, a_mesh_that_stays_is_not_written_away) {
  GltfBuilder builder = placed_ribbon();
  builder.json["nodes"][3]["extensions"]["ACME_tag"] = GltfJson::object();
  Diagnostics diagnostics;
  EXPECT_FALSE(encode_gltf(with_instances(read(builder)), "out.glb", diagnostics));
  ASSERT_EQ(diagnostics.all().size(), 1u);
  EXPECT_EQ(diagnostics.all()[0].code, "cannot-express");
  EXPECT_EQ(diagnostics.all()[0].where.inside, "nodes[3]");

  Scene scene = read(placed_ribbon());
  scene.nodes[1].mesh = 0;
  Diagnostics of_another;
  EXPECT_FALSE(encode_gltf(scene, "out.glb", of_another)) << "a mesh given to a node that had none";
}

}  // namespace
}  // namespace foredraw::kept_meshes_test

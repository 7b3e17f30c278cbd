// Files of which the sides must stay come out byte for byte; and one that may change does change.

#include "support/gltf_builder.h"

#include <foredraw/io/gltf/gltf.h>
#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/runner.h>
#include <foredraw/technique/built_in_plugins.h>

#include <gtest/gtest.h>

#include <stdexcept>

namespace foredraw {
namespace {

using testing::GltfBuilder, testing::GltfJson;

std::size_t add_box(GltfBuilder& builder) {
  std::vector<float> positions;
  for (int i = 0; i < 8; ++i) {
    for (const int bit : {1, 2, 4}) positions.push_back(i & bit ? 1.f : -1.f);
  }
  const std::vector<std::uint16_t> indices = {0, 2, 1, 1, 2, 3, 0, 1, 4, 1, 5, 4, 0, 4, 2, 2, 4, 6,
                                              1, 3, 5, 3, 7, 5, 2, 6, 3, 3, 6, 7, 4, 5, 6, 5, 7, 6};
  const std::size_t position = builder.add_values(positions, "VEC3");
  builder.json["accessors"][position]["min"] = {-1, -1, -1};
  builder.json["accessors"][position]["max"] = {1, 1, 1};
  return builder.add_mesh(
      {{"attributes", {{"POSITION", position}}}, {"indices", builder.add_values(indices, "SCALAR")}, {"material", 0}});
}

/// A box whose material is double-sided without need.
GltfBuilder box() {
  GltfBuilder builder;
  builder.add("materials", {{"name", "skin"}, {"doubleSided", true}});
  add_box(builder);
  return builder;
}

std::vector<std::byte> encoded(const Scene& scene) {
  Diagnostics diagnostics;
  const auto files = encode_gltf(scene, "out.glb", diagnostics);
  if (!files) throw std::runtime_error(to_text(diagnostics));
  return (*files)[0].bytes;
}

Scene with_fewer_sides(const Scene& scene) {
  Diagnostics diagnostics;
  Registry registry;
  add_built_in_plugins(registry);
  auto pipeline = load_pipeline("sides", diagnostics);
  const auto plan = pipeline ? foredraw::plan(*pipeline, registry, scene, diagnostics) : std::nullopt;
  if (!plan) throw std::runtime_error(to_text(diagnostics));
  const Executor executor(2);
  Analyses analyses;
  return optimize(*plan, scene, {executor, analyses}).scene;
}

/// Whether the file comes out otherwise than it would without the stage.
bool changes(const GltfBuilder& builder) {
  Diagnostics diagnostics;
  const auto scene = read_gltf(builder.glb(), "box.glb", "", diagnostics);
  if (!scene) throw std::runtime_error(to_text(diagnostics));
  return encoded(with_fewer_sides(*scene)) != encoded(*scene);
}

TEST(SidesVetoes, AClosedBoxChanges) { EXPECT_TRUE(changes(box())); }

TEST(SidesVetoes, WhatLightPassesThroughStays) {
  GltfBuilder blended = box();
  blended.json["materials"][0]["alphaMode"] = "BLEND";
  EXPECT_FALSE(changes(blended));
  for (const char* extension : {"KHR_materials_transmission", "KHR_materials_volume"}) {
    GltfBuilder passing = box();
    passing.json["extensionsUsed"] = {extension};
    passing.json["materials"][0]["extensions"][extension] = GltfJson::object();
    EXPECT_FALSE(changes(passing)) << extension;
  }
}

/// Its image is in no file, so nobody knows what its holes show.
TEST(SidesVetoes, HolesThatAreNotKnownStay) {
  GltfBuilder masked = box();
  masked.json["materials"][0]["alphaMode"] = "MASK";
  masked.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 0;
  masked.add("images", {{"uri", "not_there.png"}});
  masked.add("textures", {{"source", 0}});
  EXPECT_FALSE(changes(masked));
}

TEST(SidesVetoes, AnAnimatedMaterialStays) {
  GltfBuilder moving = box();
  moving.json["extensionsUsed"] = {"KHR_animation_pointer"};
  const std::size_t times = moving.add_values(std::vector<float>{0, 1}, "SCALAR");
  moving.json["accessors"][times]["min"] = {0};
  moving.json["accessors"][times]["max"] = {1};
  const std::size_t values = moving.add_values(std::vector<float>{0, 1}, "SCALAR");
  const GltfJson pointer = {{"pointer", "/materials/0/alphaCutoff"}};
  const GltfJson target = {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", pointer}}}};
  moving.add("animations", {{"channels", {{{"sampler", 0}, {"target", target}}}},
                            {"samplers", {{{"input", times}, {"output", values}}}}});
  EXPECT_FALSE(changes(moving));
}

/// A second node shows the same box inside out: of both, fronts of the mesh are what is seen.
TEST(SidesVetoes, MirroredNodesChangeAlike) {
  GltfBuilder mirrored = box();
  const std::size_t second = mirrored.add("nodes", {{"mesh", 0}, {"scale", {-1, 1, 1}}, {"translation", {5, 0, 0}}});
  if (mirrored.json.contains("scenes")) mirrored.json["scenes"][0]["nodes"].push_back(second);
  EXPECT_TRUE(changes(mirrored));
}

/// Another draw with the same material, blended or not, keeps its own.
TEST(SidesVetoes, ASharedMaterialIsCopied) {
  GltfBuilder shared = box();
  const std::size_t sheet = shared.add_values(std::vector<float>{5, 0, 0, 6, 0, 0, 5, 1, 0}, "VEC3");
  shared.json["accessors"][sheet]["min"] = {5, 0, 0};
  shared.json["accessors"][sheet]["max"] = {6, 1, 0};
  shared.add_mesh({{"attributes", {{"POSITION", sheet}}}, {"material", 0}});
  Diagnostics diagnostics;
  const auto scene = read_gltf(shared.glb(), "shared.glb", "", diagnostics);
  ASSERT_TRUE(scene) << to_text(diagnostics);
  const Scene after = with_fewer_sides(*scene);
  EXPECT_FALSE(after.material_of(after.draws[0])->double_sided);
  EXPECT_TRUE(after.material_of(after.draws[1])->double_sided);
  EXPECT_TRUE(after.materials[0].double_sided);
}

}  // namespace
}  // namespace foredraw

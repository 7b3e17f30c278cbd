// Files of which the sides must stay come out byte for byte; and one that may change does change.

#include "sides_files.h"

#include <gtest/gtest.h>

namespace foredraw::sides_vetoes_test {
namespace {

using testing::changes, testing::decoded, testing::with_fewer_sides;
using testing::GltfBuilder, testing::GltfJson;

GltfBuilder box() { return testing::box_file(); }

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

GltfBuilder with_variant(bool is_double_sided) {
  GltfBuilder builder = box();
  builder.add("materials", {{"name", "other"}, {"doubleSided", is_double_sided}});
  builder.json["extensionsUsed"] = {"KHR_materials_variants"};
  builder.json["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "worn"}}};
  builder.json["meshes"][0]["primitives"][0]["extensions"]["KHR_materials_variants"]["mappings"] = {
      {{"material", 1}, {"variants", {0}}}};
  return builder;
}

/// One of two materials would show the sides that the other one does not.
TEST(SidesVetoes, VariantsThatShowOtherSidesStay) {
  EXPECT_FALSE(changes(with_variant(false)));
  EXPECT_TRUE(changes(with_variant(true)));
}

/// Another draw with the same material, blended or not, keeps its own.
TEST(SidesVetoes, ASharedMaterialIsCopied) {
  GltfBuilder shared = box();
  const std::size_t sheet = shared.add_values(std::vector<float>{5, 0, 0, 6, 0, 0, 5, 1, 0}, "VEC3");
  shared.json["accessors"][sheet]["min"] = {5, 0, 0};
  shared.json["accessors"][sheet]["max"] = {6, 1, 0};
  shared.add_mesh({{"attributes", {{"POSITION", sheet}}}, {"material", 0}});
  const Scene after = with_fewer_sides(decoded(shared.glb())).scene;
  EXPECT_FALSE(after.material_of(after.draws[0])->double_sided);
  EXPECT_TRUE(after.material_of(after.draws[1])->double_sided);
  EXPECT_TRUE(after.materials[0].double_sided);
}

}  // namespace
}  // namespace foredraw::sides_vetoes_test

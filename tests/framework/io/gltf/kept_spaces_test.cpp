// Materials of which the draws keep their units and texture coordinates.
#include <gtest/gtest.h>

#include "framework/io/gltf/edits.h"
#include "support/gltf_builder.h"

namespace foredraw::kept_spaces_test {
namespace {

using testing::GltfBuilder;
using testing::GltfJson;

/// Two draws of materials 0 and 1, materials 2 and 3 for whoever names them.
GltfBuilder painted() {
  GltfBuilder builder = testing::ribbon(2);
  for (const char* name : {"a", "b", "c", "d"}) builder.add("materials", {{"name", name}});
  GltfJson& primitives = builder.json["meshes"][0]["primitives"];
  primitives.push_back(primitives[0]);
  for (std::size_t m = 0; m < 2; ++m) primitives[m]["material"] = m;
  return builder;
}

std::string kept(const GltfBuilder& builder) {
  std::string kept;
  for (const Material& material : testing::read(builder).materials) kept += material.keeps_spaces ? 'k' : '.';
  return kept;
}

TEST(GltfKeptSpaces, AreThoseOfVariantsAndOfWhatTheyStandFor) {
  GltfBuilder builder = painted();
  EXPECT_EQ(kept(builder), "....");
  GltfJson& extension = builder.json["meshes"][0]["primitives"][1]["extensions"]["KHR_materials_variants"];
  extension["mappings"] = {{{"material", 2}, {"variants", {0}}}};
  EXPECT_EQ(kept(builder), ".kk.");
  extension["mappings"][0]["material"] = 1;
  EXPECT_EQ(kept(builder), ".k..") << "it stands for a copy of itself, should a stage make one";
  extension["mappings"] = GltfJson::array();
  EXPECT_EQ(kept(builder), "....");
  extension["mappings"] = {{{"material", 3}, {"variants", {0}}}};
  builder.json["meshes"][0]["primitives"][1].erase("material");
  EXPECT_EQ(kept(builder), "...k");
}

TEST(GltfKeptSpaces, AreThoseOfCoarserMaterials) {
  GltfBuilder builder = painted();
  builder.json["materials"][0]["extensions"]["MSFT_lod"]["ids"] = {2, 77};
  EXPECT_EQ(kept(builder), "k.k.");
}

TEST(GltfKeptSpaces, AreThoseOfAnimatedMaterials) {
  GltfBuilder builder = painted();
  const auto input = builder.add_values(std::vector<float>{0, 1}, "SCALAR");
  const auto output = builder.add_values(std::vector<float>{0, 1}, "SCALAR");
  GltfJson target = {{"path", "pointer"}};
  target["extensions"]["KHR_animation_pointer"]["pointer"] = "/materials/1/pbrMetallicRoughness/roughnessFactor";
  GltfJson animation;
  animation["samplers"] = {{{"input", input}, {"output", output}}};
  animation["channels"] = {{{"sampler", 0}, {"target", target}}};
  builder.add("animations", animation);
  EXPECT_EQ(kept(builder), ".k..");
}

TEST(GltfKeptSpaces, AreThoseOfMaterialsOfWhichWeDoNotKnowAll) {
  GltfBuilder builder = painted();
  GltfJson& materials = builder.json["materials"];
  materials[0]["extensions"]["KHR_materials_clearcoat"]["clearcoatFactor"] = 1;
  materials[1]["extensions"]["ACME_fur"]["length"] = 0.2;
  materials[2]["extensions"]["KHR_materials_sheen"]["extensions"]["ACME_fur"]["length"] = 0.2;
  materials[3]["extras"]["extensions"]["ACME_fur"]["length"] = 0.2;
  EXPECT_EQ(kept(builder), ".kk.");
}

TEST(GltfKeptSpaces, AreThoseOfMovedSurfacesOfWhichTheMapIsMissing) {
  GltfBuilder builder = painted();
  builder.json["materials"][2]["extensions"]["KHR_materials_displacement"]["displacementGeometryOffset"] = 1;
  EXPECT_EQ(kept(builder), "..k.");
}

}  // namespace
}  // namespace foredraw::kept_spaces_test

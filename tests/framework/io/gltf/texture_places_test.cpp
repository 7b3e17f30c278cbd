// Texture coordinates that a stage put into other units, in KHR_texture_transform of all that looks them up.
#include <foredraw/scene/scaled_texcoords.h>

#include <gtest/gtest.h>

#include "framework/io/gltf/edits.h"
#include "support/gltf_builder.h"

namespace foredraw::texture_places_test {
namespace {

using testing::GltfBuilder;
using testing::GltfJson;

constexpr const char* transform = "KHR_texture_transform";
constexpr ScaledTexcoords change = {.set = 0, .offset = {-0.3, 0.7}, .scale = {1.0 / 3, 0x1.8p-12}};

GltfJson use(std::size_t set = 0) {
  GltfJson use = {{"index", 0}};
  if (set > 0) use["texCoord"] = set;
  return use;
}

GltfJson moved_use() {
  GltfJson moved = use();
  moved["extensions"][transform] = {{"rotation", 0.3}, {"scale", {0.1, -7}}, {"myOwn", "word"}};
  return moved;
}

/// A ribbon whose material looks up a texture everywhere.
GltfBuilder painted() {
  GltfBuilder builder = testing::ribbon(2);
  builder.add("textures", {{"name", "any"}});
  GltfJson material = {{"name", "paint"}};
  material["pbrMetallicRoughness"]["baseColorTexture"] = moved_use();
  material["normalTexture"] = use();
  material["normalTexture"]["scale"] = 0.5;
  material["occlusionTexture"] = use(1);
  for (const char* name : {"clearcoat", "sheen", "transmission", "volume"}) {
    material["extensions"][std::string("KHR_materials_") + name]["oneTexture"] = use();
  }
  material["extensions"]["KHR_materials_displacement"] = {{"displacementGeometryTexture", use()}};
  material["extras"]["otherTexture"] = use();
  builder.json["materials"] = {material};
  builder.json["meshes"][0]["primitives"][0]["material"] = 0;
  return builder;
}

Scene scaled(const GltfBuilder& builder) {
  Scene scene = testing::read(builder);
  scene.materials[0] = with_scaled_texcoords(scene.materials[0], change);
  return scene;
}

const GltfJson& place_in(const GltfJson& use) { return use.at("extensions").at(transform); }

TEST(GltfTexturePlaces, AreThoseOfEveryTextureOfTheSet) {
  const GltfJson json = testing::written(scaled(painted()));
  const GltfJson& material = json["materials"][0];
  const GltfJson plain = {{"offset", {change.offset.x, change.offset.y}}, {"scale", {change.scale.x, change.scale.y}}};
  EXPECT_EQ(place_in(material["normalTexture"]), plain);
  EXPECT_EQ(material["normalTexture"]["scale"], 0.5);
  for (const char* name : {"clearcoat", "sheen", "transmission", "volume"}) {
    EXPECT_EQ(place_in(material["extensions"][std::string("KHR_materials_") + name]["oneTexture"]), plain) << name;
  }
  EXPECT_EQ(place_in(material["extensions"]["KHR_materials_displacement"]["displacementGeometryTexture"]), plain);
  EXPECT_EQ(material["occlusionTexture"], use(1));
  EXPECT_EQ(material["extras"]["otherTexture"], use());
  const GltfJson& moved = place_in(material["pbrMetallicRoughness"]["baseColorTexture"]);
  EXPECT_EQ(moved["rotation"], 0.3);
  EXPECT_EQ(moved["myOwn"], "word");
  EXPECT_EQ(json["extensionsRequired"], GltfJson({transform}));
}

TEST(GltfTexturePlaces, ReadBackAreTheSameToTheLastBit) {
  Scene scene = scaled(painted());
  for (int times = 0; times < 3; ++times) {
    const Material again = testing::read(testing::write(scene)).materials[0];
    EXPECT_EQ(again.base_colour, scene.materials[0].base_colour) << times;
    EXPECT_EQ(again.normal_map, scene.materials[0].normal_map) << times;
    EXPECT_EQ(again.displacement, scene.materials[0].displacement) << times;
    scene.materials[0] = with_scaled_texcoords(scene.materials[0], change);
  }
}

TEST(GltfTexturePlaces, AreOfTheSetThatTheTransformNames) {
  GltfBuilder builder = painted();
  GltfJson& material = builder.json["materials"][0];
  const auto named = [](std::size_t outer, std::size_t inner) {
    GltfJson both = use(outer);
    both["extensions"][transform] = {{"texCoord", inner}};
    return both;
  };
  material["emissiveTexture"] = named(0, 1);
  material["occlusionTexture"] = named(1, 0);
  const GltfJson json = testing::written(scaled(builder))["materials"][0];
  EXPECT_EQ(json["emissiveTexture"], named(0, 1)) << "looked up by the other set, whatever stands outside";
  EXPECT_EQ(place_in(json["occlusionTexture"])["texCoord"], 0);
  EXPECT_EQ(place_in(json["occlusionTexture"])["scale"], GltfJson({change.scale.x, change.scale.y}));
}

TEST(GltfTexturePlaces, OddTransformsCountAsNone) {
  GltfBuilder builder = painted();
  GltfJson& material = builder.json["materials"][0];
  material["emissiveTexture"] = use();
  material["emissiveTexture"]["extensions"][transform] = 7;
  material["normalTexture"]["extensions"][transform] = {{"scale", "wide"}, {"offset", {1}}, {"rotation", {}}};
  const Scene scene = scaled(builder);
  const GltfJson json = testing::written(scene)["materials"][0];
  EXPECT_EQ(place_in(json["emissiveTexture"])["scale"], GltfJson({change.scale.x, change.scale.y}));
  EXPECT_EQ(testing::read(testing::write(scene)).materials[0].normal_map, scene.materials[0].normal_map);
}

TEST(GltfTexturePlaces, OfAMaterialWithoutTexturesAreNotThere) {
  GltfBuilder builder = painted();
  builder.json["materials"][0] = {{"name", "plain"}};
  const GltfJson json = testing::written(scaled(builder));
  EXPECT_EQ(json["materials"][0], GltfJson({{"name", "plain"}}));
  EXPECT_FALSE(json.contains("extensionsRequired"));
}

TEST(GltfTexturePlaces, OfACopyAndOfTheFirstAreTheirOwn) {
  Scene scene = testing::read(painted());
  Material copy = scene.materials[0];
  copy.copy_of = 0;
  scene.materials.push_back(copy);
  scene.materials[0] = with_scaled_texcoords(scene.materials[0], change);
  const Scene again = testing::read(testing::write(scene));
  for (std::size_t m = 0; m < 2; ++m) EXPECT_EQ(again.materials[m].base_colour, scene.materials[m].base_colour) << m;
  EXPECT_NE(again.materials[0].base_colour, again.materials[1].base_colour);
}

TEST(GltfTexturePlaces, OfATextureThatAStagePutIsWrittenOnce) {
  Scene scene = testing::read(testing::ribbon(2));
  scene.images.push_back({.name = "any", .uri = "any.png"});
  Material material{.name = "new", .base_colour = Texture{.image = 0}};
  scene.materials.push_back(with_scaled_texcoords(material, change));
  scene.draws[0].material = 0;
  Diagnostics diagnostics;
  const auto files = encode_gltf(scene, "out.glb", diagnostics);
  ASSERT_TRUE(files) << to_text(diagnostics);
  const GltfJson json = testing::json_of(files->front().bytes);
  const GltfJson& base = json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"];
  EXPECT_EQ(place_in(base)["scale"], GltfJson({change.scale.x, change.scale.y}));
  EXPECT_EQ(json["extensionsRequired"], GltfJson({transform}));
}

}  // namespace
}  // namespace foredraw::texture_places_test

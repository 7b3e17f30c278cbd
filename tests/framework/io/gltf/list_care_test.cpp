// What a file lists and nobody needs is left out, equal entries become one, and whoever names an entry names the same.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "framework/io/gltf/compressed_scenes.h"

namespace foredraw::list_care_test {
namespace {

using ::testing::ElementsAre;
using testing::GltfBuilder;
using testing::GltfJson;
using ::testing::HasSubstr;
using testing::Written;

constexpr ListCare all_of_it{.leaves_out_unnamed = true, .joins_equal = true};

Written cared_for(const GltfBuilder& builder, ListCare care = all_of_it, Compression compression = Compression::keep) {
  Scene scene = testing::read(builder);
  scene.lists = care;
  return testing::encode(scene, compression);
}

std::size_t add_image(GltfBuilder& builder, const std::string& text) {
  return builder.add("images",
                     {{"bufferView", builder.add_view(std::as_bytes(std::span(text)))}, {"mimeType", "image/png"}});
}

/// Everything before what is used: unused entries, and a copy of each that is used behind.
GltfBuilder cluttered() {
  GltfBuilder builder = testing::ribbon(4);
  const std::size_t unused = add_image(builder, "nobody looks at this");
  const std::size_t picture = add_image(builder, "a picture");
  const std::size_t same_picture = add_image(builder, "a picture");
  builder.add("samplers", {{"wrapS", 33071}});
  builder.add("samplers", {{"wrapS", 10497}});
  builder.add("samplers", {{"wrapS", 10497}, {"name", "the same"}});
  builder.add("textures", {{"source", unused}, {"sampler", 0}});
  builder.add("textures", {{"source", picture}, {"sampler", 1}});
  builder.add("textures", {{"source", same_picture}, {"sampler", 2}});
  const auto material = [&](const char* name, std::size_t texture) {
    return builder.add("materials",
                       {{"name", name}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}}}});
  };
  material("Old", 0);
  const std::size_t cloth = material("Cloth", 1);
  const std::size_t other_cloth = material("Cloth", 2);
  GltfJson primitive = builder.json["meshes"][0]["primitives"][0];
  primitive["material"] = other_cloth;
  builder.json["meshes"][0]["primitives"][0] = primitive;
  primitive["material"] = cloth;
  builder.add_mesh(primitive);
  builder.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", .1}}}});
  builder.add("nodes", {{"translation", {1, 2, 3}}});
  builder.add("nodes", {{"name", "socket"}});
  const std::size_t child = builder.add("nodes", {{"scale", {2, 2, 2}}});
  builder.add("nodes", {{"children", {child}}});
  builder.add("nodes", {{"mesh", 0}});
  builder.add("scenes", {{"nodes", {0, 1, 2, 3, 5, 6}}});
  builder.json["scene"] = 0;
  return builder;
}

TEST(ListCare, WhatNothingNamesGoesAndOthersKeepWhatTheyNamed) {
  const Written written = cared_for(cluttered());
  const GltfJson& json = written.json;
  ASSERT_EQ(json["images"].size(), 1u);
  ASSERT_EQ(json["textures"], GltfJson({{{"source", 0}, {"sampler", 0}}}));
  EXPECT_EQ(json["samplers"], GltfJson({{{"wrapS", 10497}}}));
  ASSERT_EQ(json["materials"].size(), 1u);
  EXPECT_EQ(json["materials"][0]["name"], "Cloth");
  EXPECT_EQ(json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"], 0);
  for (const GltfJson& mesh : json["meshes"]) EXPECT_EQ(mesh["primitives"][0]["material"], 0);
  EXPECT_FALSE(json.contains("cameras"));
  ASSERT_EQ(json["nodes"].size(), 4u) << json["nodes"].dump();
  EXPECT_EQ(json["nodes"][2]["name"], "socket");
  EXPECT_EQ(json["nodes"][3]["mesh"], 0);
  EXPECT_EQ(json["scenes"][0]["nodes"], GltfJson({0, 1, 2, 3}));
  const std::string told = to_text(written.diagnostics);
  EXPECT_THAT(told, HasSubstr("materials: left out, as nothing names them: 1 (\"Old\")"));
  EXPECT_THAT(told, HasSubstr("images: equal to others, which stand for them: 1"));
  EXPECT_THAT(told, HasSubstr("nodes: left out, as they show and move nothing: 3"));
  const Scene again = testing::read(written.files[0].bytes);
  testing::expect_same(
      again,
      [] {
        Scene before = testing::read(cluttered());
        before.images = {before.images[1]};
        return before;
      }(),
      true);
  const std::string_view bytes(reinterpret_cast<const char*>(written.files[0].bytes.data()),
                               written.files[0].bytes.size());
  EXPECT_EQ(bytes.find("nobody looks at this"), std::string_view::npos) << "its bytes are gone, too";
  EXPECT_EQ(bytes.find("a picture"), bytes.rfind("a picture"));
}

TEST(ListCare, NothingHappensUnasked) {
  const GltfBuilder builder = cluttered();
  const Written written = cared_for(builder, {});
  for (const char* list : {"images", "textures", "samplers", "materials", "cameras", "nodes"}) {
    EXPECT_EQ(written.json[list].size(), builder.json[list].size()) << list;
  }
  EXPECT_EQ(cared_for(builder, {.joins_equal = true}).json["images"].size(), 2u);
  EXPECT_EQ(cared_for(builder, {.leaves_out_unnamed = true}).json["images"].size(), 2u);
}

TEST(ListCare, NamesCountUnlessTheyNeedNot) {
  GltfBuilder builder = cluttered();
  builder.json["materials"][1]["name"] = "Wool";
  EXPECT_EQ(cared_for(builder).json["materials"].size(), 2u);
  ListCare care = all_of_it;
  care.keeps_names = false;
  const Written written = cared_for(builder, care);
  EXPECT_EQ(written.json["materials"].size(), 1u);
  EXPECT_EQ(written.json["nodes"].size(), 3u) << "the socket goes";
}

TEST(ListCare, AnUnknownExtensionKeepsAllLists) {
  GltfBuilder builder = cluttered();
  builder.json["extensionsUsed"] = {"ACME_sockets"};
  builder.json["extensions"]["ACME_sockets"] = {{"node", 3}};
  const Written written = cared_for(builder);
  for (const char* list : {"images", "textures", "samplers", "materials", "cameras", "nodes"}) {
    EXPECT_EQ(written.json[list].size(), builder.json[list].size()) << list;
  }
  EXPECT_THAT(to_text(written.diagnostics), HasSubstr("the extension 'ACME_sockets' may name nodes"));
}

TEST(ListCare, WhatAnimationsPointAtStays) {
  GltfBuilder builder = cluttered();
  const std::size_t times = builder.add_values(std::vector<float>{0, 1}, "SCALAR");
  builder.json["accessors"][times]["min"] = {0};
  builder.json["accessors"][times]["max"] = {1};
  const std::size_t values = builder.add_values(std::vector<float>{0, 1}, "SCALAR");
  builder.add(
      "animations",
      {{"samplers", {{{"input", times}, {"output", values}}}},
       {"channels",
        {{{"sampler", 0},
          {"target",
           {{"path", "pointer"},
            {"extensions",
             {{"KHR_animation_pointer", {{"pointer", "/materials/0/pbrMetallicRoughness/metallicFactor"}}}}}}}}}}});
  builder.json["extensionsUsed"] = {"KHR_animation_pointer"};
  const Written written = cared_for(builder);
  EXPECT_EQ(written.json["materials"].size(), 3u);
  EXPECT_EQ(written.json["nodes"].size(), builder.json["nodes"].size());
  EXPECT_EQ(written.json["images"].size(), 2u) << "no pointer names these: one is equal to another";
}

TEST(ListCare, JointsTargetsAndVariantsAreUses) {
  GltfBuilder builder = testing::puppet();
  builder.json["nodes"][1].erase("name");
  builder.json["nodes"][2].erase("name");
  builder.add("materials", {{"name", "summer"}});
  builder.add("materials", {{"name", "winter"}, {"doubleSided", true}});
  builder.json["extensionsUsed"] = {"KHR_materials_variants"};
  builder.json["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "cold"}}};
  builder.json["meshes"][0]["primitives"][0]["extensions"]["KHR_materials_variants"]["mappings"] = {
      {{"material", 2}, {"variants", {0}}}};
  const Written written = cared_for(builder);
  EXPECT_EQ(written.json["nodes"].size(), 3u);
  ASSERT_EQ(written.json["materials"].size(), 2u);
  const GltfJson& primitive = written.json["meshes"][0]["primitives"][0];
  EXPECT_EQ(primitive["extensions"]["KHR_materials_variants"]["mappings"][0]["material"], 1);
  EXPECT_EQ(written.json["materials"][1]["name"], "winter");
  testing::expect_same(testing::read(written.files[0].bytes), testing::read(testing::puppet()), true);
}

TEST(ListCare, WhatHoldsAnywayIsNotSaid) {
  GltfBuilder builder = testing::puppet();
  GltfJson& animation = builder.json["animations"][0];
  animation["samplers"].push_back(animation["samplers"][0]);
  animation["samplers"].push_back(animation["samplers"][0]);
  animation["samplers"][0]["interpolation"] = animation["samplers"][2]["interpolation"] = "LINEAR";
  animation["channels"].push_back({{"sampler", 2}, {"target", {{"node", 1}, {"path", "rotation"}}}});
  builder.json["nodes"][1]["translation"] = {0, 0, 0};
  builder.json["nodes"][1]["rotation"] = {0, 0, 0, 1};
  builder.json["nodes"][1]["scale"] = {1, 1, 1.5};
  const Written written = cared_for(builder);
  const GltfJson& made = written.json["animations"][0];
  ASSERT_EQ(made["samplers"].size(), 2u) << made.dump();
  EXPECT_FALSE(made["samplers"][0].contains("interpolation"));
  EXPECT_EQ(made["channels"][0]["sampler"], 0);
  EXPECT_EQ(made["channels"][1]["sampler"], 1);
  EXPECT_EQ(made["channels"][2]["sampler"], 0);
  EXPECT_EQ(written.json["nodes"][1], GltfJson({{"name", "shoulder"}, {"children", {2}}, {"scale", {1, 1, 1.5}}}));
  const Scene scene = testing::read(builder), again = testing::read(written.files[0].bytes);
  testing::expect_same(again, scene, true);
  EXPECT_EQ(again.animations[0].channels[2].node, scene.animations[0].channels[2].node);
  EXPECT_EQ(cared_for(builder, {.leaves_out_unnamed = true}).json["animations"][0]["samplers"].size(), 3u);
}

TEST(ListCare, AccessorsThatNothingNamesLoseTheirBytes) {
  GltfBuilder builder = testing::ribbon(4);
  builder.add_values(std::vector<float>(3000, 1), "VEC3");
  const Written written = cared_for(builder);
  EXPECT_EQ(written.json["accessors"].size(), builder.json["accessors"].size() - 1);
  EXPECT_LT(written.files[0].bytes.size(), 3000u);
}

TEST(ListCare, EqualAccessorsAreOneInCompressedFiles) {
  GltfBuilder builder = testing::ribbon(100);
  GltfBuilder twice = builder;
  GltfJson other = builder.json["meshes"][0]["primitives"][0];
  std::vector<float> positions;
  for (int v = 0; v < 202; ++v) positions.insert(positions.end(), {static_cast<float>(v), 1, 2});
  builder.json["meshes"][0]["primitives"][0]["attributes"] = {{"POSITION", builder.add_values(positions, "VEC3")}};
  other["attributes"] = {{"POSITION", builder.add_values(positions, "VEC3")}};
  builder.add_mesh(other);
  const Written written = cared_for(builder, all_of_it, Compression::khr);
  const GltfJson& meshes = written.json["meshes"];
  EXPECT_EQ(meshes[0]["primitives"][0]["attributes"]["POSITION"], meshes[1]["primitives"][0]["attributes"]["POSITION"]);
  testing::expect_same(testing::read(written.files[0].bytes), testing::read(builder), true);
  EXPECT_LT(written.files[0].bytes.size(),
            cared_for(builder, {.leaves_out_unnamed = true}, Compression::khr).files[0].bytes.size());
}

TEST(VertexNeeds, AreThoseOfAllTexturesOfAMaterial) {
  GltfBuilder builder = cluttered();
  GltfJson& cloth = builder.json["materials"][1];
  cloth["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] = 1;
  cloth["normalTexture"] = {{"index", 1}};
  cloth["extensions"]["KHR_materials_clearcoat"]["clearcoatTexture"] = {
      {"index", 1}, {"extensions", {{"KHR_texture_transform", {{"texCoord", 3}}}}}};
  builder.json["materials"][2] = {{"extensions", {{"ACME_glow", {{"texture", 1}}}}}};
  builder.add("materials", {{"name", "plain"}});
  const Scene scene = testing::read(builder);
  EXPECT_EQ(scene.materials[0].needs, (VertexNeeds{.texcoords = 1}));
  EXPECT_EQ(scene.materials[1].needs, (VertexNeeds{.texcoords = 0b1011, .has_tangents = true}));
  EXPECT_EQ(scene.materials[2].needs, std::nullopt) << "who knows what it looks up";
  EXPECT_EQ(scene.materials[3].needs, VertexNeeds{});
}

TEST(VertexNeeds, AreThoseOfVariantsToo) {
  GltfBuilder builder = cluttered();
  builder.json["materials"][0]["normalTexture"] = {{"index", 1}, {"texCoord", 2}};
  builder.json["extensionsUsed"] = {"KHR_materials_variants"};
  builder.json["meshes"][0]["primitives"][0]["extensions"]["KHR_materials_variants"]["mappings"] = {
      {{"material", 0}, {"variants", {0}}}};
  builder.json["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "worn"}}};
  const Scene scene = testing::read(builder);
  EXPECT_EQ(scene.materials[2].needs, (VertexNeeds{.texcoords = 0b101, .has_tangents = true}));
  EXPECT_EQ(scene.materials[1].needs, (VertexNeeds{.texcoords = 1}));
}

}  // namespace
}  // namespace foredraw::list_care_test

// KHR_materials_displacement: what a material says comes in, and what a stage changes comes out.
#include <foredraw/io/gltf/gltf.h>
#include <foredraw/io/image/images.h>

#include "support/gltf_builder.h"
#include "support/image_builder.h"

#include <gtest/gtest.h>

namespace foredraw::gltf_displacement_test {
namespace {

using testing::GltfBuilder;
using testing::GltfJson;

constexpr const char* name = "KHR_materials_displacement";

/// A ribbon whose material has these members of the extension, and two textures of two images.
GltfBuilder moved_ribbon(GltfJson members) {
  GltfBuilder builder = testing::ribbon(2);
  for (const int value : {10, 20}) {
    const auto png = testing::png_of({2, 1, 1, 8}, {static_cast<std::uint16_t>(value), 30});
    builder.add("images", {{"bufferView", builder.add_view(png)}, {"mimeType", "image/png"}});
    builder.add("textures", {{"source", value / 10 - 1}});
  }
  builder.json["materials"] = {{{"name", "skin"}, {"extensions", {{name, std::move(members)}}}}};
  builder.json["extensionsUsed"] = {name};
  builder.json["meshes"][0]["primitives"][0]["material"] = 0;
  return builder;
}

GltfJson whole() {
  return {{"displacementGeometryTexture", {{"index", 1}}},
          {"displacementGeometryFactor", 0.25},
          {"displacementGeometryOffset", -0.5},
          {"myOwn", "word"}};
}

Scene read_built(const GltfBuilder& builder, bool is_clean = true) {
  Diagnostics diagnostics;
  const auto scene = read_gltf(builder.glb(), "ribbon.glb", {}, diagnostics);
  EXPECT_EQ(diagnostics.empty(), is_clean) << to_text(diagnostics);
  return scene.value_or(Scene{});
}

GltfJson written(const Scene& scene) {
  Diagnostics diagnostics;
  const auto files = encode_gltf(scene, "out.glb", diagnostics);
  EXPECT_TRUE(files) << to_text(diagnostics);
  return testing::json_of(files->front().bytes);
}

TEST(GltfDisplacement, ComesInAndMakesDrawsDisplaced) {
  const Scene scene = read_built(moved_ribbon(whole()));
  ASSERT_TRUE(scene.materials[0].displacement);
  const Displacement& displacement = *scene.materials[0].displacement;
  EXPECT_EQ(displacement.texture.image, ImageId{1});
  EXPECT_EQ(displacement.factor, 0.25f);
  EXPECT_EQ(displacement.offset, -0.5f);
  EXPECT_TRUE(scene.draws[0].traits.has(traits::displaced));
}

TEST(GltfDisplacement, FactorIsOneAndOffsetNoneWhereTheFileDoesNotSay) {
  const Scene scene = read_built(moved_ribbon({{"displacementGeometryTexture", {{"index", 0}}}}));
  EXPECT_EQ(scene.materials[0].displacement, (Displacement{.texture = {.image = 0}}));
}

TEST(GltfDisplacement, WithoutATextureOrItsCoordinatesMovesNothing) {
  EXPECT_FALSE(read_built(moved_ribbon({{"displacementGeometryFactor", 2}})).materials[0].displacement);
  GltfJson members = whole();
  members["displacementGeometryTexture"]["texCoord"] = 3;
  const Scene scene = read_built(moved_ribbon(members));
  EXPECT_EQ(scene.materials[0].displacement->texture.texcoord, 3u);
  EXPECT_FALSE(scene.draws[0].traits.has(traits::displaced));
}

TEST(GltfDisplacement, WrongMembersAreLeftOutWithAWarning) {
  const auto wrong = [](const char* key, GltfJson value) {
    GltfJson members = whole();
    members[key] = std::move(value);
    return read_built(moved_ribbon(members), false).materials[0].displacement;
  };
  EXPECT_FALSE(wrong("displacementGeometryTexture", {{"index", 7}}));
  EXPECT_FALSE(wrong("displacementGeometryTexture", "a.png"));
  EXPECT_EQ(wrong("displacementGeometryFactor", "much")->factor, 1);
  EXPECT_EQ(wrong("displacementGeometryFactor", 1e39)->factor, 1);
  EXPECT_EQ(wrong("displacementGeometryOffset", GltfJson::array())->offset, 0);
}

TEST(GltfDisplacement, StaysAsItCameWhereNobodyTouchesIt) {
  const GltfBuilder builder = moved_ribbon(whole());
  Diagnostics diagnostics;
  EXPECT_EQ(encode_gltf(read_built(builder), "out.glb", diagnostics)->front().bytes, builder.glb());
}

TEST(GltfDisplacement, OfANewMapIsWrittenAndReadAgain) {
  Scene scene = read_built(testing::ribbon(2));
  Texels texels{{3, 2, 1, 16}, {}};
  for (int i = 0; i < 12; ++i) texels.bytes.push_back(static_cast<std::byte>(40 * i));
  scene.images.push_back({.name = "heights", .bytes = Shared(texels.bytes), .is_texels = true, .facts = texels.facts});
  const Displacement wanted{{.image = 0, .wrap = {Wrap::clamped, Wrap::mirrored}, .scale = {2, 1}}, 0.125f, 3};
  scene.materials.push_back({.name = "new", .displacement = wanted});
  scene.draws[0].material = static_cast<MaterialId>(scene.materials.size() - 1);
  Diagnostics diagnostics;
  const auto files = encode_gltf(scene, "out.glb", diagnostics);
  ASSERT_TRUE(files) << to_text(diagnostics);
  const auto again = read_gltf(files->front().bytes, "again", {}, diagnostics);
  ASSERT_TRUE(again) << to_text(diagnostics);
  EXPECT_EQ(again->materials[*again->draws[0].material].displacement, wanted);
  const Analyses analyses(image_decoder({}));
  EXPECT_EQ(std::get<Texels>(analyses.decode(again->images[0])).bytes, texels.bytes);
  EXPECT_EQ(std::get<Texels>(analyses.decode(scene.images[0])).bytes, texels.bytes) << "not encoded yet";
}

TEST(GltfDisplacement, ThatIsChangedKeepsWhatWeDoNotKnow) {
  Scene scene = read_built(moved_ribbon(whole()));
  scene.materials[0].displacement->factor = 0.5f;
  scene.materials[0].displacement->offset = 0.1f;
  const GltfJson members = written(scene)["materials"][0]["extensions"][name];
  EXPECT_EQ(members["displacementGeometryFactor"], 0.5);
  EXPECT_EQ(members["displacementGeometryOffset"], 0.1f);
  EXPECT_EQ(members["displacementGeometryTexture"], GltfJson({{"index", 1}}));
  EXPECT_EQ(members["myOwn"], "word");
}

TEST(GltfDisplacement, ThatIsTakenAwayIsGone) {
  Scene scene = read_built(moved_ribbon(whole()));
  scene.materials[0].displacement.reset();
  const GltfJson json = written(scene);
  EXPECT_EQ(json["materials"][0], GltfJson({{"name", "skin"}}));
}

TEST(GltfDisplacement, OfACopyLeavesTheOther) {
  Scene scene = read_built(moved_ribbon(whole()));
  Material copy = scene.materials[0];
  copy.copy_of = 0;
  copy.displacement.reset();
  scene.materials.push_back(copy);
  scene.draws[0].material = 1;
  const GltfJson materials = written(scene)["materials"];
  EXPECT_EQ(materials[0]["extensions"][name], whole());
  EXPECT_FALSE(materials[1].contains("extensions"));
}

TEST(GltfDisplacement, OfTheFirstAndOfACopyAreTheirOwn) {
  Scene scene = read_built(moved_ribbon(whole()));
  Material copy = scene.materials[0];
  copy.copy_of = 0;
  scene.materials.push_back(copy);
  scene.materials[0].displacement->factor = 8;
  const GltfJson materials = written(scene)["materials"];
  EXPECT_EQ(materials[0]["extensions"][name]["displacementGeometryFactor"], 8.0);
  EXPECT_EQ(materials[1]["extensions"][name], whole()) << "a copy of what was read";
}

}  // namespace
}  // namespace foredraw::gltf_displacement_test

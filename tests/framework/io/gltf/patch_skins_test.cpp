// Inverse bind matrices that a stage changed.
#include <gtest/gtest.h>

#include <limits>

#include "framework/io/gltf/compressed_scenes.h"

namespace foredraw::patch_skins_test {
namespace {

using namespace foredraw::testing;

/// `puppet` with a second skin, which names the matrices of the first, a third, which names none, and a fourth of one
/// joint, which names more than it needs.
GltfBuilder puppets() {
  GltfBuilder builder = puppet();
  GltfJson skin = builder.json["skins"][0];
  skin["extras"] = "second";
  builder.add("skins", skin);
  builder.add("skins", {{"joints", {2, 1}}, {"name", "bare"}});
  builder.add("skins", {{"joints", {2}}, {"inverseBindMatrices", skin["inverseBindMatrices"]}});
  return builder;
}

std::size_t matrices_of(const GltfJson& json, std::size_t skin) {
  return json["skins"][skin]["inverseBindMatrices"].get<std::size_t>();
}

void scale_back(Skin& skin, float by) {
  for (glm::mat4& matrix : skin.inverse_bind_matrices) {
    for (int column = 0; column < 3; ++column) matrix[column] *= by;
  }
}

void expect_same_skins(const Scene& is, const Scene& want) {
  ASSERT_EQ(is.skins.size(), want.skins.size());
  for (std::size_t i = 0; i < is.skins.size(); ++i) {
    EXPECT_EQ(is.skins[i].joints, want.skins[i].joints) << i;
    EXPECT_TRUE(is.skins[i].inverse_bind_matrices == want.skins[i].inverse_bind_matrices) << i;
  }
}

TEST(GltfPatchSkins, matrices_that_changed_alike_are_shared_and_the_old_ones_released) {
  const GltfBuilder builder = puppets();
  const std::size_t old = matrices_of(builder.json, 0), added = builder.json["accessors"].size();
  Scene scene = read(builder);
  for (const std::size_t skin : {0, 1}) scale_back(scene.skins[skin], 0.1f);
  GltfJson json = written(scene);
  GltfJson want = builder.json["skins"];
  for (const std::size_t skin : {0, 1}) want[skin]["inverseBindMatrices"] = added;
  EXPECT_EQ(json["skins"].dump(), want.dump());
  EXPECT_EQ(json["accessors"].size(), added + 1);
  EXPECT_TRUE(json["accessors"][old].contains("bufferView")) << "the fourth names them";
  EXPECT_EQ(json["accessors"][added]["type"], "MAT4");
  expect_same_skins(read(write(scene)), scene);

  scale_back(scene.skins[3], 0.1f);
  json = written(scene);
  EXPECT_FALSE(json["accessors"][old].contains("bufferView"));
  EXPECT_EQ(json["accessors"][matrices_of(json, 3)]["count"], 1) << "as many as joints";
  expect_same_skins(read(write(scene)), scene);
}

TEST(GltfPatchSkins, one_of_two_that_shared_theirs_may_change_alone) {
  const GltfBuilder builder = puppets();
  Scene scene = read(builder);
  scene.skins[1].inverse_bind_matrices[1][3] = {1, 2, 3, 1};
  const GltfJson json = written(scene);
  EXPECT_EQ(json["skins"][0], builder.json["skins"][0]);
  EXPECT_NE(matrices_of(json, 1), matrices_of(json, 0));
  EXPECT_EQ(json["skins"][1]["extras"], "second");
  expect_same_skins(read(write(scene)), scene);
}

TEST(GltfPatchSkins, a_skin_that_named_none_gets_some) {
  const GltfBuilder builder = puppets();
  Scene scene = read(builder);
  scale_back(scene.skins[2], 3);
  const GltfJson json = written(scene);
  GltfJson want = builder.json["skins"];
  want[2]["inverseBindMatrices"] = builder.json["accessors"].size();
  EXPECT_EQ(json["skins"].dump(), want.dump());
  expect_same_skins(read(write(scene)), scene);

  GltfBuilder bare;  // no accessor at all
  bare.add("nodes", GltfJson::object());
  bare.add("skins", {{"joints", {0}}, {"extras", 1}});
  Scene small = read(bare);
  scale_back(small.skins[0], 2);
  EXPECT_EQ(written(small)["skins"][0].dump(), R"({"joints":[0],"extras":1,"inverseBindMatrices":0})");
  expect_same_skins(read(write(small)), small);
}

TEST(GltfPatchSkins, what_an_unknown_extension_may_name_keeps_its_bytes) {
  GltfBuilder builder = puppet();
  const std::size_t old = matrices_of(builder.json, 0);
  builder.json["nodes"][1]["extensions"]["ACME_bones"]["matrices"] = old;
  builder.json["extensionsUsed"] = {"ACME_bones"};
  Scene scene = read(builder);
  scale_back(scene.skins[0], 0.5f);
  EXPECT_TRUE(written(scene)["accessors"][old].contains("bufferView"));
  expect_same_skins(read(write(scene)), scene);
}

TEST(GltfPatchSkins, compressed_files_are_written_and_read_again) {
  const Scene plain = read(puppets());
  for (const Compression first : {Compression::none, Compression::ext}) {
    Scene scene = first == Compression::none ? plain : read(encode(plain, first).files.front().bytes);
    for (Skin& skin : scene.skins) scale_back(skin, 0.01f);
    for (const Compression second : {Compression::keep, Compression::none, Compression::khr}) {
      const Scene again = read(encode(scene, second).files.front().bytes);
      expect_same_skins(again, scene);
      expect_same(again, scene);
    }
  }
}

TEST(GltfPatchSkins, other_changes_are_refused) {
  const Scene scene = read(puppets());
  const auto with = [&](auto change) {
    Scene changed = scene;
    change(changed);
    Diagnostics diagnostics;
    if (encode_gltf(changed, "out.glb", diagnostics)) return std::string("written");
    return diagnostics.all().at(0).where.inside + ": " + diagnostics.all()[0].message;
  };
  const std::string kind = "skins[1]: its name or joints were changed; this cannot be written back";
  EXPECT_EQ(with([](Scene& s) { s.skins[1].joints = {2, 1}; }), kind);
  EXPECT_EQ(with([](Scene& s) { s.skins[1].name = "other"; }), kind);
  const std::string matrices =
      "skins[2]: its inverse bind matrices are not finite, or not as many as joints; this cannot be written back";
  EXPECT_EQ(with([](Scene& s) { s.skins[2].inverse_bind_matrices.pop_back(); }), matrices);
  EXPECT_EQ(with([](Scene& s) { s.skins[2].inverse_bind_matrices.clear(); }), matrices);
  EXPECT_EQ(with([](Scene& s) { s.skins[2].inverse_bind_matrices[0][1][1] = std::numeric_limits<float>::infinity(); }),
            matrices);
  EXPECT_EQ(with([](Scene& s) { s.skins.pop_back(); }), "skins: some were removed; this cannot be written back");
}

}  // namespace
}  // namespace foredraw::patch_skins_test

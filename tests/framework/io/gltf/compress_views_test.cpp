// Files that are asked to go out compressed: plain ones become so, others move to the extension that is asked for.
#include <foredraw/io/gltf/gltf.h>

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "framework/io/gltf/compressed_scenes.h"

#include "support/meshes.h"

namespace foredraw::compress_views_test {
namespace {

using testing::Bytes;
using testing::encode;
using testing::expect_same;
using testing::extension;
using testing::GltfBuilder;
using testing::GltfJson;
using testing::Written;
using Plain = testing::CompressionChoice::Plain;

const char* name_of(Compression compression) {
  return compression == Compression::khr ? "KHR_meshopt_compression" : "EXT_meshopt_compression";
}

/// The first bytes of a file's streams of mode ATTRIBUTES.
std::set<std::byte> vertex_codecs(const Bytes& glb, const char* name) {
  std::set<std::byte> first;
  const GltfJson json = testing::json_of(glb);
  for (std::size_t v = 0; v < json["bufferViews"].size(); ++v) {
    if (!json["bufferViews"][v].contains("extensions") || extension(json, v, name)["mode"] != "ATTRIBUTES") continue;
    first.insert(testing::builder_of(glb).buffer[extension(json, v, name).value("byteOffset", std::size_t{0})]);
  }
  return first;
}

class AllCompressed : public ::testing::TestWithParam<Compression> {
 protected:
  static std::set<std::byte> version() { return {GetParam() == Compression::khr ? std::byte{0xa1} : std::byte{0xa0}}; }
};

TEST_P(AllCompressed, plain_files_are_compressed_to_the_last_bit) {
  const char* name = name_of(GetParam());
  for (const GltfBuilder& plain : {testing::puppet(), testing::ribbon(500)}) {
    const Scene scene = testing::read(plain);
    const Written written = encode(scene, GetParam());
    ASSERT_EQ(written.files.size(), 1u);
    const Bytes& file = written.files[0].bytes;
    expect_same(testing::read(file), scene, true);
    EXPECT_EQ(written.json["extensionsRequired"], GltfJson({name}));
    EXPECT_EQ(written.json["buffers"][1]["extensions"][name]["fallback"], true);
    EXPECT_EQ(vertex_codecs(file, name), version());
    EXPECT_LT(file.size(), plain.glb().size() + (plain.buffer.size() < 4000 ? 4000 : 0));
    EXPECT_EQ(testing::write(testing::read(file)), file);
  }
}

TEST_P(AllCompressed, compressed_files_move_to_the_extension_with_their_filters_and_copies) {
  const char* name = name_of(GetParam());
  for (const char* was : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    for (const Plain plain : {Plain::none, Plain::data_uri, Plain::beside}) {
      const Scene scene = testing::read(testing::with_filters({was, plain, true, {}}));
      const Written written = encode(scene, GetParam(), "out.glb");
      const GltfJson& json = written.json;
      for (const std::size_t v : {0u, 1u, 2u, 3u, 4u}) ASSERT_EQ(json["bufferViews"][v]["extensions"].size(), 1u);
      EXPECT_EQ(extension(json, 0, name)["filter"], "EXPONENTIAL");
      EXPECT_EQ(extension(json, 3, name)["filter"], "OCTAHEDRAL");
      EXPECT_EQ(extension(json, 2, name)["mode"], "TRIANGLES");
      EXPECT_EQ(json["extensionsUsed"].back(), name);
      EXPECT_EQ(json.value("extensionsRequired", GltfJson::array()).size(), plain == Plain::none ? 2u : 1u);
      if (was != std::string(name)) {
        EXPECT_EQ(vertex_codecs(written.files[0].bytes, name), version());
      }
      if (written.files.size() == 1) expect_same(testing::read(written.files[0].bytes), scene, true);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Gltf, AllCompressed, ::testing::Values(Compression::ext, Compression::khr),
                         [](const auto& info) { return std::string(name_of(info.param), 3); });

TEST(GltfCompression, the_filter_of_the_new_extension_alone_does_not_go_to_the_old_one) {
  GltfBuilder builder = testing::ribbon(40);
  std::vector<std::uint8_t> colors;
  for (std::uint8_t i = 0; i < 82; ++i) colors.insert(colors.end(), {static_cast<std::uint8_t>(90 + i), 3, 5, 255});
  builder.json["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = builder.add_values(colors, "VEC4");
  const std::size_t accessor = builder.json["accessors"].size() - 1;
  builder.json["accessors"][accessor]["normalized"] = true;
  const std::size_t view = builder.json["accessors"][accessor]["bufferView"];
  GltfBuilder made = testing::compressed(builder, {"KHR_meshopt_compression", Plain::none, true, {}});
  made.json["bufferViews"][view]["extensions"]["KHR_meshopt_compression"]["filter"] = "COLOR";
  const Scene scene = testing::read(made);
  EXPECT_NE(testing::stream(scene, 0, "COLOR_0").bytes.view()[0], std::byte{90});
  const Written newer = encode(scene, Compression::khr), older = encode(scene, Compression::ext);
  EXPECT_EQ(extension(newer.json, view, "KHR_meshopt_compression")["filter"], "COLOR");
  EXPECT_EQ(extension(older.json, view, "EXT_meshopt_compression")["filter"], "NONE");
  for (const Written* written : {&newer, &older}) expect_same(testing::read(written->files[0].bytes), scene, true);
}

TEST(GltfCompression, what_came_in_version_1_goes_out_in_version_1) {
  Diagnostics diagnostics;
  auto scene = read_gltf(testing::project_file("tests/compressed/spot_khr.glb"), diagnostics);
  ASSERT_TRUE(scene) << to_text(diagnostics);
  testing::reverse_vertices(*scene, 0);
  const Bytes again = testing::write(*scene);
  EXPECT_EQ(vertex_codecs(again, "KHR_meshopt_compression"), std::set<std::byte>{std::byte{0xa1}});
}

}  // namespace
}  // namespace foredraw::compress_views_test

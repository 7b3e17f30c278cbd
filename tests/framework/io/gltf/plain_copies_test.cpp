// Plain copies beside compressed streams: read where streams are not known, written anew where something changed.
#include <foredraw/io/gltf/gltf.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "framework/io/gltf/compressed_scenes.h"

#include "support/test_folder.h"

namespace foredraw::plain_copies_test {
namespace {

using testing::Bytes;
using testing::CompressionChoice;
using testing::encode;
using testing::expect_same;
using testing::GltfBuilder;
using testing::GltfJson;
using testing::stream_of;
using testing::Written;
using Plain = CompressionChoice::Plain;
namespace fs = std::filesystem;

void put(const fs::path& path, const Bytes& bytes) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

TEST(PlainCopies, unknown_extensions_keep_old_buffers_whole_and_streams_in_place) {
  GltfBuilder builder = testing::compressed(testing::puppet());
  builder.json["extensionsUsed"].push_back("ACME_secrets");
  builder.json["extensions"]["ACME_secrets"] = {{"bufferView", 6}};
  Scene scene = testing::read(builder);
  testing::reverse(scene.draws[0]);
  testing::reverse_vertices(scene, 0);
  const Bytes file = testing::write(scene);
  const GltfJson json = testing::json_of(file);
  for (std::size_t v = 0; v < builder.json["bufferViews"].size(); ++v) {
    EXPECT_EQ(json["bufferViews"][v], builder.json["bufferViews"][v]) << v;
  }
  expect_same(testing::read(file), scene);
}

TEST(PlainCopies, beside_unknown_extensions_plain_copies_stay_too) {
  CompressionChoice choice;
  choice.plain = Plain::data_uri;
  GltfBuilder builder = testing::compressed(testing::puppet(), choice);
  builder.json["extensionsUsed"].push_back("ACME_secrets");
  builder.json["extensions"]["ACME_secrets"] = {{"bufferView", 6}};
  Scene scene = testing::read(builder);
  testing::reverse(scene.draws[0]);
  const testing::TestFolder own;
  const fs::path& folder = own.path();
  for (const OutputFile& one : encode(scene).files) put(folder / one.path, one.bytes);
  Diagnostics quiet;
  const auto again = read_gltf(folder / "out.glb", quiet);
  ASSERT_TRUE(again && quiet.empty()) << to_text(quiet);
  expect_same(*again, scene);
}

TEST(PlainCopies, a_plain_copy_that_is_a_file_is_written_beside_and_may_be_missing) {
  const testing::TestFolder own;
  const fs::path& folder = own.path();
  GltfBuilder builder = testing::compressed(testing::puppet());
  builder.json["buffers"][1]["uri"] = "plain%20copy.bin";
  const Bytes file = builder.glb();
  put(folder / "in.glb", file);
  Diagnostics diagnostics;
  auto scene = read_gltf(folder / "in.glb", diagnostics);
  ASSERT_TRUE(scene) << to_text(diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 1u);
  EXPECT_EQ(diagnostics.all()[0].code, "fallback-missing");
  testing::reverse(scene->draws[0]);
  EXPECT_FALSE(encode(*scene).json["buffers"][1].contains("uri"));

  // The same, with the copy there: streams and copy are both what was changed.
  put(folder / "plain copy.bin", Bytes(builder.json["buffers"][1]["byteLength"].get<std::size_t>(), std::byte{1}));
  Diagnostics differing;
  scene = read_gltf(folder / "in.glb", differing);
  ASSERT_TRUE(scene) << to_text(differing);
  EXPECT_EQ(differing.all()[0].code, "plain-copy-differs");
  testing::reverse(scene->draws[0]);
  Written written = encode(*scene, Compression::keep, "out.gltf");
  ASSERT_EQ(written.files.size(), 3u);
  EXPECT_EQ(written.files[2].path, "out.fallback.bin");
  for (const OutputFile& one : written.files) put(folder / one.path, one.bytes);
  Diagnostics quiet;
  const auto again = read_gltf(folder / "out.gltf", quiet);
  ASSERT_TRUE(again && quiet.empty()) << to_text(quiet);
  expect_same(*again, *scene);
}

TEST(PlainCopies, what_is_not_known_is_read_from_its_plain_copy_and_replaced_when_anything_changes) {
  for (const bool filter : {false, true}) {
    CompressionChoice choice;
    choice.plain = Plain::beside;
    GltfBuilder builder = testing::compressed(testing::puppet(), choice);
    if (filter) {
      builder.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"]["filter"] = "WAVELET";
    } else {
      testing::make_unknown(builder, 0);
    }
    Scene scene = testing::read(builder);
    expect_same(scene, testing::read(testing::puppet()));
    EXPECT_EQ(testing::write(scene), builder.glb());
    testing::reverse(scene.draws[0]);
    const Bytes again = testing::write(scene);
    EXPECT_EQ(stream_of(again, 0)[0], std::byte{0xa0});
    expect_same(testing::read(again), scene);
  }
}

}  // namespace
}  // namespace foredraw::plain_copies_test

// Compressed files read as their plain ones are, and are written back compressed: what changed anew, all else as it
// came.
#include <foredraw/io/gltf.h>

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>

#include "framework/io/gltf_edits.h"
#include "support/compressed_gltf.h"
#include "support/meshes.h"

namespace foredraw {
namespace {

using testing::Bytes;
using testing::CompressionChoice;
using testing::GltfBuilder;
using testing::GltfJson;
using testing::Indices;
using Plain = CompressionChoice::Plain;

/// Each triangle from its least corner on: TRIANGLES keeps no more.
Indices turned(Indices indices) {
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    const auto first = indices.begin() + static_cast<std::ptrdiff_t>(i);
    std::rotate(first, std::min_element(first, first + 3), first + 3);
  }
  return indices;
}

void expect_same(const Scene& is, const Scene& want, bool exactly = false) {
  ASSERT_EQ(is.draws.size(), want.draws.size());
  for (std::size_t d = 0; d < is.draws.size(); ++d) {
    const Indices a = testing::indices_of(is, d), b = testing::indices_of(want, d);
    EXPECT_EQ(exactly ? a : turned(a), exactly ? b : turned(b)) << d;
    EXPECT_EQ(is.draws[d].levels[0].vertices->stamp(), want.draws[d].levels[0].vertices->stamp()) << d;
  }
  ASSERT_EQ(is.animations.size(), want.animations.size());
  for (std::size_t a = 0; a < is.animations.size(); ++a) {
    for (std::size_t c = 0; c < is.animations[a].channels.size(); ++c) {
      EXPECT_EQ(is.animations[a].channels[c].values, want.animations[a].channels[c].values);
    }
  }
  ASSERT_EQ(is.images.size(), want.images.size());
  for (std::size_t i = 0; i < is.images.size(); ++i) EXPECT_EQ(is.images[i].bytes, want.images[i].bytes);
}

const GltfJson& extension(const GltfJson& json, std::size_t view, const char* name = "EXT_meshopt_compression") {
  return json["bufferViews"][view]["extensions"][name];
}

Bytes stream(const Bytes& glb, std::size_t view) {
  const GltfJson json = testing::json_of(glb);
  const Bytes bin = testing::builder_of(glb).buffer;
  const auto from = bin.begin() + extension(json, view).value("byteOffset", std::ptrdiff_t{0});
  return {from, from + extension(json, view)["byteLength"].get<std::ptrdiff_t>()};
}

struct Written {
  std::vector<OutputFile> files;
  Diagnostics diagnostics;
  GltfJson json;
};

Written encode(const Scene& scene, Compression compression = Compression::keep, const char* target = "out.glb") {
  Written written;
  auto files = encode_gltf(scene, target, written.diagnostics, compression);
  if (!files) throw std::runtime_error(to_text(written.diagnostics));
  written.files = std::move(*files);
  written.json = testing::json_of(written.files.front().bytes);
  return written;
}

struct Case {
  std::string extension;
  Plain plain;
  bool triangles;
};

class EveryKind : public ::testing::TestWithParam<Case> {
 protected:
  static CompressionChoice choice() { return {GetParam().extension, GetParam().plain, GetParam().triangles, {}}; }
};

TEST_P(EveryKind, is_read_as_the_plain_file_is) {
  const GltfBuilder plain = testing::puppet();
  const GltfBuilder made = testing::compressed(plain, choice());
  expect_same(testing::read(made), testing::read(plain), !GetParam().triangles);
}

TEST_P(EveryKind, comes_out_as_it_came_where_nothing_changed) {
  const Bytes file = testing::compressed(testing::puppet(), choice()).glb();
  EXPECT_EQ(testing::write(testing::read(file)), file);
}

TEST_P(EveryKind, is_compressed_again_where_it_changed_and_else_stays) {
  const Bytes file = testing::compressed(testing::puppet(), choice()).glb();
  Scene scene = testing::read(file);
  testing::reverse(scene.draws[0]);
  testing::reverse_vertices(scene, 0);
  const Written written = encode(scene);
  const Bytes& again = written.files.front().bytes;
  const char* name = GetParam().extension.c_str();
  const GltfJson& json = written.json;
  const GltfJson was = testing::json_of(file);
  for (const char* list : {"extensionsUsed", "extensionsRequired"})
    EXPECT_EQ(json.value(list, GltfJson()), was.value(list, GltfJson()));
  // The plain views of the sparse elements are gone, so that what follows has other numbers.
  for (std::size_t v = 0; v < 5; ++v) EXPECT_EQ(extension(json, v, name)["count"], extension(was, v, name)["count"]) << v;
  const auto compressed = [&](const GltfJson& views) {
    return std::ranges::count_if(views, [](const GltfJson& view) { return view.contains("extensions"); });
  };
  EXPECT_EQ(compressed(json["bufferViews"]), compressed(was["bufferViews"]));
  // The plain copies are where they were: nowhere, in a buffer of their own, or beside the streams.
  const bool apart = GetParam().plain != Plain::beside;
  EXPECT_EQ(json["buffers"].size(), apart ? 2u : 1u);
  EXPECT_EQ(written.files.size(), GetParam().plain == Plain::data_uri ? 2u : 1u);
  if (GetParam().plain == Plain::none) {
    expect_same(testing::read(again), scene, !GetParam().triangles);
    EXPECT_EQ(json["buffers"][1]["byteLength"], was["buffers"][1]["byteLength"]);
    EXPECT_EQ(json["buffers"][1]["extensions"][name]["fallback"], true);
    EXPECT_FALSE(json["buffers"][1].contains("uri"));
  }
  if (GetParam().plain == Plain::data_uri) {
    EXPECT_EQ(written.files[1].path, "out.fallback.bin");
    EXPECT_EQ(json["buffers"][1]["uri"], "out.fallback.bin");
    EXPECT_EQ(json["buffers"][1]["byteLength"], written.files[1].bytes.size());
  }
  if (GetParam().plain == Plain::beside) {
    expect_same(testing::read(again), scene, !GetParam().triangles);
    GltfBuilder uncompressed = testing::builder_of(again);
    for (GltfJson& view : uncompressed.json["bufferViews"]) view.erase("extensions");
    expect_same(testing::read(uncompressed), scene, true);
  }
}

INSTANTIATE_TEST_SUITE_P(Gltf, EveryKind,
                         ::testing::Values(Case{"EXT_meshopt_compression", Plain::none, true},
                                           Case{"KHR_meshopt_compression", Plain::none, true},
                                           Case{"EXT_meshopt_compression", Plain::none, false},
                                           Case{"EXT_meshopt_compression", Plain::data_uri, true},
                                           Case{"KHR_meshopt_compression", Plain::beside, true}));

TEST(GltfCompression, streams_that_nobody_changed_keep_their_bytes) {
  const Bytes file = testing::compressed(testing::puppet()).glb();
  Scene scene = testing::read(file);
  testing::reverse(scene.draws[0]);
  const Bytes again = testing::write(scene);
  const GltfJson json = testing::json_of(file);
  for (std::size_t v = 0; v < json["bufferViews"].size(); ++v) {
    if (json["bufferViews"][v].contains("extensions")) {
      EXPECT_EQ(stream(again, v) == stream(file, v), v != 2) << v;
    }
  }
}

/// Views: 0 positions as floats, 1 uvs, 2 indices, 3 normals of 8 bits, 4 a tangent-like stream of 16.
GltfBuilder with_filters(CompressionChoice choice = {}) {
  GltfBuilder plain = testing::ribbon(40);
  const std::size_t vertices = 82;
  std::vector<std::int8_t> normals;
  std::vector<std::int16_t> turns;
  for (std::size_t i = 0; i < vertices; ++i) {
    const float angle = 0.05f * static_cast<float>(i);
    const auto x = static_cast<std::int8_t>(127 * std::cos(angle)), y = static_cast<std::int8_t>(127 * std::sin(angle));
    normals.insert(normals.end(), {x, y, 0, 0});
    turns.insert(turns.end(), {static_cast<std::int16_t>(32767 * std::cos(angle)), 0, 0,
                               static_cast<std::int16_t>(32767 * std::sin(angle))});
  }
  const std::size_t view = plain.add_view(std::as_bytes(std::span(normals)), 4);
  GltfJson& attributes = plain.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["NORMAL"] = plain.add_accessor(view, 0, 5120, "VEC3", vertices);
  attributes["_TURN"] = plain.add_values(turns, "VEC4");
  plain.json["accessors"][3]["normalized"] = true;
  plain.json["accessors"][4]["normalized"] = true;
  plain.json["extensionsUsed"] = {"KHR_mesh_quantization"};
  plain.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  choice.filters = {{0, "EXPONENTIAL"}, {3, "OCTAHEDRAL"}, {4, "QUATERNION"}};
  return testing::compressed(plain, choice);
}

TEST(GltfCompression, filters_stay_where_vertices_only_moved) {
  Scene scene = testing::read(with_filters());
  testing::reverse_vertices(scene, 0);
  const Written written = encode(scene);
  EXPECT_EQ(extension(written.json, 0)["filter"], "EXPONENTIAL");
  EXPECT_EQ(extension(written.json, 3)["filter"], "OCTAHEDRAL");
  EXPECT_EQ(extension(written.json, 4)["filter"], "QUATERNION");
  expect_same(testing::read(written.files.front().bytes), scene);
}

TEST(GltfCompression, new_values_lose_the_filter_and_nothing_else) {
  Scene scene = testing::read(with_filters());
  VertexStream positions = testing::stream(scene, 0, "POSITION");
  Bytes bytes(positions.bytes.view().begin(), positions.bytes.view().end());
  const float value = 0.1234567f;
  std::memcpy(bytes.data() + 12, &value, 4);
  positions.bytes = Shared<std::byte>(std::move(bytes));
  Level& level = scene.draws[0].levels[0];
  level.vertices = std::make_shared<VertexStreams>(testing::with_stream(scene, 0, positions));
  const Written written = encode(scene);
  EXPECT_EQ(extension(written.json, 0)["filter"], "NONE");
  EXPECT_EQ(extension(written.json, 3)["filter"], "OCTAHEDRAL");
  expect_same(testing::read(written.files.front().bytes), scene);
}

TEST(GltfCompression, is_left_off_where_that_is_asked_and_the_growth_is_told) {
  const Bytes file = testing::compressed(testing::ribbon(500)).glb();
  const Scene scene = testing::read(file);
  const Written written = encode(scene, Compression::none);
  EXPECT_EQ(testing::read(written.files[0].bytes).draws.size(), 1u);
  expect_same(testing::read(written.files[0].bytes), scene, true);
  EXPECT_EQ(written.json["buffers"].size(), 1u);
  for (const char* list : {"extensionsUsed", "extensionsRequired"}) EXPECT_FALSE(written.json.contains(list)) << list;
  for (const GltfJson& view : written.json["bufferViews"]) EXPECT_FALSE(view.contains("extensions"));
  ASSERT_EQ(written.diagnostics.all().size(), 1u);
  const Diagnostic& note = written.diagnostics.all()[0];
  EXPECT_EQ(note.code, "output-grew");
  EXPECT_EQ(note.message, "the output has " + std::to_string(written.files[0].bytes.size()) + " bytes, the input " +
                              std::to_string(file.size()));
  EXPECT_EQ(note.hint.find("data written uncompressed: "), 0u) << note.hint;
}

TEST(GltfCompression, does_not_grow_by_an_order_that_compresses_as_well) {
  const Bytes file = testing::compressed(testing::ribbon(500)).glb();
  Scene scene = testing::read(file);
  testing::reverse(scene.draws[0]);
  EXPECT_LT(testing::write(scene).size(), file.size() + file.size() / 10);
}

TEST(GltfCompression, what_grows_names_what_grew) {
  Scene scene = testing::read(testing::ribbon(4));
  testing::reverse(scene.draws[0]);
  scene.draws[0].name = "x";
  scene.meshes[0].name = "a name that was not there before";
  const Written written = encode(scene);
  ASSERT_EQ(written.diagnostics.all().size(), 1u);
  EXPECT_EQ(written.diagnostics.all()[0].code, "output-grew");
  EXPECT_NE(written.diagnostics.all()[0].hint.find("JSON and padding"), std::string::npos);
}

TEST(GltfCompression, draws_that_part_ways_are_both_compressed) {
  Scene scene = testing::read(testing::compressed(testing::sharing()));
  testing::reverse(scene.draws[1]);
  const Written written = encode(scene);
  EXPECT_EQ(written.json["accessors"].size(), 4u);
  for (const GltfJson& view : written.json["bufferViews"]) EXPECT_TRUE(view.contains("extensions")) << view.dump();
  expect_same(testing::read(written.files[0].bytes), scene);
}

TEST(GltfCompression, several_meshes_in_one_view_of_narrow_indices_stay_tight) {
  GltfBuilder plain = testing::ribbon(3);
  GltfJson& json = plain.json;  // two draws from one index view, the second from its fourth triangle on
  json["accessors"].push_back(json["accessors"][2]);
  json["accessors"][2]["count"] = 9;
  json["accessors"][3]["count"] = 9;
  json["accessors"][3]["byteOffset"] = 18;
  json["meshes"][0]["primitives"].push_back(json["meshes"][0]["primitives"][0]);
  json["meshes"][0]["primitives"][1]["indices"] = 3;
  const Bytes file = testing::compressed(plain).glb();
  for (const bool both : {false, true}) {
    Scene scene = testing::read(file);
    testing::reverse(scene.draws[0]);
    if (both) testing::reverse(scene.draws[1]);
    const Written written = encode(scene);
    EXPECT_EQ(extension(written.json, 2)["count"], 18) << "no gap between the draws";
    expect_same(testing::read(written.files[0].bytes), scene);
  }
}

TEST(GltfCompression, unknown_extensions_keep_old_buffers_whole_and_streams_in_place) {
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

TEST(GltfCompression, a_plain_copy_that_is_a_file_is_written_beside_and_may_be_missing) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / "foredraw-compression-fallback";
  fs::remove_all(folder);
  fs::create_directories(folder);
  GltfBuilder builder = testing::compressed(testing::puppet());
  builder.json["buffers"][1]["uri"] = "plain%20copy.bin";
  const Bytes file = builder.glb();
  const auto put = [&](const char* name, const Bytes& bytes) {
    std::ofstream(folder / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  };
  put("in.glb", file);
  Diagnostics diagnostics;
  auto scene = read_gltf(folder / "in.glb", diagnostics);
  ASSERT_TRUE(scene) << to_text(diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 1u);
  EXPECT_EQ(diagnostics.all()[0].code, "fallback-missing");
  testing::reverse(scene->draws[0]);
  EXPECT_FALSE(encode(*scene).json["buffers"][1].contains("uri"));

  // The same, with the copy there: streams and copy are both what was changed.
  put("plain copy.bin", Bytes(builder.json["buffers"][1]["byteLength"].get<std::size_t>(), std::byte{1}));
  Diagnostics differing;
  scene = read_gltf(folder / "in.glb", differing);
  ASSERT_TRUE(scene) << to_text(differing);
  EXPECT_EQ(differing.all()[0].code, "plain-copy-differs");
  testing::reverse(scene->draws[0]);
  Written written = encode(*scene, Compression::keep, "out.gltf");
  ASSERT_EQ(written.files.size(), 3u);
  EXPECT_EQ(written.files[2].path, "out.fallback.bin");
  for (const OutputFile& one : written.files) put(one.path.c_str(), one.bytes);
  Diagnostics quiet;
  const auto again = read_gltf(folder / "out.gltf", quiet);
  ASSERT_TRUE(again && quiet.empty()) << to_text(quiet);
  expect_same(*again, *scene);
  fs::remove_all(folder);
}

/// A stream of a codec that is not known here, if with a first byte alone.
void make_unknown(GltfBuilder& builder, std::size_t view) {
  builder.buffer[extension(builder.json, view)["byteOffset"].get<std::size_t>()] = std::byte{0xa1};
}

TEST(GltfCompression, a_codec_that_is_not_known_is_refused_by_name_with_the_remedy) {
  GltfBuilder builder = testing::compressed(testing::puppet());
  make_unknown(builder, 0);
  Diagnostics diagnostics;
  EXPECT_FALSE(read_gltf(builder.glb(), "new", {}, diagnostics));
  EXPECT_EQ(diagnostics.all().at(0).code, "unsupported-extension");
  EXPECT_EQ(diagnostics.all()[0].where.inside, "bufferViews[0].extensions.EXT_meshopt_compression");
  EXPECT_EQ(diagnostics.all()[0].message, "EXT_meshopt_compression: vertex codec version 1 is not known here");
  EXPECT_NE(diagnostics.all()[0].hint.find("gltfpack -cc -ce ext"), std::string::npos);
}

TEST(GltfCompression, what_is_not_known_is_read_from_its_plain_copy_and_replaced_when_anything_changes) {
  for (const bool filter : {false, true}) {
    CompressionChoice choice;
    choice.plain = Plain::beside;
    GltfBuilder builder = testing::compressed(testing::puppet(), choice);
    if (filter) {
      builder.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"]["filter"] = "COLOR";
    } else {
      make_unknown(builder, 0);
    }
    Scene scene = testing::read(builder);
    expect_same(scene, testing::read(testing::puppet()));
    EXPECT_EQ(testing::write(scene), builder.glb());
    testing::reverse(scene.draws[0]);
    const Bytes again = testing::write(scene);
    EXPECT_EQ(stream(again, 0)[0], std::byte{0xa0});
    expect_same(testing::read(again), scene);
  }
}

struct Broken {
  const char* name;
  std::function<void(GltfBuilder&)> breaks;
  const char* code;
  const char* inside;
};

void PrintTo(const Broken& broken, std::ostream* out) { *out << broken.name; }

#define EXT "bufferViews[0].extensions.EXT_meshopt_compression"
#define INDEX_EXT "bufferViews[2].extensions.EXT_meshopt_compression"

GltfJson& ext(GltfBuilder& b, std::size_t view = 0) {
  return b.json["bufferViews"][view]["extensions"]["EXT_meshopt_compression"];
}

const std::uint64_t two_to_32 = std::uint64_t{1} << 32;

const Broken all_broken[] = {
    {"no_object", [](auto& b) { ext(b) = 7; }, "wrong-type", EXT},
    {"no_mode", [](auto& b) { ext(b).erase("mode"); }, "missing-member", EXT},
    {"mode_is_a_number", [](auto& b) { ext(b)["mode"] = 7; }, "wrong-type", EXT ".mode"},
    {"unknown_mode", [](auto& b) { ext(b)["mode"] = "MESHLETS"; }, "unsupported-extension", EXT},
    {"unknown_filter", [](auto& b) { ext(b)["filter"] = "COLOR"; }, "unsupported-extension", EXT},
    {"no_such_buffer", [](auto& b) { ext(b)["buffer"] = 7; }, "bad-reference", EXT ".buffer"},
    {"stream_in_the_fallback", [](auto& b) { ext(b)["buffer"] = 1; }, "view-range", EXT ".byteLength"},
    {"stream_too_long", [](auto& b) { ext(b)["byteLength"] = 100000; }, "view-range", EXT ".byteLength"},
    {"stream_far_off", [](auto& b) { ext(b)["byteOffset"] = two_to_32; }, "view-range", EXT ".byteLength"},
    {"stream_empty", [](auto& b) { ext(b)["byteLength"] = 0; }, "out-of-range", EXT ".byteLength"},
    {"count_0", [](auto& b) { ext(b)["count"] = 0; }, "out-of-range", EXT ".count"},
    {"count_2_32", [](auto& b) { ext(b)["count"] = two_to_32; }, "compressed-count", EXT ".count"},
    {"count_2_63", [](auto& b) { ext(b)["count"] = std::uint64_t{1} << 63; }, "out-of-range", EXT ".count"},
    {"everything_2_32",
     [](auto& b) {
       ext(b)["count"] = two_to_32;
       b.json["bufferViews"][0]["byteLength"] = 12 * two_to_32;
       b.json["bufferViews"][0]["byteOffset"] = 0;
       b.json["buffers"][1]["byteLength"] = 12 * two_to_32;
     },
     "compressed-count", EXT ".count"},
    {"stride_0", [](auto& b) { ext(b)["byteStride"] = 0; }, "out-of-range", EXT ".byteStride"},
    {"stride_257", [](auto& b) { ext(b)["byteStride"] = 257; }, "out-of-range", EXT ".byteStride"},
    {"stride_of_attributes",
     [](auto& b) {
       ext(b)["byteStride"] = 6;
       ext(b)["count"] = 20;
     },
     "view-stride", EXT ".byteStride"},
    {"stride_of_indices",
     [](auto& b) {
       ext(b, 2)["byteStride"] = 8;
       ext(b, 2)["count"] = 6;
     },
     "view-stride", INDEX_EXT ".byteStride"},
    {"strides_differ", [](auto& b) { b.json["bufferViews"][0]["byteStride"] = 24; }, "view-stride", EXT ".byteStride"},
    {"corners",
     [](auto& b) {
       ext(b, 2)["count"] = 23;
       b.json["bufferViews"][2]["byteLength"] = 46;
     },
     "index-count", INDEX_EXT ".count"},
    {"filter_of_indices", [](auto& b) { ext(b, 2)["filter"] = "EXPONENTIAL"; }, "compressed-filter",
     INDEX_EXT ".filter"},
    {"octahedral_of_12", [](auto& b) { ext(b)["filter"] = "OCTAHEDRAL"; }, "compressed-filter", EXT ".filter"},
    {"quaternion_of_12", [](auto& b) { ext(b)["filter"] = "QUATERNION"; }, "compressed-filter", EXT ".filter"},
    {"cut_short", [](auto& b) { ext(b)["byteLength"] = ext(b)["byteLength"].template get<int>() - 1; },
     "compressed-data", EXT},
    {"wrong_codec",
     [](auto& b) {
       ext(b)["mode"] = "INDICES";
       ext(b)["byteStride"] = 4;
       ext(b)["count"] = 30;
     },
     "compressed-data", EXT},
    {"both_extensions",
     [](auto& b) {
       const GltfJson copy = ext(b);
       b.json["bufferViews"][0]["extensions"]["KHR_meshopt_compression"] = copy;
     },
     "compressed-twice", "bufferViews[0]"},
    {"not_compressed_in_a_fallback", [](auto& b) { b.json["bufferViews"][0].erase("extensions"); }, "buffer-missing",
     "bufferViews[0]"},
    {"fallback_is_text",
     [](auto& b) { b.json["buffers"][1]["extensions"]["EXT_meshopt_compression"]["fallback"] = "yes"; }, "wrong-type",
     "buffers[1].extensions.EXT_meshopt_compression.fallback"},
    {"no_fallback", [](auto& b) { b.json["buffers"][1].erase("extensions"); }, "buffer-missing", "buffers[1]"},
    {"view_beyond_the_fallback", [](auto& b) { b.json["buffers"][1]["byteLength"] = 8; }, "view-range",
     "bufferViews[0].byteLength"},
};

class BrokenCompression : public ::testing::TestWithParam<Broken> {};

TEST_P(BrokenCompression, is_told_by_code_and_place) {
  GltfBuilder builder = testing::compressed(testing::puppet());
  GetParam().breaks(builder);
  Diagnostics diagnostics;
  EXPECT_FALSE(read_gltf(builder.glb(), "broken", {}, diagnostics).has_value());
  EXPECT_TRUE(std::ranges::any_of(diagnostics.all(),
                                  [&](const Diagnostic& d) {
                                    return d.severity == Severity::error && d.code == GetParam().code &&
                                           d.where.inside == GetParam().inside;
                                  }))
      << "wanted " << GetParam().code << " at " << GetParam().inside << ", got\n"
      << to_text(diagnostics);
}

INSTANTIATE_TEST_SUITE_P(Gltf, BrokenCompression, ::testing::ValuesIn(all_broken),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(GltfCompression, a_stream_is_not_asked_for_again_and_again) {
  GltfBuilder builder = testing::compressed(testing::puppet());
  const GltfJson view = builder.json["bufferViews"][0];
  for (int i = 0; i < 1000; ++i) builder.json["bufferViews"].push_back(view);
  Diagnostics diagnostics;
  EXPECT_FALSE(read_gltf(builder.glb(), "bomb", {}, diagnostics));
  EXPECT_EQ(diagnostics.all().at(0).code, "view-range");
}

/// Whatever one byte says, the file is refused or read, and what is read can be written and read again.
TEST(GltfCompression, every_byte_flipped_is_refused_or_read) {
  for (const GltfBuilder& builder : {with_filters(), testing::compressed(testing::puppet())}) {
    const Bytes file = builder.glb();
    std::size_t read = 0;
    for (std::size_t i = 0; i < file.size(); ++i) {
      for (const unsigned flip : {0xffu, 0x01u, 0x10u}) {
        Bytes changed = file;
        changed[i] ^= static_cast<std::byte>(flip);
        Diagnostics diagnostics;
        auto scene = read_gltf(changed, "flipped", {}, diagnostics);
        EXPECT_EQ(scene.has_value(), !diagnostics.has_errors()) << i;
        if (!scene || i % 16 != 0) continue;
        ++read;
        for (Draw& draw : scene->draws) {
          if (draw.topology == Topology::triangles) testing::reverse(draw);
        }
        Diagnostics writing;
        const auto files = encode_gltf(*scene, "out.glb", writing);
        if (files && files->size() == 1) {
          EXPECT_TRUE(read_gltf(files->front().bytes, "again", {}, writing)) << i << '\n' << to_text(writing);
        }
      }
    }
    EXPECT_GT(read, 10u);
  }
}

}  // namespace
}  // namespace foredraw

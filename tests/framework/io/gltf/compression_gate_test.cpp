// Compressed views that are broken, not known here, or claim too much are refused by code and place.
#include <foredraw/io/gltf/gltf.h>

#include <gtest/gtest.h>

#include <functional>

#include "framework/io/gltf/compressed_scenes.h"

namespace foredraw::compression_gate_test {
namespace {

using testing::Bytes;
using testing::GltfBuilder;
using testing::GltfJson;

TEST(GltfCompressionGate, a_codec_that_is_not_known_is_refused_by_name_with_the_remedy) {
  GltfBuilder builder = testing::compressed(testing::puppet());
  testing::make_unknown(builder, 0);
  Diagnostics diagnostics;
  EXPECT_FALSE(read_gltf(builder.glb(), "new", {}, diagnostics));
  EXPECT_EQ(diagnostics.all().at(0).code, "unsupported-extension");
  EXPECT_EQ(diagnostics.all()[0].where.inside, "bufferViews[0].extensions.EXT_meshopt_compression");
  EXPECT_EQ(diagnostics.all()[0].message, "EXT_meshopt_compression: vertex codec version 2 is not supported");
  EXPECT_NE(diagnostics.all()[0].hint.find("gltfpack -cz"), std::string::npos);
}

struct Broken {
  const char* name;
  std::function<void(GltfBuilder&)> breaks;
  const char* code;
  const char* inside;
};

void PrintTo(const Broken& broken, std::ostream* out) { *out << broken.name; }

#define MESHOPT_EXT "bufferViews[0].extensions.EXT_meshopt_compression"
#define MESHOPT_INDEX_EXT "bufferViews[2].extensions.EXT_meshopt_compression"

GltfJson& ext(GltfBuilder& b, std::size_t view = 0) {
  return b.json["bufferViews"][view]["extensions"]["EXT_meshopt_compression"];
}

const std::uint64_t two_to_32 = std::uint64_t{1} << 32;

const Broken all_broken[] = {
    {"no_object", [](auto& b) { ext(b) = 7; }, "wrong-type", MESHOPT_EXT},
    {"no_mode", [](auto& b) { ext(b).erase("mode"); }, "missing-member", MESHOPT_EXT},
    {"mode_is_a_number", [](auto& b) { ext(b)["mode"] = 7; }, "wrong-type", MESHOPT_EXT ".mode"},
    {"unknown_mode", [](auto& b) { ext(b)["mode"] = "MESHLETS"; }, "unsupported-extension", MESHOPT_EXT},
    {"unknown_filter", [](auto& b) { ext(b)["filter"] = "WAVELET"; }, "unsupported-extension", MESHOPT_EXT},
    {"no_such_buffer", [](auto& b) { ext(b)["buffer"] = 7; }, "bad-reference", MESHOPT_EXT ".buffer"},
    {"stream_in_the_fallback", [](auto& b) { ext(b)["buffer"] = 1; }, "view-range", MESHOPT_EXT ".byteLength"},
    {"stream_too_long", [](auto& b) { ext(b)["byteLength"] = 100000; }, "view-range", MESHOPT_EXT ".byteLength"},
    {"stream_far_off", [](auto& b) { ext(b)["byteOffset"] = two_to_32; }, "view-range", MESHOPT_EXT ".byteLength"},
    {"stream_empty", [](auto& b) { ext(b)["byteLength"] = 0; }, "out-of-range", MESHOPT_EXT ".byteLength"},
    {"count_0", [](auto& b) { ext(b)["count"] = 0; }, "out-of-range", MESHOPT_EXT ".count"},
    {"count_2_32", [](auto& b) { ext(b)["count"] = two_to_32; }, "compressed-count", MESHOPT_EXT ".count"},
    {"count_2_63", [](auto& b) { ext(b)["count"] = std::uint64_t{1} << 63; }, "out-of-range", MESHOPT_EXT ".count"},
    {"everything_2_32",
     [](auto& b) {
       ext(b)["count"] = two_to_32;
       b.json["bufferViews"][0]["byteLength"] = 12 * two_to_32;
       b.json["bufferViews"][0]["byteOffset"] = 0;
       b.json["buffers"][1]["byteLength"] = 12 * two_to_32;
     },
     "compressed-count", MESHOPT_EXT ".count"},
    {"stride_0", [](auto& b) { ext(b)["byteStride"] = 0; }, "out-of-range", MESHOPT_EXT ".byteStride"},
    {"stride_257", [](auto& b) { ext(b)["byteStride"] = 257; }, "out-of-range", MESHOPT_EXT ".byteStride"},
    {"stride_of_attributes",
     [](auto& b) {
       ext(b)["byteStride"] = 6;
       ext(b)["count"] = 20;
     },
     "view-stride", MESHOPT_EXT ".byteStride"},
    {"stride_of_indices",
     [](auto& b) {
       ext(b, 2)["byteStride"] = 8;
       ext(b, 2)["count"] = 6;
     },
     "view-stride", MESHOPT_INDEX_EXT ".byteStride"},
    {"strides_differ", [](auto& b) { b.json["bufferViews"][0]["byteStride"] = 24; }, "view-stride",
     MESHOPT_EXT ".byteStride"},
    {"corners",
     [](auto& b) {
       ext(b, 2)["count"] = 23;
       b.json["bufferViews"][2]["byteLength"] = 46;
     },
     "index-count", MESHOPT_INDEX_EXT ".count"},
    {"filter_of_indices", [](auto& b) { ext(b, 2)["filter"] = "EXPONENTIAL"; }, "compressed-filter",
     MESHOPT_INDEX_EXT ".filter"},
    {"octahedral_of_12", [](auto& b) { ext(b)["filter"] = "OCTAHEDRAL"; }, "compressed-filter", MESHOPT_EXT ".filter"},
    {"color_of_12", [](auto& b) { ext(b)["filter"] = "COLOR"; }, "compressed-filter", MESHOPT_EXT ".filter"},
    {"quaternion_of_12", [](auto& b) { ext(b)["filter"] = "QUATERNION"; }, "compressed-filter", MESHOPT_EXT ".filter"},
    {"cut_short", [](auto& b) { ext(b)["byteLength"] = ext(b)["byteLength"].template get<int>() - 1; },
     "compressed-data", MESHOPT_EXT},
    {"wrong_codec",
     [](auto& b) {
       ext(b)["mode"] = "INDICES";
       ext(b)["byteStride"] = 4;
       ext(b)["count"] = 30;
     },
     "compressed-data", MESHOPT_EXT},
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
    {"no_fallback_for_a_plain_view",
     [](auto& b) {
       b.json["buffers"][1].erase("extensions");
       b.json["bufferViews"][0].erase("extensions");
     },
     "buffer-missing", "buffers[1]"},
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

TEST(GltfCompressionGate, a_stream_is_not_asked_for_again_and_again) {
  GltfBuilder builder = testing::compressed(testing::puppet());
  const GltfJson view = builder.json["bufferViews"][0];
  for (int i = 0; i < 1000; ++i) builder.json["bufferViews"].push_back(view);
  Diagnostics diagnostics;
  EXPECT_FALSE(read_gltf(builder.glb(), "bomb", {}, diagnostics));
  EXPECT_EQ(diagnostics.all().at(0).code, "view-range");
}

/// Equal elements take a byte for a thousand in version 1 of the vertex codec.
TEST(GltfCompressionGate, a_small_stream_does_not_stand_for_much) {
  constexpr std::size_t blocks = 300'000, stride = 4;
  GltfBuilder builder = testing::compressed(testing::puppet());
  Bytes stream(1 + blocks, std::byte{0xaa});  // all planes are zeros
  stream[0] = std::byte{0xa1};
  stream.resize(stream.size() + 24);
  GltfJson view{{"buffer", 1}, {"byteLength", blocks * 256 * stride}};
  GltfJson& coded = view["extensions"]["EXT_meshopt_compression"];
  coded = {{"buffer", 0},
           {"byteOffset", builder.buffer.size()},
           {"byteLength", stream.size()},
           {"byteStride", stride},
           {"count", blocks * 256},
           {"mode", "ATTRIBUTES"}};
  builder.buffer.insert(builder.buffer.end(), stream.begin(), stream.end());
  builder.json["buffers"][0]["byteLength"] = builder.buffer.size();
  builder.json["buffers"][1]["byteLength"] = 2 * blocks * 256 * stride;
  builder.json["bufferViews"].push_back(view);
  Diagnostics diagnostics;
  EXPECT_FALSE(read_gltf(builder.glb(), "bomb", {}, diagnostics));
  EXPECT_EQ(diagnostics.all().at(0).code, "compressed-count");
  EXPECT_NE(diagnostics.all()[0].message.find("stand for"), std::string::npos) << diagnostics.all()[0].message;
}

/// Whatever one byte says, the file is refused or read, and what is read can be written and read again.
TEST(GltfCompressionGate, every_byte_flipped_is_refused_or_read) {
  for (const GltfBuilder& builder : {testing::with_filters(), testing::compressed(testing::puppet())}) {
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
}  // namespace foredraw::compression_gate_test

#pragma once
// What the tests of compressed files read, and how what they read is compared.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "framework/io/gltf/edits.h"
#include "support/compressed_gltf.h"

namespace foredraw::testing {

/// Each triangle from the corner on that makes it least: TRIANGLES keeps no more.
inline Indices turned(Indices indices) {
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const std::uint32_t a = indices[i], b = indices[i + 1], c = indices[i + 2];
    const auto least = std::min({std::array{a, b, c}, std::array{b, c, a}, std::array{c, a, b}});
    std::copy(least.begin(), least.end(), indices.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return indices;
}

inline void expect_same(const Scene& is, const Scene& want, bool exactly = false) {
  ASSERT_EQ(is.draws.size(), want.draws.size());
  for (std::size_t d = 0; d < is.draws.size(); ++d) {
    const Indices a = indices_of(is, d), b = indices_of(want, d);
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

inline const GltfJson& extension(const GltfJson& json, std::size_t view, const char* name = "EXT_meshopt_compression") {
  return json["bufferViews"][view]["extensions"][name];
}

/// What a compressed view of a .glb holds.
inline Bytes stream_of(const Bytes& glb, std::size_t view) {
  const GltfJson json = json_of(glb);
  const Bytes bin = builder_of(glb).buffer;
  const auto from = bin.begin() + extension(json, view).value("byteOffset", std::ptrdiff_t{0});
  return {from, from + extension(json, view)["byteLength"].get<std::ptrdiff_t>()};
}

struct Written {
  std::vector<OutputFile> files;
  Diagnostics diagnostics;
  GltfJson json;
};

inline Written encode(const Scene& scene, Compression compression = Compression::keep, const char* target = "out.glb") {
  Written written;
  auto files = encode_gltf(scene, target, written.diagnostics, {.compression = compression});
  if (!files) throw std::runtime_error(to_text(written.diagnostics));
  written.files = std::move(*files);
  written.json = json_of(written.files.front().bytes);
  return written;
}

/// Views: 0 positions as floats, 1 uvs, 2 indices, 3 normals of 8 bits, 4 a tangent-like stream of 16.
inline GltfBuilder with_filters(CompressionChoice choice = {}) {
  GltfBuilder plain = ribbon(40);
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
  return compressed(plain, choice);
}

/// A stream of a codec that is not known here, if with a first byte alone.
inline void make_unknown(GltfBuilder& builder, std::size_t view) {
  builder.buffer[extension(builder.json, view)["byteOffset"].get<std::size_t>()] = std::byte{0xa2};
}

}  // namespace foredraw::testing

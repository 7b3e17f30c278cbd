// Values that codecs stumble over, and attributes of every type, under Draco: all come back to the last bit, or stay
// plain and are told.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "framework/io/gltf/compressed_scenes.h"
#include "support/draco_gltf.h"

namespace foredraw::draco_exact_test {
namespace {

using testing::encode;
using testing::expect_same;
using testing::GltfBuilder;
using testing::GltfJson;
using testing::indices_of;
using testing::ribbon;
using testing::Written;

constexpr const char* extension = "KHR_draco_mesh_compression";
constexpr std::size_t squares = 300, vertices = 2 * squares + 2;

GltfJson& attributes_of(GltfBuilder& builder) { return builder.json["meshes"][0]["primitives"][0]["attributes"]; }

bool is_plain(const GltfJson& json, const char* attribute) {
  const auto accessor = json["meshes"][0]["primitives"][0]["attributes"][attribute].get<std::size_t>();
  return json["accessors"][accessor].contains("bufferView");
}

bool tells(const Written& written, const std::string& code) {
  return std::ranges::any_of(written.diagnostics.all(), [&](const Diagnostic& one) { return one.code == code; });
}

/// Decoded by libdraco alone, every vertex and every corner is where it was.
void expect_exact(const Scene& scene, const Written& written) {
  expect_same(testing::read(written.files[0].bytes), scene, true);
  const GltfBuilder made = testing::builder_of(written.files[0].bytes);
  const GltfJson& told = made.json["meshes"][0]["primitives"][0]["extensions"][extension];
  const auto buffer = testing::view_bytes(made, told["bufferView"]);
  EXPECT_EQ(buffer[8], std::byte{0});  // the sequential method
  const auto decoded = testing::decoded_by_draco(buffer);
  EXPECT_EQ(decoded.indices, indices_of(scene, 0));
  for (const auto& [name, id] : told["attributes"].items()) {
    const auto want = testing::stream(scene, 0, name.c_str()).bytes.view();
    EXPECT_TRUE(std::ranges::equal(decoded.attributes.at(id), want)) << name;
  }
}

template <class T>
void expect_every_shape(bool normalized) {
  const std::pair<const char*, std::size_t> shapes[] = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}};
  for (const auto& [shape, components] : shapes) {
    GltfBuilder plain = ribbon(squares);
    std::vector<T> values;
    for (std::size_t i = 0; i < vertices * components; ++i)
      values.push_back(static_cast<T>(i * (sizeof(T) == 4 ? 1000 : 40503)));
    values[1] = std::numeric_limits<T>::lowest();
    if (sizeof(T) < 4) values[5] = std::numeric_limits<T>::max();
    const std::size_t accessor = plain.add_values(values, shape);
    if (normalized) plain.json["accessors"][accessor]["normalized"] = true;
    attributes_of(plain)["_DATA"] = accessor;
    const Scene scene = testing::read(plain);
    const Written written = encode(scene, Compression::draco);
    expect_exact(scene, written);
    EXPECT_FALSE(is_plain(written.json, "_DATA")) << shape << " of " << sizeof(T);
  }
}

TEST(DracoExact, attributes_of_every_type_come_back) {
  for (const bool normalized : {false, true}) {
    expect_every_shape<std::int8_t>(normalized);
    expect_every_shape<std::uint8_t>(normalized);
    expect_every_shape<std::int16_t>(normalized);
    expect_every_shape<std::uint16_t>(normalized);
  }
  expect_every_shape<std::uint32_t>(false);
}

TEST(DracoExact, what_draco_can_not_hold_stays_plain_beside_the_others_and_is_told) {
  GltfBuilder plain = ribbon(squares);
  std::vector<std::uint32_t> large(vertices, 0x80000000u), apart(vertices, 7);
  apart[3] = 0x7fffffff;  // libdraco would ask for memory for each number between
  attributes_of(plain)["_LARGE"] = plain.add_values(large, "SCALAR");
  attributes_of(plain)["_APART"] = plain.add_values(apart, "SCALAR");
  const std::vector<std::byte> matrices(8 * vertices, std::byte{7});  // of 2 by 2 bytes, each column in four
  attributes_of(plain)["_TURN"] = plain.add_accessor(plain.add_view(matrices, 8), 0, 5121, "MAT2", vertices);
  const Scene scene = testing::read(plain);
  for (const Compression how : {Compression::draco, Compression::draco_edgebreaker}) {
    const Written written = encode(scene, how);
    expect_exact(scene, written);
    EXPECT_TRUE(is_plain(written.json, "_LARGE"));
    EXPECT_TRUE(is_plain(written.json, "_APART"));
    EXPECT_TRUE(is_plain(written.json, "_TURN"));
    EXPECT_FALSE(is_plain(written.json, "POSITION"));
    EXPECT_TRUE(tells(written, "draco-left-out"));
    EXPECT_EQ(tells(written, "draco-keeps-order"), how == Compression::draco_edgebreaker);
  }
}

class DracoFloats : public ::testing::TestWithParam<std::pair<const char*, float>> {};

TEST_P(DracoFloats, come_back_to_the_last_bit) {
  const float odd = GetParam().second;
  for (const char* name : {"_DATA", "TEXCOORD_0", "NORMAL", "COLOR_0", "TANGENT"}) {
    GltfBuilder plain = ribbon(squares);
    const std::size_t components = name == std::string("TEXCOORD_0") ? 2 : name == std::string("TANGENT") ? 4 : 3;
    std::vector<float> values(vertices * components);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i % 8) / 8;
    values[17] = odd;
    values[900] = -odd;
    attributes_of(plain)[name] = plain.add_values(values, "VEC" + std::to_string(components));
    const Scene scene = testing::read(plain);
    const Written written = encode(scene, Compression::draco);
    expect_exact(scene, written);
    EXPECT_TRUE(tells(written, "draco-keeps-floats")) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Gltf, DracoFloats,
                         ::testing::Values(std::pair{"nan", std::numeric_limits<float>::quiet_NaN()},
                                           std::pair{"infinite", std::numeric_limits<float>::infinity()},
                                           std::pair{"zero_below", -0.0f}, std::pair{"denormal", 1e-42f},
                                           std::pair{"least_denormal", 1.4e-45f}, std::pair{"large", 1e30f},
                                           std::pair{"largest", std::numeric_limits<float>::max()},
                                           std::pair{"third", 1.0f / 3}),
                         [](const auto& info) { return info.param.first; });

TEST(DracoExact, positions_of_every_size_come_back) {
  for (const float size : {1e-42f, 1e-30f, 1.0f, 1e9f, 1e30f}) {
    GltfBuilder plain = ribbon(squares);
    std::vector<float> positions;
    for (std::size_t v = 0; v < vertices; ++v)
      positions.insert(positions.end(), {size * static_cast<float>(v / 2), size * static_cast<float>(v % 2), -size});
    attributes_of(plain)["POSITION"] = plain.add_values(positions, "VEC3");
    const Scene scene = testing::read(plain);
    expect_exact(scene, encode(scene, Compression::draco));
  }
}

/// JSON has no infinite numbers: where the order is another, ranges are told anew.
TEST(DracoExact, ranges_are_of_finite_positions) {
  GltfBuilder plain = ribbon(squares);
  std::vector<float> positions;
  for (std::size_t v = 0; v < vertices; ++v)
    positions.insert(positions.end(), {static_cast<float>(v / 2), static_cast<float>(v % 2), HUGE_VALF});
  GltfJson& attributes = attributes_of(plain);
  attributes = {{"POSITION", plain.add_values(positions, "VEC3")}};
  GltfJson& accessor = plain.json["accessors"][attributes["POSITION"].get<std::size_t>()];
  accessor["min"] = {0, 0, 0}, accessor["max"] = {squares, 1, 1};
  const Written written = encode(testing::read(plain), Compression::draco_edgebreaker);
  ASSERT_TRUE(tells(written, "draco-reorders"));
  for (const GltfJson& one : written.json["accessors"]) {
    for (const char* key : {"min", "max"}) {
      for (const GltfJson& number : one.value(key, GltfJson::array())) EXPECT_TRUE(number.is_number()) << one;
    }
  }
}

TEST(DracoExact, texture_coordinates_of_a_thousand_tiles_come_back) {
  for (const int bits : {8, 11, 14, 18}) {  // behind the point; 22 in all are held short
    GltfBuilder plain = ribbon(squares);
    std::vector<float> uvs;
    for (std::size_t i = 0; i < 2 * vertices; ++i)
      uvs.push_back(static_cast<float>(i % 1001) - std::ldexp(static_cast<float>(i % 3), -bits));
    uvs[0] = 1000, uvs[2] = -1000 + std::ldexp(1.0f, -bits);
    attributes_of(plain)["TEXCOORD_0"] = plain.add_values(uvs, "VEC2");
    const Scene scene = testing::read(plain);
    const Written written = encode(scene, Compression::draco);
    expect_exact(scene, written);
    EXPECT_EQ(tells(written, "draco-keeps-floats"), bits > 11) << bits;
  }
}

}  // namespace
}  // namespace foredraw::draco_exact_test

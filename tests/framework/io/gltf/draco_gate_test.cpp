// Draco's buffers that are broken, claim too much, or do not hold what their accessors say.
#include <foredraw/io/gltf/codecs/private/draco.h>
#include <foredraw/io/gltf/gltf.h>
#include <foredraw/platform/memory.h>

#include <gtest/gtest.h>

#include <functional>

#include "support/draco_gltf.h"

namespace foredraw::draco_gate_test {
namespace {

using testing::draco_compressed;
using testing::GltfBuilder;
using testing::GltfJson;
using testing::ribbon;

#define PRIMITIVE "meshes[0].primitives[0]"
#define DRACO_EXT PRIMITIVE ".extensions.KHR_draco_mesh_compression"

GltfJson& primitive(GltfBuilder& b) { return b.json["meshes"][0]["primitives"][0]; }
GltfJson& ext(GltfBuilder& b) { return primitive(b)["extensions"]["KHR_draco_mesh_compression"]; }
GltfJson& accessor(GltfBuilder& b, const char* semantic) {
  return b.json["accessors"][primitive(b)["attributes"][semantic].get<std::size_t>()];
}
GltfJson& indices(GltfBuilder& b) { return b.json["accessors"][primitive(b)["indices"].get<std::size_t>()]; }

std::byte& coded_byte(GltfBuilder& b, std::size_t i) {
  const std::size_t view = ext(b)["bufferView"];
  return b.buffer[b.json["bufferViews"][view].value("byteOffset", std::size_t{0}) + i];
}

struct Broken {
  const char* name;
  std::function<void(GltfBuilder&)> breaks;
  const char* code;
  const char* inside;
};

void PrintTo(const Broken& broken, std::ostream* out) { *out << broken.name; }

const Broken all_broken[] = {
    {"no_object", [](auto& b) { ext(b) = 7; }, "wrong-type", DRACO_EXT},
    {"no_view", [](auto& b) { ext(b).erase("bufferView"); }, "missing-member", DRACO_EXT},
    {"no_such_view", [](auto& b) { ext(b)["bufferView"] = 70; }, "bad-reference", DRACO_EXT ".bufferView"},
    {"no_ids", [](auto& b) { ext(b).erase("attributes"); }, "missing-member", DRACO_EXT},
    {"ids_are_a_list",
     [](auto& b) {
       ext(b)["attributes"] = {0, 1};
     },
     "wrong-type", DRACO_EXT ".attributes"},
    {"ids_are_empty", [](auto& b) { ext(b)["attributes"] = GltfJson::object(); }, "out-of-range",
     DRACO_EXT ".attributes"},
    {"id_is_text", [](auto& b) { ext(b)["attributes"]["POSITION"] = "0"; }, "wrong-type",
     DRACO_EXT ".attributes.POSITION"},
    {"id_2_32", [](auto& b) { ext(b)["attributes"]["POSITION"] = std::uint64_t{1} << 32; }, "out-of-range",
     DRACO_EXT ".attributes.POSITION"},
    {"id_that_is_not_there", [](auto& b) { ext(b)["attributes"]["POSITION"] = 7; }, "compressed-attribute", DRACO_EXT},
    {"id_of_another_attribute", [](auto& b) { ext(b)["attributes"]["POSITION"] = ext(b)["attributes"]["TEXCOORD_0"]; },
     "compressed-attribute", DRACO_EXT},
    {"other_components", [](auto& b) { accessor(b, "POSITION")["type"] = "VEC4"; }, "compressed-attribute", DRACO_EXT},
    {"other_type", [](auto& b) { accessor(b, "POSITION")["componentType"] = 5123; }, "compressed-attribute", DRACO_EXT},
    {"matrices", [](auto& b) { accessor(b, "POSITION")["type"] = "MAT2"; }, "compressed-attribute", DRACO_EXT},
    {"attribute_that_the_primitive_lacks", [](auto& b) { ext(b)["attributes"]["COLOR_0"] = 1; }, "compressed-attribute",
     DRACO_EXT ".attributes.COLOR_0"},
    {"no_indices", [](auto& b) { primitive(b).erase("indices"); }, "missing-member", PRIMITIVE},
    {"indices_are_floats", [](auto& b) { indices(b)["componentType"] = 5126; }, "index-type", PRIMITIVE ".indices"},
    {"points", [](auto& b) { primitive(b)["mode"] = 0; }, "out-of-range", PRIMITIVE ".mode"},
    {"counts_differ", [](auto& b) { accessor(b, "POSITION")["count"] = 17; }, "unequal-counts",
     PRIMITIVE ".attributes.TEXCOORD_0"},
    {"far_fewer_claimed",
     [](auto& b) {
       accessor(b, "POSITION")["count"] = accessor(b, "TEXCOORD_0")["count"] = 1;
       indices(b)["count"] = 3;
     },
     "compressed-count", DRACO_EXT},
    {"far_more_claimed",
     [](auto& b) { accessor(b, "POSITION")["count"] = accessor(b, "TEXCOORD_0")["count"] = 4000000000u; },
     "compressed-count", DRACO_EXT},
    {"morph_targets_of_another_count",
     [](auto& b) { primitive(b)["targets"][0]["POSITION"] = b.add_values(std::vector<float>(9, 1.0f), "VEC3"); },
     "unequal-counts", PRIMITIVE ".targets[0].POSITION"},
    {"no_draco", [](auto& b) { coded_byte(b, 0) = std::byte{'d'}; }, "compressed-data", DRACO_EXT},
    {"older_bitstream", [](auto& b) { coded_byte(b, 6) = std::byte{1}; }, "unsupported-extension", DRACO_EXT},
    {"point_cloud", [](auto& b) { coded_byte(b, 7) = std::byte{0}; }, "compressed-data", DRACO_EXT},
    {"unknown_method", [](auto& b) { coded_byte(b, 8) = std::byte{9}; }, "compressed-data", DRACO_EXT},
    {"cut_short",
     [](auto& b) { b.json["bufferViews"][ext(b)["bufferView"].template get<std::size_t>()]["byteLength"] = 99; },
     "compressed-data", DRACO_EXT},
};

class BrokenDraco : public ::testing::TestWithParam<Broken> {};

TEST_P(BrokenDraco, is_told_by_code_and_place) {
  GltfBuilder builder = draco_compressed(ribbon(2000), {.bits = 12});
  GetParam().breaks(builder);
  Diagnostics diagnostics;
  EXPECT_FALSE(read_gltf(builder.glb(), "broken", {}, diagnostics));
  ASSERT_EQ(diagnostics.all().size(), 1u) << to_text(diagnostics);
  EXPECT_EQ(diagnostics.all()[0].code, GetParam().code) << to_text(diagnostics);
  EXPECT_EQ(diagnostics.all()[0].where.inside, GetParam().inside) << to_text(diagnostics);
}

INSTANTIATE_TEST_SUITE_P(Gltf, BrokenDraco, ::testing::ValuesIn(all_broken),
                         [](const auto& info) { return std::string(info.param.name); });

gltf::DracoClaim claim_of(std::size_t points, std::size_t triangles) {
  return {points, triangles, {{0, {Component::float32, 3, false, 12}}}};
}

const gltf::DracoFault* fault_of(const std::variant<gltf::DracoMesh, gltf::DracoFault>& result) {
  return std::get_if<gltf::DracoFault>(&result);
}

/// Draco's beginning, then these bytes.
std::vector<std::byte> buffer_of(int method, std::initializer_list<int> rest) {
  std::vector<std::byte> bytes = testing::bytes_of("DRACO");
  for (const int byte : {2, 2, 1, method, 0, 0}) bytes.push_back(static_cast<std::byte>(byte));
  for (const int byte : rest) bytes.push_back(static_cast<std::byte>(byte));
  bytes.resize(1024, std::byte{0xff});
  return bytes;
}

/// 2^31 vertices and more, in varints, with all 255 attributes.
TEST(GltfDracoGate, a_bomb_is_refused_before_memory_is_asked_for) {
  const MemoryWatch memory;
  const auto edgebreaker = buffer_of(1, {0, 0x80, 0x80, 0x80, 0x80, 0x08, 0x80, 0x80, 0x80, 0x80, 0x04, 0xff});
  const auto sequential = buffer_of(0, {0x80, 0x80, 0x80, 0x80, 0x04, 0x80, 0x80, 0x80, 0x80, 0x08});
  for (const auto& bytes : {edgebreaker, sequential}) {
    const auto result = gltf::draco_decoded(bytes, claim_of(1000, 2000));
    ASSERT_NE(fault_of(result), nullptr);
    EXPECT_EQ(fault_of(result)->code, "compressed-count") << fault_of(result)->message;
  }
  EXPECT_LT(memory.growth().value_or(0), 100'000'000u);
}

/// How texture coordinates turn is told by a count of its own, of up to 2^31, which the last attribute's values follow.
/// To read so many takes seconds in each of these files, and longer than a test may take in all of them.
TEST(GltfDracoGate, a_bomb_within_the_predictions_is_refused) {
  GltfBuilder builder = draco_compressed(ribbon(400), {.bits = 12, .speed = 0});
  const auto bytes = testing::view_bytes(builder, ext(builder)["bufferView"]);
  const auto claim = claim_of(accessor(builder, "POSITION")["count"], 800);
  ASSERT_EQ(fault_of(gltf::draco_decoded(bytes, claim)), nullptr);
  std::size_t refused = 0;
  for (std::size_t at = 11; at + 4 <= bytes.size(); ++at) {
    std::vector<std::byte> bad(bytes.begin(), bytes.end());
    for (const std::size_t i : {0, 1, 2, 3}) bad[at + i] = static_cast<std::byte>(i == 3 ? 0x7f : 0xff);
    refused += fault_of(gltf::draco_decoded(bad, claim)) != nullptr;
  }
  EXPECT_GT(refused, 0u);
}

struct Way {
  const char* name;
  testing::DracoChoice choice;
};

class HostileDraco : public ::testing::TestWithParam<Way> {};

/// What is cut or changed is refused, or read as something of the same kind: never more than was there before.
void expect_bounded(std::span<const std::byte> bytes, const gltf::DracoClaim& claim) {
  const auto result = gltf::draco_decoded(bytes, claim);
  if (fault_of(result) != nullptr) return;
  const auto& mesh = std::get<gltf::DracoMesh>(result);
  EXPECT_LE(12 * mesh.indices.size(), 16 * claim.bytes() + 65536);
  for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, mesh.points);
  for (const auto& attribute : mesh.attributes) EXPECT_EQ(attribute.size(), 12 * mesh.points);
}

TEST_P(HostileDraco, cut_anywhere) {
  GltfBuilder builder = draco_compressed(ribbon(40), GetParam().choice);
  const auto bytes = testing::view_bytes(builder, ext(builder)["bufferView"]);
  const auto claim = claim_of(82, 80);
  ASSERT_EQ(fault_of(gltf::draco_decoded(bytes, claim)), nullptr);
  for (std::size_t n = 0; n < bytes.size(); ++n) expect_bounded(bytes.first(n), claim);
  EXPECT_NE(fault_of(gltf::draco_decoded(bytes.first(bytes.size() / 2), claim)), nullptr);
}

TEST_P(HostileDraco, any_bit_flipped) {
  GltfBuilder builder = draco_compressed(ribbon(40), GetParam().choice);
  const auto bytes = testing::view_bytes(builder, ext(builder)["bufferView"]);
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    std::vector<std::byte> bad(bytes.begin(), bytes.end());
    bad[bit / 8] ^= static_cast<std::byte>(1 << (bit % 8));
    expect_bounded(bad, claim_of(82, 80));
  }
}

TEST_P(HostileDraco, any_byte_full) {
  GltfBuilder builder = draco_compressed(ribbon(40), GetParam().choice);
  const auto bytes = testing::view_bytes(builder, ext(builder)["bufferView"]);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::vector<std::byte> bad(bytes.begin(), bytes.end());
    bad[i] = std::byte{0xff};
    expect_bounded(bad, claim_of(82, 80));
  }
}

INSTANTIATE_TEST_SUITE_P(Ways, HostileDraco,
                         ::testing::Values(Way{"sequential", {.sequential = true}},
                                           Way{"sequential_small", {.sequential = true, .bits = 11, .speed = 0}},
                                           Way{"edgebreaker", {}}, Way{"edgebreaker_small", {.bits = 11, .speed = 0}},
                                           Way{"edgebreaker_fast", {.bits = 11, .speed = 10}}),
                         [](const auto& info) { return std::string(info.param.name); });

/// The sequential method writes indices as they are, and libdraco does not look at them.
TEST(GltfDracoGate, an_index_beyond_the_vertices_is_refused) {
  GltfBuilder builder = draco_compressed(ribbon(4), {.sequential = true, .speed = 10});
  const auto bytes = testing::view_bytes(builder, ext(builder)["bufferView"]);
  std::vector<std::byte> bad(bytes.begin(), bytes.end());
  // 11 bytes of header, triangles, vertices, method; then a byte each
  ASSERT_EQ(bad[13], std::byte{1});
  ASSERT_EQ(bad[14], std::byte{0});
  bad[14 + 2] = std::byte{10};
  const auto result = gltf::draco_decoded(bad, claim_of(10, 8));
  ASSERT_NE(fault_of(result), nullptr);
  EXPECT_EQ(fault_of(result)->code, "compressed-data");
}

}  // namespace
}  // namespace foredraw::draco_gate_test

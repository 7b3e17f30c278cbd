// Wires in files that are damaged, or left by another tool: left out with a warning, or made anew.
#include "support/wire_scenes.h"

#include <cstring>
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace foredraw::wire_radius_damage_test {
namespace {

using testing::GltfJson;
using ::testing::HasSubstr;
using testing::with_wires;

struct Wrong {
  const char* name;
  std::function<void(GltfJson& json, GltfJson& primitive)> make;
  const char* why;
};
void PrintTo(const Wrong& wrong, std::ostream* out) { *out << wrong.name; }

class WrongWires : public ::testing::TestWithParam<Wrong> {};

TEST_P(WrongWires, AreLeftOutWithAWarning) {
  const std::vector<std::byte> glb = testing::written_with_wires(with_wires());
  std::uint32_t length = 0;
  std::memcpy(&length, glb.data() + 12, 4);
  GltfJson json = testing::json_of(glb);
  GetParam().make(json, json["meshes"][0]["primitives"][0]);
  const std::vector<std::byte> bin(glb.begin() + 20 + length + 8, glb.end());
  Diagnostics diagnostics;
  const auto scene = testing::read_with_wires(testing::glb_of(json.dump(), bin), diagnostics);
  ASSERT_TRUE(scene) << to_text(diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 1u) << to_text(diagnostics);
  EXPECT_EQ(diagnostics.all()[0].code, "wires-left-out");
  EXPECT_THAT(diagnostics.all()[0].message, HasSubstr(GetParam().why));
  EXPECT_FALSE(scene->products.has(Wires::product));
}

GltfJson& extension(GltfJson& primitive) { return primitive["extensions"]["FOREDRAW_wires"]; }

INSTANTIATE_TEST_SUITE_P(
    Files, WrongWires,
    ::testing::Values(
        Wrong{"NoFirst", [](GltfJson&, GltfJson& p) { extension(p).erase("firstTriangle"); }, "has no 'firstTriangle'"},
        Wrong{"FirstBeyond", [](GltfJson&, GltfJson& p) { extension(p)["firstTriangle"] = 4000000000u; },
              "number of triangles"},
        Wrong{"FirstTooEarly",
              [](GltfJson&, GltfJson& p) {
                extension(p)["firstTriangle"] = extension(p)["firstTriangle"].get<int>() - 1;
                extension(p)["wires"][0]["triangles"] = extension(p)["wires"][0]["triangles"].get<int>() + 1;
              },
              "its vertices are not"},
        Wrong{"NoWires", [](GltfJson&, GltfJson& p) { extension(p)["wires"] = GltfJson::array(); },
              "number of triangles"},
        Wrong{"NoKind", [](GltfJson&, GltfJson& p) { extension(p)["wires"][0]["kind"] = "rod"; }, "wire 0"},
        Wrong{"NoRadius", [](GltfJson&, GltfJson& p) { extension(p)["wires"][1]["radius"] = 0; }, "wire 1"},
        Wrong{"NoStream", [](GltfJson&, GltfJson& p) { p["attributes"].erase("_FOREDRAW_WIRE"); },
              "lacks one of their streams"},
        Wrong{"OldAxis",
              [](GltfJson& json, GltfJson& p) {
                json["accessors"][p["attributes"]["_FOREDRAW_WIRE_AXIS"].get<std::size_t>()]["type"] = "VEC3";
              },
              "lacks one of their streams"},
        Wrong{"WrongStream",
              [](GltfJson&, GltfJson& p) { p["attributes"]["_FOREDRAW_WIRE"] = p["attributes"]["POSITION"]; },
              "lacks one of their streams"},
        Wrong{
            "OtherStream",
            [](GltfJson&, GltfJson& p) { p["attributes"]["_FOREDRAW_WIRE"] = p["attributes"]["_FOREDRAW_WIRE_AXIS"]; },
            "its vertices are not"}),
    [](const auto& test) { return std::string(test.param.name); });

/// A stream that another tool left, of any type, gives way to ours.
TEST(WireRadiusFiles, StaleStreamsGiveWay) {
  testing::GltfBuilder builder = testing::mixed({"flat rope"});
  const bench::KnownMesh mesh = testing::made_wire("flat rope");
  const std::vector<float> stale(mesh.positions.size(), 7);
  builder.json["meshes"][0]["primitives"][0]["attributes"]["_FOREDRAW_WIRE"] = builder.add_values(stale, "SCALAR");
  const Scene scene = testing::run("wire-radius", testing::scene_of_file(builder)).scene;
  EXPECT_EQ(wires_product()->difference(scene), "");
  const VertexStreams& vertices = *scene.draws[0].full().vertices;
  EXPECT_EQ(std::ranges::count(vertices.base, std::string(wire_semantic), &VertexStream::semantic), 1);
}

TEST(WireRadiusFiles, WrongTextureCoordinatesAreLeftOut) {
  const std::vector<std::byte> glb =
      testing::written_with_wires(testing::run("wire-radius(as=texcoords)", testing::scene_of_three()).scene);
  std::uint32_t length = 0;
  std::memcpy(&length, glb.data() + 12, 4);
  const std::vector<std::byte> bin(glb.begin() + 20 + length + 8, glb.end());
  for (const auto& [value, why] : {std::pair<GltfJson, const char*>{1, "lacks one of their streams"},
                                   {4000000000u, "no set's number"},
                                   {"x", "no set's number"},
                                   {-1, "no set's number"}}) {
    GltfJson json = testing::json_of(glb);
    json["meshes"][0]["primitives"][0]["extensions"]["FOREDRAW_wires"]["texcoords"] = value;
    Diagnostics diagnostics;
    const auto scene = testing::read_with_wires(testing::glb_of(json.dump(), bin), diagnostics);
    ASSERT_TRUE(scene) << to_text(diagnostics);
    EXPECT_THAT(to_text(diagnostics), HasSubstr(why)) << value;
    EXPECT_FALSE(scene->products.has(Wires::product));
  }
}
}  // namespace
}  // namespace foredraw::wire_radius_damage_test

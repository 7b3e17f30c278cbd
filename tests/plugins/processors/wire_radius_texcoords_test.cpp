// Wires in texture coordinates, for importers that know no other attributes.
#include "support/wire_scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace foredraw::wire_radius_texcoords_test {
namespace {

using testing::GltfJson;
using testing::with_wires;

/// For importers that know no other attributes: the same numbers, in the next free sets of texture coordinates.
TEST(WireRadiusFiles, GoIntoTextureCoordinates) {
  testing::GltfBuilder builder = testing::mixed({"flat rope", "lamp post", "egg"});
  const std::size_t count = testing::scene_of_file(builder).draws[0].full().vertices->count;
  builder.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] =
      builder.add_values(std::vector<float>(2 * count, 0.5f), "VEC2");
  const Scene before = testing::scene_of_file(builder);
  const Result result = testing::run("wire-radius(as=texcoords)", before);
  const Scene& found = result.scene;
  const Wires* wires = found.products.find<Wires>();
  ASSERT_NE(wires, nullptr);
  EXPECT_EQ(wires->draws[0].texcoords, 1u);
  const auto says = [](const NoteRecord& note) { return note.message == "its wires are in TEXCOORD_1 to TEXCOORD_4"; };
  EXPECT_TRUE(std::ranges::any_of(result.report.stages[0].notes, says));
  const Scene usual = testing::run("wire-radius", before).scene;
  const auto as_usual = decoded_wires(*usual.draws[0].full().vertices, std::nullopt);
  const auto is = decoded_wires(*found.draws[0].full().vertices, 1);
  ASSERT_TRUE(as_usual && is);
  EXPECT_EQ(is->wires, as_usual->wires);
  EXPECT_EQ(is->axes, as_usual->axes);

  const GltfJson json = testing::json_of(testing::written_with_wires(found));
  const GltfJson& primitive = json["meshes"][0]["primitives"][0];
  EXPECT_EQ(primitive["attributes"].size(), 6u);
  EXPECT_FALSE(primitive["attributes"].contains("_FOREDRAW_WIRE"));
  for (const char* set : {"TEXCOORD_1", "TEXCOORD_2", "TEXCOORD_3", "TEXCOORD_4"}) {
    const GltfJson& accessor = json["accessors"][primitive["attributes"][set].get<std::size_t>()];
    EXPECT_EQ(accessor["type"], "VEC2");
    EXPECT_EQ(accessor["componentType"], 5126);
  }
  EXPECT_EQ(primitive["extensions"]["FOREDRAW_wires"]["texcoords"], 1);

  // Later stages and files keep them; found again they are in the same sets, or back in attributes.
  Diagnostics diagnostics;
  const auto again = testing::read_with_wires(
      testing::written_with_wires(testing::run("weld, tipsify, vertex-fetch", found).scene), diagnostics);
  ASSERT_TRUE(again);
  EXPECT_TRUE(diagnostics.empty()) << to_text(diagnostics);
  EXPECT_EQ(*again->products.find<Wires>(), *wires);
  EXPECT_EQ(testing::run("wire-radius(as=texcoords)", *again).scene.products.find<Wires>()->draws[0].texcoords, 1u);
  const Scene back = testing::run("wire-radius", *again).scene;
  EXPECT_EQ(back.draws[0].full().vertices->find("TEXCOORD_1"), nullptr);
  EXPECT_NE(back.draws[0].full().vertices->find(wire_semantic), nullptr);

  // What leaves them out takes the sets away, and no other.
  const Scene out = testing::run("quadric-collapse, simplify(ratio=0.5)", found).scene;
  EXPECT_FALSE(out.products.has(Wires::product));
  EXPECT_EQ(out.draws[0].full().vertices->find("TEXCOORD_4"), nullptr);
  EXPECT_NE(out.draws[0].full().vertices->find("TEXCOORD_0"), nullptr);
}
}  // namespace
}  // namespace foredraw::wire_radius_texcoords_test

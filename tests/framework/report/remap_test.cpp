#include <foredraw/report/remap.h>

#include "support/meshes.h"

#include <foredraw/scene/reorder.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace foredraw::remap_test {
namespace {

using nlohmann::json;
using Numbers = std::vector<std::uint32_t>;

Draw two_triangles(DrawOrigin origin) {
  Draw draw = testing::draw_of({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {0, 1, 2, 2, 1, 0}}, "Rock");
  draw.origin = origin;
  return draw;
}

TEST(RemapJson, SaysWhereEachTriangleWasAndEachVertexIs) {
  Draw draw = with_triangle_order(two_triangles({3, 1}), Numbers{1, 0});
  const Numbers destination = {2, 0, 1, no_vertex};
  const auto moved =
      std::make_shared<const VertexStreams>(with_vertices_moved(*draw.levels[0].vertices, destination, 3));
  draw = with_vertices_moved(draw, 0, moved, destination);
  const json remap = json::parse(remap_json(testing::scene_of({draw})));
  EXPECT_EQ(remap["remap"], 1);
  EXPECT_EQ(remap["file"], "test scene");
  ASSERT_EQ(remap["draws"].size(), 1u);
  EXPECT_EQ(remap["draws"][0], json::parse(R"({
    "name": "Rock", "mesh": 3, "primitive": 1,
    "triangles": {"new-to-old": [1, 0]},
    "vertices": {"old-to-new": [2, 0, 1, null]}})"));
}

TEST(RemapJson, NullWhereNothingMoved) {
  const json remap = json::parse(remap_json(testing::scene_of({two_triangles({0, 0})})));
  EXPECT_TRUE(remap["draws"][0]["triangles"].is_null());
  EXPECT_TRUE(remap["draws"][0]["vertices"].is_null());
}

TEST(RemapJson, LeavesOutWhatNoFileHeld) {
  Draw made = two_triangles({0, 0});
  made.origin.reset();
  const json remap = json::parse(remap_json(testing::scene_of({made, two_triangles({0, 1})})));
  ASSERT_EQ(remap["draws"].size(), 1u);
  EXPECT_EQ(remap["draws"][0]["primitive"], 1);
  EXPECT_EQ(json::parse(remap_json({}))["draws"], json::array());
}

TEST(RemapJson, TellsOfEachLevel) {
  Draw draw = two_triangles({3, 1});
  draw.levels.push_back(two_triangles({}).full());
  draw.levels.push_back(with_triangle_order(two_triangles({}), Numbers{1, 0}).full());
  draw.levels[2].origin = DrawOrigin{4, 0};
  const json levels = json::parse(remap_json(testing::scene_of({draw})))["draws"][0]["levels"];
  EXPECT_EQ(levels, json::parse(R"([
    {"triangles": null, "vertices": null},
    {"mesh": 4, "primitive": 0, "triangles": {"new-to-old": [1, 0]}, "vertices": null}])"));
}

TEST(RemapJson, NamesThatAreNoUtf8StillMakeJson) {
  Draw draw = two_triangles({0, 0});
  draw.name = "Rock\xff";
  EXPECT_NO_THROW(json::parse(remap_json(testing::scene_of({draw}))));
}

}  // namespace
}  // namespace foredraw::remap_test

#include <foredraw/report/inspection.h>

#include "support/meshes.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace foredraw {
namespace {

TEST(Inspection, TellsOfOrdersAndTheirTables) {
  Scene scene = testing::scene_of({testing::draw_of(testing::grid(2, 1), "body"), testing::draw_of(testing::grid(1, 1), "rock")});
  scene.draws[0].levels[0].orders.push_back(scene.draws[0].levels[0].orders[0]);
  scene.order_tables = {{{0}, {{"Walk", {0, 1, 2}}, {"Run", {0}}}, 2, 3, std::vector<std::uint8_t>(24, 1)}};
  Analyses analyses;
  const std::string text = inspection_text(scene, analyses);
  EXPECT_NE(text.find("body: 2 x 3 directions, 4 keyframes of 2 clips; 2 orders of 4 triangles: 48 bytes; one for each "
                      "of 4 keyframes would take 96 bytes\n"),
            std::string::npos)
      << text;
  const auto json = nlohmann::json::parse(inspection_json(scene, analyses));
  EXPECT_EQ(json["draws"][0]["orders"], 2);
  EXPECT_EQ(json["draws"][1]["orders"], 1);
  ASSERT_EQ(json["order-tables"].size(), 1u);
  EXPECT_EQ(json["order-tables"][0]["draws"], nlohmann::json::array({"body"}));
  EXPECT_EQ(json["order-tables"][0]["orders"], 2);
  EXPECT_EQ(json["order-tables"][0]["clips"][0], (nlohmann::json{{"name", "Walk"}, {"keyframes", 3}}));
  EXPECT_EQ(json["order-tables"][0]["bytes-for-each-keyframe"], 96);
  scene.order_tables.clear();
  EXPECT_EQ(inspection_text(scene, analyses).find("orders ("), std::string::npos);
}

TEST(Inspection, TellsOfLevels) {
  Scene scene = testing::scene_of({testing::draw_of(testing::grid(2, 1), "body"), testing::draw_of(testing::grid(1, 1), "rock")});
  Level same = scene.draws[0].full();
  same.stream().indices = Shared<std::uint32_t>(std::vector<std::uint32_t>{0, 2, 3});
  same.error = 0.25f;
  scene.draws[0].levels.push_back(same);
  scene.draws[0].levels.push_back(scene.draws[1].full());
  Analyses analyses;
  const std::string text = inspection_text(scene, analyses);
  EXPECT_NE(text.find("  body (level 1): 1 triangles, vertices of full detail; error 0.25\n"
                      "  body (level 2): 2 triangles, 4 vertices; error 0\n"),
            std::string::npos)
      << text;
  const auto json = nlohmann::json::parse(inspection_json(scene, analyses));
  ASSERT_EQ(json["draws"][0]["levels"].size(), 2u);
  EXPECT_EQ(json["draws"][0]["levels"][0], (nlohmann::json{{"elements", 1}, {"vertices", 6}, {"shares-vertices", true}, {"error", 0.25}}));
  EXPECT_FALSE(json["draws"][1].contains("levels"));
}

TEST(Inspection, TellsOfMergedDraws) {
  Scene scene = testing::scene_of({testing::draw_of(testing::grid(2, 1), "tree"), testing::draw_of(testing::grid(1, 1), "rock")});
  MergedInstances merged;
  merged.meshes = {{0, 0}, {1, 6}};
  merged.places = Shared<MergedPlace>({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
  merged.groups.resize(2);
  merged.draws = {{0, 12, 0, 2}, {1, 12, 2, 1}, {1, 6, 3, 4}};
  scene.merged = {merged};
  Analyses analyses;
  const std::string text = inspection_text(scene, analyses);
  EXPECT_NE(text.find("no material: 3 instances of 2 draws in 2 groups, drawn by 3 calls; 4 slots of 6 index entries, "
                      "3 slots of 12 index entries\n"),
            std::string::npos)
      << text;
  const auto json = nlohmann::json::parse(inspection_json(scene, analyses));
  ASSERT_EQ(json["merged"].size(), 1u);
  EXPECT_EQ(json["merged"][0]["draws"], nlohmann::json::array({"tree", "rock"}));
  EXPECT_EQ(json["merged"][0]["instances"], 3);
  EXPECT_EQ(json["merged"][0]["slots"][1], (nlohmann::json{{"frequency", 12}, {"slots", 3}}));
}

}  // namespace
}  // namespace foredraw

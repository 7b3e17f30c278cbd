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

}  // namespace
}  // namespace foredraw

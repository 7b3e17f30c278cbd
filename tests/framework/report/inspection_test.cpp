#include <foredraw/report/inspection.h>

#include "support/meshes.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace foredraw::inspection_test {
namespace {

TEST(Inspection, TellsOfLevels) {
  Scene scene =
      testing::scene_of({testing::draw_of(testing::grid(2, 1), "body"), testing::draw_of(testing::grid(1, 1), "rock")});
  Level same = scene.draws[0].full();
  same.stream().indices = Shared<std::uint32_t>(std::vector<std::uint32_t>{0, 2, 3});
  same.error = 0.25f;
  scene.draws[0].levels.push_back(same);
  scene.draws[0].levels.push_back(scene.draws[1].full());
  Analyses analyses;
  const std::string text = inspection_text(scene, {}, analyses, Executor(1));
  EXPECT_NE(text.find("  body (level 1): 1 triangle, vertices of full detail; error 0.25\n"
                      "  body (level 2): 2 triangles, 4 vertices; error 0\n"),
            std::string::npos)
      << text;
  const auto json = nlohmann::json::parse(inspection_json(scene, {}, {}, analyses, Executor(1)));
  ASSERT_EQ(json["draws"][0]["levels"].size(), 2u);
  EXPECT_EQ(json["draws"][0]["levels"][0],
            (nlohmann::json{{"elements", 1}, {"vertices", 6}, {"shares-vertices", true}, {"error", 0.25}}));
  EXPECT_FALSE(json["draws"][1].contains("levels"));
}

TEST(Inspection, OneThingIsSingular) {
  Analyses analyses;
  const std::string text = inspection_text(testing::scene_of(testing::grid(1, 1)), {}, analyses, Executor(1));
  EXPECT_NE(text.find(": 1 draw in 1 mesh on 1 node, 1 vertex stream, 0 materials"), std::string::npos) << text;
  EXPECT_NE(text.find(": 1 draw\n"), std::string::npos) << text;
}

}  // namespace
}  // namespace foredraw::inspection_test

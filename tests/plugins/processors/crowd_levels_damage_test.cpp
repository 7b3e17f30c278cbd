// FOREDRAW_crowd_levels that is wrong: it costs itself alone.

#include "support/crowd_levels.h"

#include <gtest/gtest.h>

#include <functional>

namespace foredraw::crowd_levels_damage_test {
namespace {

using testing::GltfJson;

constexpr const char* extension = "FOREDRAW_crowd_levels";

struct Wrong {
  const char* name;
  std::function<void(GltfJson& file, GltfJson& ball)> make;
  const char* why;  ///< a part of the warning
};

void PrintTo(const Wrong& wrong, std::ostream* out) { *out << wrong.name; }

class WrongCrowdLevels : public ::testing::TestWithParam<Wrong> {};

/// The file is read without it, a warning says so and why, and it is not written again.
TEST_P(WrongCrowdLevels, AreLeftOutWithAWarning) {
  const std::vector<std::byte> glb = testing::written_crowd(testing::with_crowd_levels());
  std::uint32_t json_length = 0;
  std::memcpy(&json_length, glb.data() + 12, 4);
  GltfJson json = testing::json_of(glb);
  GetParam().make(json["extensions"][extension], json["meshes"][0]["primitives"][0]["extensions"][extension]);
  Diagnostics diagnostics;
  const auto scene = read_gltf(testing::glb_of(json.dump(), {glb.begin() + 20 + json_length + 8, glb.end()}), "test",
                               {}, diagnostics, {.products = {crowd_levels_product()}});
  ASSERT_TRUE(scene) << to_text(diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 1u) << to_text(diagnostics);
  EXPECT_EQ(diagnostics.all()[0].code, "crowd-levels-left-out");
  EXPECT_NE(diagnostics.all()[0].message.find(GetParam().why), std::string::npos) << diagnostics.all()[0].message;
  EXPECT_FALSE(scene->products.has(CrowdLevels::product));
  EXPECT_EQ(testing::json_of(testing::written_crowd(*scene)).dump().find(extension), std::string::npos);
}

constexpr std::int64_t two_to_32 = std::int64_t{1} << 32;

INSTANTIATE_TEST_SUITE_P(
    CrowdLevels, WrongCrowdLevels,
    ::testing::Values(
        Wrong{"nothing", [](GltfJson& file, GltfJson&) { file = GltfJson::object(); }, "has no 'characters'"},
        Wrong{"text", [](GltfJson& file, GltfJson&) { file = "many"; }, "has no 'characters'"},
        Wrong{"no_characters", [](GltfJson& file, GltfJson&) { file["characters"] = 0; }, "from 1 to 1000000"},
        Wrong{"many_characters", [](GltfJson& file, GltfJson&) { file["characters"] = two_to_32; }, "'characters'"},
        Wrong{"spacing", [](GltfJson& file, GltfJson&) { file["spacing"] = "even"; }, "'spacing'"},
        Wrong{"spacing_number", [](GltfJson& file, GltfJson&) { file["spacing"] = 1; }, "'spacing'"},
        Wrong{"row_is_text", [](GltfJson&, GltfJson& ball) { ball = "row"; }, "has no 'crowd'"},
        Wrong{"crowd", [](GltfJson&, GltfJson& ball) { ball["crowd"] = -1; }, "'crowd'"},
        Wrong{"area", [](GltfJson&, GltfJson& ball) { ball["area"] = 1e300; }, "'area'"},
        Wrong{"area_null", [](GltfJson&, GltfJson& ball) { ball["area"] = nullptr; }, "'area'"},
        Wrong{"no_levels", [](GltfJson&, GltfJson& ball) { ball["levels"] = GltfJson::array(); }, "array of 1 to 128"},
        Wrong{"levels_no_array", [](GltfJson&, GltfJson& ball) { ball["levels"] = 3; }, "array of 1 to 128"},
        Wrong{"many_levels",
              [](GltfJson&, GltfJson& ball) {
                const GltfJson one = ball["levels"][0];
                for (int i = 0; i < 100'000; ++i) ball["levels"].push_back(one);
              },
              "array of 1 to 128"},
        Wrong{"class", [](GltfJson&, GltfJson& ball) { ball["levels"][0]["class"] = "red"; }, "'class'"},
        Wrong{"number", [](GltfJson&, GltfJson& ball) { ball["levels"][0]["number"] = 1; }, "from 0 to 0"},
        Wrong{"number_0", [](GltfJson&, GltfJson& ball) { ball["levels"][1]["number"] = 0; }, "from 1 to"},
        Wrong{"numbers_swapped", [](GltfJson&, GltfJson& ball) { std::swap(ball["levels"][1], ball["levels"][2]); },
              "not 1, 2, ... in turn"},
        Wrong{"no_plain", [](GltfJson&, GltfJson& ball) { ball["levels"].erase(0); }, "no plain level"},
        Wrong{"tessellated_last",
              [](GltfJson&, GltfJson& ball) {
                ball["levels"][2]["class"] = "tessellated";
              },
              "not 1, 2, ... in turn"},
        Wrong{"parts_rise",
              [](GltfJson&, GltfJson& ball) {
                for (const int i : {0, 1}) ball["levels"][i]["class"] = "tessellated", ball["levels"][i]["number"] = 3 + i;
                ball["levels"][2]["class"] = "plain", ball["levels"][2]["number"] = 0;
              },
              "do not fall"},
        Wrong{"parts_65",
              [](GltfJson&, GltfJson& ball) {
                ball["levels"][0]["class"] = "tessellated", ball["levels"][0]["number"] = 65;
              },
              "from 1 to 64"},
        Wrong{"parts_of_other_spacing",
              [](GltfJson& file, GltfJson& ball) {
                file["spacing"] = "fractional-even";
                ball["levels"][0]["class"] = "tessellated", ball["levels"][0]["number"] = 3;
              },
              "which its spacing does not allow"},
        Wrong{"tessellated_where_nothing_moves",
              [](GltfJson&, GltfJson& ball) {
                GltfJson finer = ball["levels"][0];
                finer["class"] = "tessellated", finer["number"] = 2;
                finer["triangles"] = 6 * finer["triangles"].get<int>();
                ball["levels"].insert(ball["levels"].begin(), finer);
              },
              "triangles tessellated 2"},
        Wrong{"triangles_2_to_32", [](GltfJson&, GltfJson& ball) { ball["levels"][0]["triangles"] = two_to_32; },
              "'triangles'"},
        Wrong{"triangles_uncountable", [](GltfJson&, GltfJson& ball) { ball["levels"][0]["triangles"] = 4294967295u; },
              "than 32 bits count"},
        Wrong{"triangles_other", [](GltfJson&, GltfJson& ball) { ball["levels"][0]["triangles"] = 5; }, "not 5"},
        Wrong{"vertices_other", [](GltfJson&, GltfJson& ball) { ball["levels"][1]["vertices"] = 0; }, "not 0"},
        Wrong{"rms_negative", [](GltfJson&, GltfJson& ball) { ball["levels"][1]["rms"] = -0.5; }, "'rms'"},
        Wrong{"rms_above_largest", [](GltfJson&, GltfJson& ball) { ball["levels"][1]["rms"] = 7; }, "above its"},
        Wrong{"largest_text", [](GltfJson&, GltfJson& ball) { ball["levels"][1]["largest"] = "NaN"; }, "'largest'"},
        Wrong{"a_level_less", [](GltfJson&, GltfJson& ball) { ball["levels"].erase(2); }, "is drawn with levels: 3, not 2"}),
    [](const auto& info) { return std::string(info.param.name); });

/// Two primitives say that they are drawn together, and have other levels.
TEST(CrowdLevels, WithOtherRowsInOneCrowdAreLeftOut) {
  Scene scene = testing::crowd_of_balls();
  scene.draws[1] = scene.draws[0];
  const std::vector<std::byte> glb = testing::written_crowd(testing::run("crowd-levels", scene).scene);
  std::uint32_t json_length = 0;
  std::memcpy(&json_length, glb.data() + 12, 4);
  GltfJson json = testing::json_of(glb);
  GltfJson& other = json["meshes"][1]["primitives"][0]["extensions"][extension];
  other["crowd"] = 0;
  other["levels"].erase(2);
  Diagnostics diagnostics;
  const auto read = read_gltf(testing::glb_of(json.dump(), {glb.begin() + 20 + json_length + 8, glb.end()}), "test", {},
                              diagnostics, {.products = {crowd_levels_product()}});
  ASSERT_TRUE(read);
  ASSERT_EQ(diagnostics.all().size(), 1u) << to_text(diagnostics);
  EXPECT_NE(diagnostics.all()[0].message.find("other levels on plate than on ball"), std::string::npos)
      << diagnostics.all()[0].message;
}

}  // namespace
}  // namespace foredraw::crowd_levels_damage_test

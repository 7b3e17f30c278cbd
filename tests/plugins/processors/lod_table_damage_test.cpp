// FOREDRAW_lod_table that is wrong: it costs itself alone.

#include "support/lod_tables.h"

#include <gtest/gtest.h>

#include <functional>

namespace foredraw::lod_table_damage_test {
namespace {

using testing::GltfJson;

constexpr const char* extension = "FOREDRAW_lod_table";

struct Wrong {
  const char* name;
  std::function<void(GltfJson& file, GltfJson& ball)> make;
  const char* why;  ///< a part of the warning
};

void PrintTo(const Wrong& wrong, std::ostream* out) { *out << wrong.name; }

/// The file as JSON with its buffer as it is; each test breaks a copy.
struct File {
  GltfJson json;
  std::vector<std::byte> bin;
};

File table_file() {
  const std::vector<std::byte> glb = testing::written_with_table(testing::with_table());
  std::uint32_t json_length = 0;
  std::memcpy(&json_length, glb.data() + 12, 4);
  return {testing::json_of(glb), {glb.begin() + 20 + json_length + 8, glb.end()}};
}

GltfJson& ball_of(GltfJson& json) { return json["meshes"][0]["primitives"][0]["extensions"][extension]; }

class WrongLodTable : public ::testing::TestWithParam<Wrong> {};

/// The file is read without it, a warning says so and why, and it is not written again.
TEST_P(WrongLodTable, IsLeftOutWithAWarning) {
  File file = table_file();
  GetParam().make(file.json["extensions"][extension], ball_of(file.json));
  Diagnostics diagnostics;
  const auto scene = read_gltf(testing::glb_of(file.json.dump(), file.bin), "test", {}, diagnostics,
                               {.products = {lod_table_product()}});
  ASSERT_TRUE(scene) << to_text(diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 1u) << to_text(diagnostics);
  EXPECT_EQ(diagnostics.all()[0].code, "lod-table-left-out");
  EXPECT_NE(diagnostics.all()[0].message.find(GetParam().why), std::string::npos) << diagnostics.all()[0].message;
  EXPECT_FALSE(scene->products.has(LodTable::product));
  EXPECT_EQ(scene->draws[0].levels.size(), 3u);
  EXPECT_EQ(testing::json_of(testing::written_with_table(*scene)).dump().find(extension), std::string::npos);
}

constexpr std::int64_t two_to_32 = std::int64_t{1} << 32;

INSTANTIATE_TEST_SUITE_P(
    LodTable, WrongLodTable,
    ::testing::Values(
        Wrong{"nothing", [](GltfJson& file, GltfJson&) { file = GltfJson::object(); }, "has no 'machine'"},
        Wrong{"text", [](GltfJson& file, GltfJson&) { file = "costs"; }, "has no 'machine'"},
        Wrong{"long_name", [](GltfJson& file, GltfJson&) { file["machine"] = std::string(1000, 'x'); }, "'machine'"},
        Wrong{"stages", [](GltfJson& file, GltfJson&) { file["stages"] = "min"; }, "'stages'"},
        Wrong{"negative_cost", [](GltfJson& file, GltfJson&) { file["renderings"][1]["pixel"] = -1; }, "'pixel'"},
        Wrong{"huge_cost", [](GltfJson& file, GltfJson&) { file["frame"] = 1e300; }, "'frame'"},
        Wrong{"no_number", [](GltfJson& file, GltfJson&) { file["draw"] = "NaN"; }, "'draw'"},
        Wrong{"null_for_nan", [](GltfJson& file, GltfJson&) { file["draw"] = nullptr; }, "'draw'"},
        Wrong{"two_renderings", [](GltfJson& file, GltfJson&) { file["renderings"].erase(2); }, "array of 3"},
        Wrong{"swapped", [](GltfJson& file, GltfJson&) { std::swap(file["renderings"][0], file["renderings"][1]); },
              "are not full, without-normal-map and unlit"},
        Wrong{"row_is_text", [](GltfJson&, GltfJson& ball) { ball = "row"; }, "has no 'radius'"},
        Wrong{"radius_zero", [](GltfJson&, GltfJson& ball) { ball["radius"] = 0; }, "'radius' of 0"},
        Wrong{"radius_tiny", [](GltfJson&, GltfJson& ball) { ball["radius"] = 1e-300; }, "'radius' of 0"},
        Wrong{"radius_huge", [](GltfJson&, GltfJson& ball) { ball["radius"] = 1e300; }, "'radius'"},
        Wrong{"coverage", [](GltfJson&, GltfJson& ball) { ball["coverage"] = 1.5; }, "'coverage'"},
        Wrong{"importance", [](GltfJson&, GltfJson& ball) { ball["importance"] = -0.5; }, "'importance'"},
        Wrong{"accuracy_above_1", [](GltfJson&, GltfJson& ball) { ball["accuracy"][1] = 2; }, "'accuracy'"},
        Wrong{"accuracy_short", [](GltfJson&, GltfJson& ball) { ball["accuracy"].erase(0); }, "array of 3"},
        Wrong{"no_levels", [](GltfJson&, GltfJson& ball) { ball["levels"] = GltfJson::array(); }, "array of 1 to 32"},
        Wrong{"levels_no_array", [](GltfJson&, GltfJson& ball) { ball["levels"] = two_to_32; }, "array of 1 to 32"},
        Wrong{"many_levels",
              [](GltfJson&, GltfJson& ball) {
                const GltfJson one = ball["levels"][0];
                for (int i = 0; i < 100'000; ++i) ball["levels"].push_back(one);
              },
              "array of 1 to 32"},
        Wrong{"level_too_many", [](GltfJson&, GltfJson& ball) { ball["levels"].push_back(ball["levels"][2]); },
              "has levels: 3, not 4"},
        Wrong{"level_missing",
              [](GltfJson&, GltfJson& ball) {
                ball["levels"].erase(2);
                for (auto& masks : ball["hulls"]) masks = GltfJson::array({1, 1, 1});
              },
              "has levels: 3, not 2"},
        Wrong{"triangles_2_to_32", [](GltfJson&, GltfJson& ball) { ball["levels"][0]["triangles"] = two_to_32; },
              "below 2^32"},
        Wrong{"triangles_other", [](GltfJson&, GltfJson& ball) { ball["levels"][0]["triangles"] = 4294967295u; },
              "triangles, not 4294967295"},
        Wrong{"vertices_other", [](GltfJson&, GltfJson& ball) { ball["levels"][1]["vertices"] = 0; }, "vertices, not 0"},
        Wrong{"vertices_negative", [](GltfJson&, GltfJson& ball) { ball["levels"][1]["vertices"] = -1; }, "below 2^32"},
        Wrong{"shaded_other", [](GltfJson&, GltfJson& ball) { ball["levels"][2]["shaded"] = 4294967295u; }, "shades"},
        Wrong{"error_negative", [](GltfJson&, GltfJson& ball) { ball["levels"][1]["error"] = -0.5; }, "'error'"},
        Wrong{"error_other", [](GltfJson&, GltfJson& ball) { ball["levels"][1]["error"] = 0.5; }, "an error of"},
        Wrong{"hulls_short", [](GltfJson&, GltfJson& ball) { ball["hulls"].erase(0); }, "array of 10"},
        Wrong{"masks_short", [](GltfJson&, GltfJson& ball) { ball["hulls"][4].erase(0); }, "array of 3"},
        Wrong{"mask_beyond_levels", [](GltfJson&, GltfJson& ball) { ball["hulls"][4][0] = 8; }, "does not have"},
        Wrong{"mask_2_to_32", [](GltfJson&, GltfJson& ball) { ball["hulls"][4][0] = two_to_32; }, "below 2^32"},
        Wrong{"mask_other",
              [](GltfJson&, GltfJson& ball) { ball["hulls"][9][0] = ball["hulls"][9][0].get<int>() ^ 1; },
              "other ways on its hulls"}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(LodTable, WithoutARowOrWithoutCostsIsLeftOut) {
  for (const bool costs : {false, true}) {
    File file = table_file();
    if (costs) file.json["extensions"].erase(extension);
    if (!costs) {
      for (auto& mesh : file.json["meshes"]) mesh["primitives"][0]["extensions"].erase(extension);
    }
    Diagnostics diagnostics;
    const auto scene = read_gltf(testing::glb_of(file.json.dump(), file.bin), "test", {}, diagnostics,
                                 {.products = {lod_table_product()}});
    ASSERT_TRUE(scene) << to_text(diagnostics);
    EXPECT_FALSE(scene->products.has(LodTable::product));
    EXPECT_EQ(diagnostics.all().size(), 1u) << to_text(diagnostics);
  }
}

}  // namespace
}  // namespace foredraw::lod_table_damage_test

// What of a table stands in files: the scene's, a C header, JSON, and what `inspect` shows.

#include "support/edit_product.h"
#include "support/lod_tables.h"
#include "support/program.h"

#include <foredraw/io/side_files.h>
#include <foredraw/report/inspection.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace foredraw::lod_table_files_test {
namespace {

using ::testing::HasSubstr;
using testing::table_of;
using testing::with_table;

class LodTableFiles : public testing::InFolder {};

TEST(LodTable, ComesBackFromAFile) {
  const Scene scene = with_table();
  Diagnostics diagnostics;
  const auto again =
      read_gltf(testing::written_with_table(scene), "again", {}, diagnostics, {.products = {lod_table_product()}});
  ASSERT_TRUE(again);
  EXPECT_TRUE(diagnostics.empty()) << to_text(diagnostics);
  EXPECT_EQ(table_of(*again), table_of(scene));
  EXPECT_EQ(testing::written_with_table(*again), testing::written_with_table(scene));
}

TEST(LodTable, IsInspected) {
  const Scene scene = with_table();
  Analyses analyses;
  const ProductRows rows{lod_table_product()};
  const std::string text = inspection_text(scene, rows, analyses, Executor(1));
  EXPECT_THAT(text, HasSubstr("table of levels and renderings (costs of built-in example, no real machine):\n"));
  EXPECT_THAT(text, HasSubstr("  ball: levels 3, ways 9, of which "));
  const auto json = nlohmann::json::parse(inspection_json(scene, rows, {}, analyses, Executor(1)));
  EXPECT_EQ(json["products"]["lod-table"]["draws"][1]["ways"], 3);
}

/// Compiled as C99 and as C++, the arrays give each way the cost and benefit that the framework gives it.
TEST_F(LodTableFiles, TheHeaderIsCAndHoldsTheTable) {
  Scene scene = with_table("(importance=0.5)");
  scene.draws[0].name = "a \"ball\"?\?/ \n*/ \xc3\xa9";
  scene.name = "x*/ y?\?/.glb";
  testing::edit<LodTable>(scene)->costs.machine = "two */ \n lines";
  Diagnostics diagnostics;
  const auto files = encode_side_file(scene, *lod_table_product(), folder_ / "2 rocks.h", diagnostics);
  ASSERT_TRUE(files) << to_text(diagnostics);
  testing::put(folder_ / "rocks.h",
               std::string(reinterpret_cast<const char*>(files->front().bytes.data()), files->front().bytes.size()));
  testing::put(folder_ / "use.c", R"(#include "rocks.h"
#include "rocks.h"
#include <stdio.h>
int main(void) {
  unsigned d, l, r;
  for (d = 0; d < T2_ROCKS_LOD_DRAW_COUNT; ++d)
    for (l = 0; l < t2_rocks_lod_draws[d].levels; ++l)
      for (r = 0; r < FOREDRAW_LOD_RENDERINGS; ++r) {
        const foredraw_lod_way way = foredraw_lod_table_way(&t2_rocks_lod_machine, &t2_rocks_lod_draws[d], l, r, 100, 1);
        printf("%s %u %u %u %u %u\n", t2_rocks_lod_draws[d].name, l, r, (unsigned)way.cost, (unsigned)way.benefit,
               (unsigned)t2_rocks_lod_draws[d].hulls[4][r]);
      }
  return 0;
}
)");
  std::filesystem::copy_file(folder_ / "use.c", folder_ / "use.cpp");
  std::string expected;
  const LodTable& table = table_of(scene);
  const foredraw_lod_machine machine = lod_machine(table.costs);
  for (const LodTable::OfDraw& draw : table.draws) {
    foredraw_lod_table_draw row = {};
    std::vector<foredraw_lod_table_level> levels;
    for (const auto& level : draw.levels)
      levels.push_back({level.triangles, level.shaded, level.vertices, level.error});
    row.level = levels.data();
    row.radius = draw.radius, row.coverage = draw.coverage, row.importance = 0.5f;
    std::ranges::copy(draw.accuracy, row.accuracy);
    for (std::uint32_t l = 0; l < draw.levels.size(); ++l) {
      for (std::uint32_t r = 0; r < 3; ++r) {
        const foredraw_lod_way way = foredraw_lod_table_way(&machine, &row, l, r, 100, 1);
        expected += scene.draws[draw.draw].name;
        for (const std::uint32_t n : {l, r, way.cost, way.benefit, draw.hulls[4][r]})
          expected += ' ' + std::to_string(n);
        expected += '\n';
      }
    }
  }
  const std::string in = "cd '" + folder_.string() + "' && ";
  const std::string flags = " -Wall -Wextra -Werror -pedantic -I'" FOREDRAW_SOURCE_DIR "/framework' ";
  for (const std::string& compile : {"cc -std=c99" + flags + "use.c", "c++ -std=c++11" + flags + "use.cpp"}) {
    ASSERT_EQ(std::system((in + compile + " -o use -lm && ./use > said").c_str()), 0) << compile;
    EXPECT_EQ(testing::content(folder_ / "said"), expected) << compile;
  }
}

TEST_F(LodTableFiles, TheJsonHasAnObjectForEachWay) {
  const Scene scene = with_table();
  Diagnostics diagnostics;
  const auto files = encode_side_file(scene, *lod_table_product(), folder_ / "t.json", diagnostics);
  ASSERT_TRUE(files);
  const auto json = nlohmann::json::parse(files->front().bytes);
  const LodTable::OfDraw& ball = table_of(scene).draws[0];
  EXPECT_EQ(json["draws"].size(), 2u);
  ASSERT_EQ(json["draws"][0]["ways"].size(), 9u);
  const auto& way = json["draws"][0]["ways"][5];
  EXPECT_EQ(way["level"], 1);
  EXPECT_EQ(way["rendering"], "unlit");
  EXPECT_EQ(way["triangles"], ball.levels[1].triangles);
  EXPECT_EQ(way["samples"], ball.levels[1].triangles);
  EXPECT_EQ(json["draws"][0]["ways"][4]["samples"], ball.levels[1].vertices);
  EXPECT_EQ(way["accuracy"].get<float>(), ball.accuracy[2]);
  EXPECT_EQ(way["on-hull"].size(), 10u);
  for (std::size_t octave = 0; octave < 10; ++octave) {
    EXPECT_EQ(way["on-hull"][octave].get<bool>(), (ball.hulls[octave][2] & 2u) != 0);
  }
  EXPECT_EQ(json["renderings"]["full"]["pixel"], 1.0);
}

}  // namespace
}  // namespace foredraw::lod_table_files_test

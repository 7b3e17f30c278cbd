// What of a crowd's levels stands in files: the scene's, a C header, JSON, and what `inspect` shows.

#include "support/crowd_levels.h"
#include "support/program.h"

#include <foredraw/io/side_files.h>
#include <foredraw/report/inspection.h>
#include <foredraw/runtime/crowd_select.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace foredraw::crowd_levels_files_test {
namespace {

using testing::crowd_levels_of;
using ::testing::HasSubstr;
using testing::with_crowd_levels;

class CrowdLevelsFiles : public testing::InFolder {};

TEST(CrowdLevels, ComeBackFromAFile) {
  const Scene scene = with_crowd_levels("(characters=3, spacing=\"fractional-odd\")");
  Diagnostics diagnostics;
  const auto again =
      read_gltf(testing::written_crowd(scene), "again", {}, diagnostics, {.products = {crowd_levels_product()}});
  ASSERT_TRUE(again);
  EXPECT_TRUE(diagnostics.empty()) << to_text(diagnostics);
  EXPECT_EQ(crowd_levels_of(*again), crowd_levels_of(scene));
  EXPECT_EQ(testing::written_crowd(*again), testing::written_crowd(scene));
}

TEST(CrowdLevels, AreInspected) {
  const Scene scene = with_crowd_levels();
  Analyses analyses;
  const ProductRows rows{crowd_levels_product()};
  const std::string text = inspection_text(scene, rows, analyses, Executor(1));
  EXPECT_THAT(text, HasSubstr("levels of a crowd (budgets of 10 characters):\n"));
  EXPECT_THAT(text,
              HasSubstr("  ball: levels 3, of which 0 tessellated and 2 simplified; 3 are worth their triangles; "));
  const auto json = nlohmann::json::parse(inspection_json(scene, rows, {}, analyses, Executor(1)));
  EXPECT_EQ(json["products"]["crowd-levels"]["crowds"][0]["levels"].size(), 3u);
}

/// Compiled as C99 and as C++, the table chooses as one made here does.
TEST_F(CrowdLevelsFiles, TheHeaderIsCAndChooses) {
  Scene scene = with_crowd_levels();
  scene.draws[0].name = "a \"ball\"?\?/ \n*/ \xc3\xa9";
  scene.name = "x*/ y?\?/.glb";
  Diagnostics diagnostics;
  const auto files = encode_side_file(scene, *crowd_levels_product(), folder_ / "2 balls.h", diagnostics);
  ASSERT_TRUE(files) << to_text(diagnostics);
  testing::put(folder_ / "balls.h",
               std::string(reinterpret_cast<const char*>(files->front().bytes.data()), files->front().bytes.size()));
  testing::put(folder_ / "use.c", R"(#include "balls.h"
#include "balls.h"
#include <stdio.h>
#include <stdlib.h>
int main(void) {
  float distances[100];
  unsigned char chosen[100];
  foredraw_crowd_table table;
  foredraw_crowd_result result;
  void* memory;
  unsigned i;
  const foredraw_crowd_character* ball = &t2_balls_crowd[T2_BALLS_CROWD_COUNT - 1];
  if (!foredraw_crowd_prepare(ball->level, ball->levels, &table)) return 1;
  memory = malloc(foredraw_crowd_memory(&table));
  for (i = 0; i < 100; ++i) distances[i] = 1 + (float)(i * 37 % 100);
  result = foredraw_crowd_select(&table, distances, 100, ball->budget, 0, chosen, memory);
  printf("%s %u\n", ball->name, (unsigned)result.triangles);
  for (i = 0; i < 100; ++i) printf("%d %u ", (int)ball->mesh[chosen[i]].kind, (unsigned)ball->mesh[chosen[i]].number);
  free(memory);
  return 0;
}
)");
  std::filesystem::copy_file(folder_ / "use.c", folder_ / "use.cpp");
  const Crowd crowd = crowds_of(crowd_levels_of(scene))[0];
  const std::vector<foredraw_crowd_level> levels = runtime_levels(crowd);
  foredraw_crowd_table table;
  ASSERT_EQ(foredraw_crowd_prepare(levels.data(), 3, &table), 1);
  std::vector<std::uint32_t> memory(foredraw_crowd_memory(&table) / 4);
  std::vector<float> distances;
  for (unsigned i = 0; i < 100; ++i) distances.push_back(1 + static_cast<float>(i * 37 % 100));
  std::vector<std::uint8_t> chosen(100);
  const auto result =
      foredraw_crowd_select(&table, distances.data(), 100, crowd.budget, 0, chosen.data(), memory.data());
  EXPECT_GT(result.triangles * 100, crowd.budget * 80);
  std::string expected = scene.draws[0].name + ' ' + std::to_string(result.triangles) + '\n';
  for (const std::uint8_t level : chosen) {
    expected += std::to_string(static_cast<int>(crowd.levels[level].kind)) + ' ' +
                std::to_string(crowd.levels[level].number) + ' ';
  }
  const std::string in = "cd '" + folder_.string() + "' && ";
  const std::string flags = " -O2 -Wall -Wextra -Werror -pedantic -I'" FOREDRAW_SOURCE_DIR "/framework' ";
  for (const std::string& compile : {"cc -std=c99" + flags + "use.c", "c++ -std=c++11" + flags + "use.cpp"}) {
    ASSERT_EQ(std::system((in + compile + " -o use -lm && ./use > said").c_str()), 0) << compile;
    EXPECT_EQ(testing::content(folder_ / "said"), expected) << compile;
  }
}

TEST_F(CrowdLevelsFiles, TheJsonSaysHowFarLevelsReach) {
  const Scene scene = testing::run("crowd-levels(most=8)", testing::displaced_parabola(1)).scene;
  Diagnostics diagnostics;
  const auto files = encode_side_file(scene, *crowd_levels_product(), folder_ / "t.json", diagnostics);
  ASSERT_TRUE(files);
  const auto json = nlohmann::json::parse(files->front().bytes);
  EXPECT_EQ(json["characters"], 10);
  const auto& levels = json["crowds"][0]["levels"];
  ASSERT_EQ(levels.size(), 9u);
  EXPECT_EQ(json["crowds"][0]["budget"], 10 * 2 * 96);
  EXPECT_EQ(levels[0]["reach"], 1.0);
  double before = 1;
  for (int l = 1; l < 7; ++l) {
    EXPECT_TRUE(levels[l]["on-hull"].get<bool>()) << l;
    EXPECT_GE(levels[l]["reach"].get<double>(), before) << l;
    before = levels[l]["reach"].get<double>();
  }
  EXPECT_EQ(levels[7]["class"], "tessellated");
  EXPECT_FALSE(levels[8]["on-hull"].get<bool>()) << "level 1 costs as much as the plain draw, and is nearer";
  EXPECT_EQ(levels[7].count("reach"), 0u) << "what is left at any distance";
}

}  // namespace
}  // namespace foredraw::crowd_levels_files_test

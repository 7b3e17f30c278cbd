#include "plugins/processors/lod_table/lod_table.h"

#include "support/lod_tables.h"
#include "support/program.h"

#include <foredraw/analysis/vertex_cache.h>
#include <foredraw/scene/reorder.h>
#include <foredraw/technique/plugin.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>

namespace foredraw::lod_table_test {
namespace {

using testing::ball_and_plate;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::table_of;
using testing::with_table;

int ways_in(const std::array<std::uint32_t, LodTable::renderings>& masks) {
  int count = 0;
  for (const std::uint32_t mask : masks) count += std::popcount(mask);
  return count;
}

TEST(LodTable, CountsWhatALevelTakes) {
  Level level = testing::draw_of(testing::shuffled(testing::grid(20, 20), 3)).full();
  level.error = 0.25f;
  const LodTable::OfLevel row = lod_level(level);
  EXPECT_EQ(row.triangles, 800u);
  EXPECT_EQ(row.vertices, 441u);
  EXPECT_EQ(row.shaded, count_fifo(level.stream().indices.view(), 441, 16).misses);
  EXPECT_GT(row.shaded, 1500u) << "in random order hardly a vertex is still there";
  EXPECT_EQ(row.error, 0.25f);
}

LodTable::OfDraw rock() {
  LodTable::OfDraw draw;
  draw.radius = 2;
  draw.coverage = 0.7f;
  draw.accuracy = {1, 0.9f, 0.5f};
  draw.levels = {{8000, 5000, 4100, 0}, {4000, 2500, 2100, 0.01f}, {2000, 1300, 1100, 0.03f}, {400, 280, 220, 0.2f}};
  return draw;
}

TEST(LodTable, LeavesWaysOutThatAreNeverWorthTheirCost) {
  const LodTable::Hulls hulls = lod_hulls(example_costs(), rock());
  for (const auto& masks : hulls) {
    EXPECT_EQ(masks[0] & 1u, 1u) << "nothing is as good as full detail";
    EXPECT_NE(masks[2], 0u) << "nothing is as cheap as what has no light";
    EXPECT_LE(ways_in(masks), 8) << "of 12";
  }
  EXPECT_EQ(hulls.front()[2] & 8u, 8u) << "where it is small, the coarsest level is the cheapest";
  EXPECT_EQ(hulls.back()[0] & 8u, 0u) << "where it is large, the coarsest level in full light is neither";
}

/// As good and cheaper: the dearer one is never chosen.
TEST(LodTable, ARenderingThatLooksTheSameTakesThePlaceOfADearerOne) {
  LodTable::OfDraw draw = rock();
  draw.accuracy = {1, 1, 0.5f};
  RenderingCosts costs = example_costs();
  costs.of(Rendering::full) = {1, 1, 2};
  costs.of(Rendering::without_normal_map) = {0.9, 0.9, 1};
  for (const auto& masks : lod_hulls(costs, draw)) EXPECT_EQ(masks[0], 0u);
}

/// Where pixels take longer than triangles, coarser levels save nothing.
TEST(LodTable, WhatIsPixelBoundIsNotDrawnCoarser) {
  RenderingCosts costs = example_costs();
  for (RenderingCost& of : costs.renderings) of = {1e-6, 1e-6, 100};
  for (const auto& masks : lod_hulls(costs, rock())) {
    for (const std::uint32_t mask : masks) EXPECT_EQ(mask & ~1u, 0u);
  }
}

/// Nodes of MSFT_lod have no place for errors. The table still knows them.
TEST(LodTable, KnowsErrorsThatTheSceneDoesNot) {
  Scene scene = with_table();
  for (Level& level : scene.draws[0].levels) level.error = 0;
  EXPECT_EQ(lod_table_product()->difference(scene), "");
  EXPECT_EQ(table_of(scene).draws[0].levels[1].error, 0.04f);
}

/// A ball without light is a disc. It has no normal map, so it is the same without.
TEST(LodTable, AccuracyIsMeasuredInPictures) {
  const Scene scene = with_table();
  const LodTable::OfDraw &ball = table_of(scene).draws[0], &plate = table_of(scene).draws[1];
  EXPECT_NEAR(ball.radius, 1, 1e-3);
  EXPECT_NEAR(ball.coverage, 1, 0.02);
  EXPECT_EQ(ball.accuracy[0], 1);
  EXPECT_EQ(ball.accuracy[1], 1);
  EXPECT_GE(ball.accuracy[2], 0);
  EXPECT_LT(ball.accuracy[2], 0.9f);
  EXPECT_LT(plate.coverage, 0.4f) << "it is seen at an edge, mostly";
}

TEST(LodTable, KnowsEachLevelOfEachDraw) {
  const Result result = testing::run("lod-table", ball_and_plate());
  ASSERT_FALSE(result.failed);
  const LodTable& table = table_of(result.scene);
  EXPECT_EQ(table.costs, example_costs());
  ASSERT_EQ(table.draws.size(), 2u);
  EXPECT_EQ(table.draws[0].draw, 0u);
  ASSERT_EQ(table.draws[0].levels.size(), 3u);
  EXPECT_EQ(table.draws[1].levels.size(), 1u);
  for (std::size_t l = 0; l < 3; ++l) {
    EXPECT_EQ(table.draws[0].levels[l], lod_level(result.scene.draws[0].levels[l]));
  }
  EXPECT_EQ(table.draws[0].hulls, lod_hulls(table.costs, table.draws[0]));
}

std::vector<std::string> codes(const Result& result) {
  std::vector<std::string> all;
  for (const StageRecord& stage : result.report.stages) {
    for (const NoteRecord& note : stage.notes) {
      if (note.code != LodTable::product) all.push_back(note.code);  // what `inspect` tells
    }
  }
  return all;
}

class LodTableCosts : public testing::InFolder {};

TEST_F(LodTableCosts, ComeFromAFileOrANoteSaysThatTheyAreAnExamples) {
  EXPECT_THAT(codes(testing::run("lod-table", ball_and_plate())), ElementsAre("example-costs"));
  RenderingCosts costs = example_costs();
  costs.machine = "mine";
  costs.stages = Stages::sum;
  const std::string path = (folder_ / "mine.txt").string();
  testing::put(path, costs_text(costs));
  const Result measured = testing::run("lod-table(costs=\"" + path + "\")", ball_and_plate());
  EXPECT_TRUE(codes(measured).empty());
  EXPECT_EQ(table_of(measured.scene).costs, costs);
  testing::put(path, "stages min\n");
  EXPECT_THAT([&] { testing::run("lod-table(costs=\"" + path + "\")", ball_and_plate()); },
              ::testing::ThrowsMessage<std::runtime_error>(HasSubstr("mine.txt:1: expected 'stages max'")));
}

TEST(LodTable, AStageForEachImportance) {
  const Scene scene =
      testing::run("lod-table(importance=0.5), lod-table(importance=0.25, only=\"plate\")", ball_and_plate()).scene;
  const LodTable& table = table_of(scene);
  ASSERT_EQ(table.draws.size(), 2u);
  EXPECT_EQ(table.draws[0].importance, 0.5f);
  EXPECT_EQ(table.draws[1].importance, 0.25f);
  EXPECT_EQ(table.draws[0].hulls, table_of(with_table()).draws[0].hulls) << "it moves no way on the hull or off it";
}

TEST(LodTable, LeavesOutWhatHasNoSize) {
  Scene scene = ball_and_plate();
  testing::TestMesh point = testing::grid(1, 1);
  std::ranges::fill(point.positions, glm::vec3(1, 2, 3));
  scene.draws[1] = testing::draw_of(point, "point");
  const Result result = testing::run("lod-table", scene);
  EXPECT_EQ(table_of(result.scene).draws.size(), 1u);
  EXPECT_THAT(codes(result), ElementsAre("no-row", "example-costs"));
  scene = testing::scene_of({testing::draw_of(point, "point")});
  EXPECT_FALSE(testing::run("lod-table", scene).scene.products.has(LodTable::product));
  testing::TestMesh large = testing::grid(1, 1);
  for (glm::vec3& p : large.positions) p = (p * 2.0f - 1.0f) * 3e38f;
  EXPECT_FALSE(testing::run("lod-table", testing::scene_of(large)).scene.products.has(LodTable::product))
      << "its radius is no float";
  scene = ball_and_plate();
  scene.draws[0].levels.resize(33, scene.draws[0].levels.back());
  EXPECT_EQ(table_of(testing::run("lod-table", scene).scene).draws.size(), 1u) << "bits for 32 levels";
}

TEST(LodTable, FollowsOrdersThatStagesMakeLater) {
  Scene scene = ball_and_plate();
  for (Level& level : scene.draws[0].levels) {  // as a cache would not have it
    const std::size_t triangles = level.stream().triangle_count();
    std::vector<std::uint32_t> order(triangles);
    for (std::size_t i = 0; i < triangles; ++i) order[i] = static_cast<std::uint32_t>(i * 7 % triangles);
    level.stream() = with_triangle_order(level.stream(), order);
  }
  const Scene first = testing::run("lod-table", scene).scene;
  const Result moved = testing::run("lod-table, weld, tipsify, vertex-fetch", scene);
  EXPECT_FALSE(moved.failed);
  const LodTable::OfDraw &before = table_of(first).draws[0], &after = table_of(moved.scene).draws[0];
  EXPECT_LT(after.levels[0].shaded, before.levels[0].shaded / 2);
  EXPECT_EQ(after.levels[0], lod_level(moved.scene.draws[0].full()));
  EXPECT_EQ(lod_table_product()->difference(moved.scene), "");
}

TEST(LodTable, LosesADrawWhoseLevelsAreMadeIntoOthersAndTheReportSaysSo) {
  const Scene before = with_table();
  const auto told = [&](const std::function<void(Scene&)>& change) {
    Scene after = before;
    change(after);
    auto lines = lod_table_product()->follow(before, after);
    EXPECT_EQ(table_of(after).draws.size(), 2 - lines.size());
    EXPECT_EQ(lod_table_product()->difference(after), "");
    return lines;
  };
  const std::string lost = "the table of levels and renderings leaves ball out: its levels were replaced";
  EXPECT_THAT(told([](Scene&) {}), ElementsAre());
  EXPECT_THAT(told([](Scene& scene) { scene.draws[0].levels.pop_back(); }), ElementsAre(lost));
  EXPECT_THAT(told([](Scene& scene) { scene.draws[0].levels[1].error = 0.5f; }), ElementsAre(lost));
  EXPECT_THAT(told([](Scene& scene) { scene.draws[0].levels[1] = testing::draw_of(testing::grid(2, 2)).full(); }),
              ElementsAre(lost));
  Scene none = before;
  for (Draw& draw : none.draws) draw.levels.push_back(draw.levels.back());
  EXPECT_EQ(lod_table_product()->follow(before, none).size(), 2u);
  EXPECT_FALSE(none.products.has(LodTable::product));
}

TEST(LodTable, IsHeldAgainstTheScene) {
  const Scene scene = with_table();
  const auto difference = [&](const std::function<void(LodTable&)>& change) {
    LodTable table = table_of(scene);
    change(table);
    Scene changed = scene;
    changed.products.set(std::move(table));
    return lod_table_product()->difference(changed);
  };
  EXPECT_EQ(difference([](LodTable&) {}), "");
  EXPECT_EQ(difference([](LodTable& t) { t.draws[0].draw = 7; }), "a draw of it is gone");
  EXPECT_EQ(difference([](LodTable& t) { t.draws[0].levels.pop_back(); }), "ball has levels: 3, not 2");
  EXPECT_THAT(difference([](LodTable& t) { t.draws[0].levels[1].triangles += 1; }), HasSubstr("level 1 of ball has"));
  EXPECT_THAT(difference([](LodTable& t) { t.draws[0].levels[1].vertices -= 1; }), HasSubstr("vertices, not"));
  EXPECT_THAT(difference([](LodTable& t) { t.draws[0].levels[0].shaded *= 2; }), HasSubstr("shades"));
  EXPECT_THAT(difference([](LodTable& t) { t.draws[0].levels[2].error = 0.1f; }), HasSubstr("has an error of 0.16"));
  EXPECT_EQ(difference([](LodTable& t) { t.draws[0].hulls[3][1] ^= 1u; }), "ball has other ways on its hulls");
  EXPECT_EQ(difference([](LodTable& t) { t.costs.renderings[2].pixel *= 50; }), "ball has other ways on its hulls");
}

}  // namespace
}  // namespace foredraw::lod_table_test

#include "plugins/processors/crowd_levels/crowd_levels.h"

#include "support/crowd_levels.h"

#include <foredraw/displaced/tessellation_pattern.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace foredraw::crowd_levels_test {
namespace {

using testing::crowd_levels_of;
using testing::crowd_of_balls;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::with_crowd_levels;

TEST(CrowdLevels, CountsTrianglesAsTessellatorsDo) {
  const Draw draw = testing::draw_of(testing::grid(3, 3));
  constexpr std::pair<TessellationSpacing, std::uint32_t> all[] = {{TessellationSpacing::equal, 1},
                                                                   {TessellationSpacing::fractional_odd, 2},
                                                                   {TessellationSpacing::fractional_even, 2}};
  for (const auto& [spacing, step] : all) {
    for (std::uint32_t parts = spacing == TessellationSpacing::fractional_even ? 2 : 1; parts <= 64; parts += step) {
      const auto level = static_cast<float>(parts);
      const CrowdLevel row = counted({.kind = CrowdClass::tessellated, .number = parts}, draw, true);
      EXPECT_EQ(row.triangles, 18 * tessellation_counts({{level, level, level}, level}, spacing).triangles) << parts;
    }
  }
}

TEST(CrowdLevels, HasAClassForEachWayToDraw) {
  const Scene scene = testing::run("crowd-levels(most=4)", testing::displaced_parabola(1)).scene;
  const CrowdLevels& levels = crowd_levels_of(scene);
  ASSERT_EQ(levels.draws.size(), 1u);
  ASSERT_EQ(levels.draws[0].levels.size(), 5u);
  for (std::uint32_t i = 0; i < 4; ++i) {
    EXPECT_EQ(levels.draws[0].levels[i].kind, CrowdClass::tessellated);
    EXPECT_EQ(levels.draws[0].levels[i].number, 4 - i);
    EXPECT_EQ(levels.draws[0].levels[i].triangles, 2 * foredraw_tessellation_triangles(4 - i));
    EXPECT_EQ(levels.draws[0].levels[i].vertices, 4u) << "the others are made anew in every frame";
  }
  EXPECT_EQ(levels.draws[0].levels[4].kind, CrowdClass::plain);
  EXPECT_EQ(levels.draws[0].levels[4].triangles, 2u);
  EXPECT_EQ(crowds_of(levels)[0].budget, 10u * 48);
}

/// Of x^2, lines of length w are off by w^2 / 4 at most, and by w^2 / sqrt(30) in the root mean square. The rings of a
/// tessellator lie 2 / 3 of a part inside one another along a side's height, so inner lines are up to 4 / 3 as long.
TEST(CrowdLevels, DistancesAreThoseOfAParabola) {
  const Scene scene = testing::run("crowd-levels(most=16, characters=3)", testing::displaced_parabola(0.5f)).scene;
  for (const CrowdLevel& level : crowd_levels_of(scene).draws[0].levels) {
    if (level.kind == CrowdClass::plain) {
      EXPECT_NEAR(level.largest, 0.5, 0.005);
      EXPECT_NEAR(level.rms, 0.5 / std::sqrt(5.0), 0.01);
    } else if (level.number <= 4) {
      const double width = 1.0 / level.number;
      const double inside = level.number == 1 ? 1 : 4.0 / 3;
      EXPECT_NEAR(level.largest / (0.5 * width * width / 4), inside * inside, 0.03) << level.number;
      EXPECT_NEAR(level.rms / (0.5 * width * width / std::sqrt(30.0)), 1, 0.15) << level.number;
    }
  }
}

TEST(CrowdLevels, ASpacingHasItsOwnLevels) {
  const auto numbers = [](const std::string& options) {
    std::vector<std::uint32_t> all;
    const Scene scene = testing::run("crowd-levels(" + options + ")", testing::displaced_parabola(1)).scene;
    for (const CrowdLevel& level : crowd_levels_of(scene).draws[0].levels) all.push_back(level.number);
    return all;
  };
  EXPECT_THAT(numbers("most=6, spacing=\"fractional-odd\""), ElementsAre(5, 3, 1, 0));
  EXPECT_THAT(numbers("most=6, spacing=\"fractional-even\""), ElementsAre(6, 4, 2, 0));
  EXPECT_THAT(numbers("most=1, spacing=\"fractional-even\""), ElementsAre(2, 0));
  EXPECT_EQ(numbers("most=64").size(), 65u);
}

TEST(CrowdLevels, SimplifiedOnesAreTheLevelsOfDetail) {
  const Scene scene = with_crowd_levels();
  const CrowdLevels& levels = crowd_levels_of(scene);
  ASSERT_EQ(levels.draws.size(), 1u) << "a plate of one level is no crowd";
  const std::vector<CrowdLevel>& rows = levels.draws[0].levels;
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].kind, CrowdClass::plain);
  EXPECT_EQ(rows[0].largest, 0);
  for (std::uint32_t l = 1; l < 3; ++l) {
    const Level& level = scene.draws[0].levels[l];
    EXPECT_EQ(rows[l].kind, CrowdClass::simplified);
    EXPECT_EQ(rows[l].number, l);
    EXPECT_EQ(rows[l].triangles, level.stream().triangle_count());
    EXPECT_EQ(rows[l].vertices, level.vertices->count);
    EXPECT_EQ(rows[l].largest, level.error);
    EXPECT_GT(rows[l].rms, 0.05f * level.error);
  }
  EXPECT_NEAR(levels.draws[0].area, 4 * 3.14159, 0.1);
}

/// A simplified level of something displaced lacks the displacement too.
TEST(CrowdLevels, WhatIsDisplacedIsFartherOff) {
  Scene scene = testing::displaced_parabola(0.5f);
  Level coarser = scene.draws[0].full();
  coarser.error = 0.25f;
  scene.draws[0].levels.push_back(coarser);
  const auto rows = crowd_levels_of(testing::run("crowd-levels(most=2)", scene).scene).draws[0].levels;
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[3].largest, rows[2].largest + 0.25f);
  EXPECT_NEAR(rows[3].rms, rows[2].rms, 1e-6) << "it is the same surface";
}

TEST(CrowdLevels, DrawsOfACharacterAreDrawnTogether) {
  Scene scene = crowd_of_balls();
  scene.meshes[0].draws = {0, 1};
  scene.meshes.pop_back();
  for (Node& node : scene.nodes) node.mesh = 0;
  scene.nodes.resize(1);
  scene.roots.clear();
  const CrowdLevels levels = crowd_levels_of(testing::run("crowd-levels(characters=7)", scene).scene);
  ASSERT_EQ(levels.draws.size(), 2u);
  EXPECT_EQ(levels.draws[0].crowd, levels.draws[1].crowd);
  EXPECT_EQ(levels.draws[1].levels.size(), 3u);
  EXPECT_EQ(levels.draws[1].levels[2].triangles, 128u) << "it has no coarser one";
  EXPECT_EQ(levels.draws[1].levels[2].rms, 0);
  const std::vector<Crowd> crowds = crowds_of(levels);
  ASSERT_EQ(crowds.size(), 1u);
  EXPECT_THAT(crowds[0].draws, ElementsAre(0, 1));
  for (std::size_t l = 0; l < 3; ++l) {
    const CrowdLevel &ball = levels.draws[0].levels[l], &plate = levels.draws[1].levels[l], &all = crowds[0].levels[l];
    EXPECT_EQ(all.triangles, ball.triangles + plate.triangles);
    EXPECT_EQ(all.vertices, ball.vertices + plate.vertices);
    EXPECT_EQ(all.largest, ball.largest);
    const double area = levels.draws[0].area, both = area + levels.draws[1].area;
    EXPECT_NEAR(all.rms, ball.rms * std::sqrt(area / both), 1e-6);
  }
  EXPECT_EQ(crowds[0].budget, 7ull * crowds[0].levels[0].triangles);
}

std::vector<std::string> notes_of(const Result& result) {
  std::vector<std::string> all;
  for (const StageRecord& stage : result.report.stages) {
    for (const NoteRecord& note : stage.notes) {
      if (note.code != CrowdLevels::product) all.push_back(note.message);
    }
  }
  return all;
}

TEST(CrowdLevels, SaysWhatItLeavesOut) {
  EXPECT_THAT(notes_of(testing::run("crowd-levels", crowd_of_balls())),
              ElementsAre("no levels for a crowd of it: it has no level of detail, and no map of heights"));
  const Result nothing = testing::run("crowd-levels", testing::scene_of(testing::grid(2, 2)));
  EXPECT_FALSE(nothing.failed);
  EXPECT_FALSE(nothing.scene.products.has(CrowdLevels::product));
  Scene unread = testing::displaced_parabola(1);
  unread.images[0].is_texels = false;
  EXPECT_THAT(notes_of(testing::run("crowd-levels", unread)), ElementsAre(HasSubstr("is not tessellated: ")));
  Scene large = crowd_of_balls();
  large.draws[0].levels.resize(200, large.draws[0].levels.back());
  EXPECT_THAT(notes_of(testing::run("crowd-levels", large)),
              ::testing::Contains("no levels for a crowd of it: it has 200 levels, more than 128"));
}

TEST(CrowdLevels, WhatIsNoNumberIsLeftOut) {
  Scene scene = testing::displaced_parabola(1);
  scene.materials[0].displacement->factor = std::numeric_limits<float>::infinity();
  const Result result = testing::run("crowd-levels(most=3)", scene);
  EXPECT_FALSE(result.failed);
  for (const Crowd& crowd : result.scene.products.has(CrowdLevels::product) ? crowds_of(crowd_levels_of(result.scene))
                                                                            : std::vector<Crowd>{}) {
    for (const CrowdLevel& level : crowd.levels) EXPECT_TRUE(std::isfinite(level.rms) && std::isfinite(level.largest));
  }
}

TEST(CrowdLevels, FollowsOrdersAndVertexNumbers) {
  const Result moved = testing::run("crowd-levels, weld, tipsify, vertex-fetch", crowd_of_balls());
  EXPECT_FALSE(moved.failed);
  EXPECT_EQ(crowd_levels_product()->difference(moved.scene), "");
  EXPECT_EQ(crowd_levels_of(moved.scene).draws[0].levels[0].vertices, moved.scene.draws[0].full().vertices->count);
  EXPECT_EQ(crowd_levels_of(moved.scene).draws[0].levels[2].rms,
            crowd_levels_of(with_crowd_levels()).draws[0].levels[2].rms);
}

TEST(CrowdLevels, LosesACrowdThatIsMadeIntoOtherTrianglesAndTheReportSaysSo) {
  const Scene before = with_crowd_levels();
  const auto told = [&](const std::function<void(Scene&)>& change) {
    Scene after = before;
    change(after);
    return crowd_levels_product()->follow(before, after);
  };
  const std::string lost = "the levels of a crowd leave ball out: its triangles were replaced";
  EXPECT_THAT(told([](Scene&) {}), ElementsAre());
  EXPECT_THAT(told([](Scene& scene) { scene.draws[0].levels.pop_back(); }), ElementsAre(lost));
  EXPECT_THAT(told([](Scene& scene) { scene.draws[0].levels[1].error = 0.5f; }), ElementsAre(lost));
  EXPECT_THAT(told([](Scene& scene) { scene.draws[0].full() = testing::draw_of(testing::grid(2, 2)).full(); }),
              ElementsAre(lost));
  const Scene displaced = testing::displaced_parabola(1);
  const Result flat = testing::run("crowd-levels(most=2), tessellate(parts=1)", displaced);
  EXPECT_FALSE(flat.scene.products.has(CrowdLevels::product)) << "it is moved for good";
}

TEST(CrowdLevels, IsHeldAgainstTheScene) {
  const Scene scene = with_crowd_levels();
  const auto difference = [&](const std::function<void(CrowdLevels&)>& change) {
    CrowdLevels levels = crowd_levels_of(scene);
    change(levels);
    Scene changed = scene;
    changed.products.set(std::move(levels));
    return crowd_levels_product()->difference(changed);
  };
  EXPECT_EQ(difference([](CrowdLevels&) {}), "");
  EXPECT_EQ(difference([](CrowdLevels& l) { l.draws[0].draw = 9; }), "a draw of it is gone");
  EXPECT_THAT(difference([](CrowdLevels& l) { l.draws[0].levels[1].triangles += 1; }),
              HasSubstr("triangles simplified 1"));
  EXPECT_THAT(difference([](CrowdLevels& l) { l.draws[0].levels[0].vertices -= 1; }), HasSubstr("vertices plain 0"));
  EXPECT_EQ(difference([](CrowdLevels& l) { l.draws[0].levels.pop_back(); }), "ball is drawn with levels: 3, not 2");
}

TEST(CrowdLevels, IsTheSameAtAnyNumberOfThreads) {
  const Scene scene = testing::displaced_grid(9, 9, testing::height_image(64, 64, [](auto x, auto y) {
                                                return static_cast<std::uint16_t>(x * y * 2654435761u >> 8);
                                              }));
  std::vector<CrowdLevel> rows;
  for (std::uint32_t parts : {5u, 2u}) rows.push_back({.kind = CrowdClass::tessellated, .number = parts});
  rows.push_back({.kind = CrowdClass::plain});
  Analyses analyses;
  const auto one = crowd_levels(scene, 0, rows, {}, analyses, Executor(1));
  EXPECT_EQ(one, crowd_levels(scene, 0, rows, {}, analyses, Executor(2)));
  EXPECT_EQ(one.levels[0].rms, crowd_levels(scene, 0, rows, {}, analyses, Executor(0)).levels[0].rms);
  EXPECT_GT(one.levels[0].rms, 0.1f);
}

}  // namespace
}  // namespace foredraw::crowd_levels_test

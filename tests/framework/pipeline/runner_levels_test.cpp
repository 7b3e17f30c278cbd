// Every stage works on every level of detail; figures of coarser levels stand by themselves.

#include <foredraw/pipeline/runner.h>

#include "runs_stages.h"

#include <foredraw/measuring/level_processor.h>
#include <foredraw/scene/levels.h>
#include <foredraw/scene/order_table.h>
#include <foredraw/technique/built_in_plugins.h>

#include <nlohmann/json.hpp>

namespace foredraw::runner_levels_test {
namespace {

Draw levels_of(const std::vector<testing::TestMesh>& meshes, const std::string& name) {
  Draw draw = testing::draw_of(meshes.front(), name);
  for (std::size_t i = 1; i < meshes.size(); ++i) draw.levels.push_back(testing::draw_of(meshes[i]).full());
  return draw;
}

/// A level of every second triangle, said to lie nowhere away from full detail.
class Halved final : public LevelMaker {
 public:
  SubjectLevels levels(const SubjectView& view, Run&) const override {
    SubjectLevels levels;
    for (const DrawId id : view.draws) {
      const Level& full = view.scene.draws[id].full();
      std::vector<std::uint32_t> indices;
      for (std::size_t i = 0; i + 3 <= full.stream().indices.size(); i += 6) {
        for (std::size_t c = 0; c < 3; ++c) indices.push_back(full.stream().indices.view()[i + c]);
      }
      levels.push_back({{full.vertices, Shared<std::uint32_t>(std::move(indices)), 0, {}}});
    }
    return levels;
  }
};

Plugin halved() {
  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {.name = "halved",
                 .summary = "For tests",
                 .reference = "own",
                 .acts_on = {traits::triangles},
                 .metrics = level_metrics()};
  plugin.create = [](const Settings&) -> Technique { return level_processor(std::make_unique<const Halved>()); };
  return plugin;
}

class RunnerLevels : public testing::RunsStages {
 protected:
  RunnerLevels() {
    add_built_in_plugins(registry_);
    registry_.add(halved());
  }

  /// The same, of each level alone.
  Result run_alone(const std::string& stages, std::size_t level, const std::string& measure = "") {
    return run(stages, at_level(levels_, level), measure);
  }

  static std::vector<std::uint32_t> indices(const Draw& draw, std::size_t level) {
    const auto view = draw.levels[level].stream().indices.view();
    return {view.begin(), view.end()};
  }

  Scene levels_ = testing::scene_of(
      {levels_of({testing::shuffled(testing::sphere(24, 16), 1), testing::shuffled(testing::sphere(12, 8), 2),
                  testing::shuffled(testing::sphere(6, 4), 3)},
                 "Ball"),
       testing::draw_of(testing::shuffled(testing::torus(12, 8), 4), "Ring")});
};

TEST_F(RunnerLevels, AnOrderOfEachLevelIsThatOfTheLevelAlone) {
  const std::string stages = "weld, tipsify, vertex-fetch";
  const Result all = run(stages, levels_);
  ASSERT_FALSE(all.failed);
  for (std::size_t level = 0; level < 3; ++level) {
    const Result alone = run_alone(stages, level);
    EXPECT_EQ(indices(all.scene.draws[0], level), indices(alone.scene.draws[0], 0)) << level;
    EXPECT_EQ(traits_of(all.scene.draws[0], level), traits_of(alone.scene.draws[0])) << level;
  }
  EXPECT_EQ(all.report.stages[1].candidates, 4u);
  EXPECT_EQ(all.report.stages[1].loops_over, "levels of draws");
}

TEST_F(RunnerLevels, SubjectsAreOrderedAtEachLevelAndHaveSeveralOrdersAtFullDetailAlone) {
  const Result result = run("two-orders", levels_);
  ASSERT_FALSE(result.failed);
  EXPECT_EQ(result.scene.draws[0].levels[0].orders.size(), 2u);
  EXPECT_EQ(result.scene.draws[0].levels[1].orders.size(), 1u);
  EXPECT_EQ(order_tables(result.scene).size(), 2u);
}

TEST_F(RunnerLevels, OcclusionOrderMakesEachLevelDrawLess) {
  const std::string overdraw = "overdraw-raster(count=20, size=64)";
  const Result all = run("linear-clusters, occlusion-order", levels_, "overdraw-raster(count=20, size=64, level=1)");
  const Result alone = run_alone("linear-clusters, occlusion-order", 1, overdraw);
  ASSERT_FALSE(all.failed);
  const double before = all.report.before.metrics.find("overdraw-raster", "ratio")->value();
  EXPECT_EQ(before, alone.report.before.metrics.find("overdraw-raster", "ratio")->value());
  EXPECT_LT(all.report.after.metrics.find("overdraw-raster", "ratio")->value(), before);
  EXPECT_EQ(std::get<std::int64_t>(all.report.evaluator_options.at("overdraw-raster").at("level")), 1);
}

TEST_F(RunnerLevels, OneVertexOrderForLevelsThatShareTheirVertices) {
  Draw shared = testing::draw_of(testing::grid(2, 2), "Shared");
  shared.levels.push_back(shared.full());
  shared.levels[1].stream().indices = Shared<std::uint32_t>(std::vector<std::uint32_t>{0, 2, 6, 8, 6, 2});
  const Scene before = testing::scene_of({shared});
  const Result result = run("reverse-draw, reverse-vertices", before);
  ASSERT_FALSE(result.failed);
  const Draw& draw = result.scene.draws[0];
  EXPECT_EQ(draw.levels[0].vertices, draw.levels[1].vertices);
  EXPECT_EQ(indices(draw, 1), (std::vector<std::uint32_t>{0, 2, 6, 8, 6, 2}));  // reversed both ways
}

TEST_F(RunnerLevels, FiguresOfCoarserLevelsAreInNoTotal) {
  const Result all = run("tipsify", levels_, "vertex-cache");
  const Metrics& full = all.report.draws[0].after.metrics;
  ASSERT_EQ(all.report.draws[0].levels.size(), 2u);
  for (std::size_t level = 0; level < 3; ++level) {
    const Result alone = run_alone("tipsify", level, "vertex-cache");
    const StateRecord& state = level == 0 ? all.report.draws[0].after : all.report.draws[0].levels[level - 1].after;
    EXPECT_EQ(state.metrics.find("vertex-cache", "acmr")->value(),
              alone.report.draws[0].after.metrics.find("vertex-cache", "acmr")->value())
        << level;
    EXPECT_EQ(state.triangles, alone.report.draws[0].after.triangles);
  }
  EXPECT_EQ(all.report.after.metrics.find("vertex-cache", "acmr")->numerator,
            full.find("vertex-cache", "acmr")->numerator +
                all.report.draws[1].after.metrics.find("vertex-cache", "acmr")->numerator);
  const auto json = nlohmann::json::parse(to_json(all.report));
  EXPECT_EQ(json["draws"][0]["levels"].size(), 2u);
  EXPECT_FALSE(json["draws"][1].contains("levels"));
  EXPECT_NE(to_text(all.report).find("\nlevel 2: "), std::string::npos) << to_text(all.report);
}

TEST_F(RunnerLevels, OneLevelMayBeKeptWhereAnotherIsWorkedOn) {
  Scene scene = levels_;
  for (const std::size_t level : {0u, 2u}) {
    IndexStream& stream = scene.draws[0].levels[level].stream();
    scene.draws[0].levels[level].made.add(traits::clustered);
    stream.clusters = Clusters{{0, static_cast<std::uint32_t>(stream.triangle_count())}};
  }
  const Result result = run("pairs(only=Ring), needs-clusters", scene);
  ASSERT_FALSE(result.failed);
  EXPECT_EQ(result.report.stages[1].changed, 3u);
  ASSERT_EQ(result.report.stages[1].skipped.size(), 1u);
  EXPECT_EQ(result.report.stages[1].skipped[0].reason, "not clustered");
  EXPECT_EQ(result.report.stages[1].skipped[0].about, std::vector<std::string>{"Ball (level 1)"});
}

TEST_F(RunnerLevels, LevelsThatAStageMakesAreMeasuredAndWorkedOnByLaterOnes) {
  const Result result = run("halved, tipsify", at_level(levels_, 0), "vertex-cache");
  ASSERT_FALSE(result.failed) << "a claim that does not hold is a note";
  ASSERT_EQ(result.scene.draws[0].levels.size(), 2u);
  EXPECT_TRUE(traits_of(result.scene.draws[0], 1).has(traits::cache_ordered));
  const std::vector<NoteRecord>& notes = result.report.stages[0].notes;
  ASSERT_EQ(notes.size(), 2u);
  EXPECT_EQ(notes[0].code, "error-claim");
  EXPECT_EQ(notes[0].about, "Ball (level 1)");
  const LevelRecord& level = result.report.draws[0].levels.at(0);
  EXPECT_GT(level.error, 0);
  EXPECT_GE(level.error, level.after.metrics.find("halved", "error.largest")->value());
  EXPECT_FLOAT_EQ(level.error, static_cast<float>(level.after.metrics.find("halved", "error.largest")->value()));
  EXPECT_GT(level.after.metrics.find("halved", "error.rms")->error, 0);
  EXPECT_NE(level.after.metrics.find("vertex-cache", "acmr"), nullptr);
}

TEST_F(RunnerLevels, TheLevelIsAWordOfEvaluators) {
  EXPECT_THROW(run("tipsify(level=1)", levels_), std::runtime_error);
  const Result result = run("", levels_, "vertex-cache(level=2)");
  const Result alone = run_alone("", 2, "vertex-cache");
  EXPECT_EQ(result.report.after.metrics.find("vertex-cache", "acmr")->value(),
            alone.report.after.metrics.find("vertex-cache", "acmr")->value());
}

TEST_F(RunnerLevels, GivesTheSameAtAnyThreadCount) {
  const std::string stages = "weld, tipsify, linear-clusters, occlusion-order, vertex-fetch";
  const Result one = run(stages, levels_, "", Executor(1));
  const Result many = run(stages, levels_, "", Executor(4));
  for (std::size_t level = 0; level < 3; ++level) {
    EXPECT_EQ(indices(one.scene.draws[0], level), indices(many.scene.draws[0], level));
  }
}

}  // namespace
}  // namespace foredraw::runner_levels_test

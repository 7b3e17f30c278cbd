#include <foredraw/pipeline/runner.h>

#include "support/edit_product.h"
#include "support/meshes.h"
#include "support/test_plugins.h"

#include <foredraw/measuring/overdraw_evaluator.h>
#include <foredraw/pipeline/parse.h>
#include <foredraw/scene/levels.h>
#include <foredraw/scene/order_table.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <thread>

namespace foredraw {
namespace {

class Runner : public ::testing::Test {
 protected:
  Runner() { testing::add_test_plugins(registry_); }

  Result run(const std::string& stages, const Scene& scene, const std::string& measure = "", int threads = 2) {
    return run(stages, scene, measure, Executor(threads));
  }

  Result run(const std::string& stages, const Scene& scene, const std::string& measure, const Executor& executor) {
    Diagnostics diagnostics;
    auto pipeline = parse_line(stages, diagnostics);
    if (!measure.empty()) pipeline->measure = *parse_stages(measure, "measure", diagnostics);
    const auto plan = foredraw::plan(*pipeline, registry_, scene, diagnostics);
    if (!plan) throw std::runtime_error(to_text(diagnostics));
    Analyses analyses;
    return foredraw::optimize(*plan, scene, {executor, analyses});
  }

  static std::vector<std::uint32_t> indices(const Scene& scene, DrawId id, std::size_t order = 0) {
    const auto view = scene.draws[id].levels[0].orders[order].indices.view();
    return {view.begin(), view.end()};
  }

  static void expect_same(const Result& a, const Result& b) {
    for (DrawId id = 0; id < b.scene.draws.size(); ++id) {
      EXPECT_EQ(indices(a.scene, id), indices(b.scene, id));
      EXPECT_EQ(a.scene.draws[id].levels[0].vertices->stamp(), b.scene.draws[id].levels[0].vertices->stamp());
    }
  }

  Registry registry_;
  Scene two_ =
      testing::scene_of({testing::draw_of(testing::grid(2, 1), "A"), testing::draw_of(testing::grid(1, 1), "B")});
};

TEST_F(Runner, AppliesAnOrderAndBooksIt) {
  const Result result = run("reverse-draw", two_);
  EXPECT_EQ(indices(result.scene, 1), (std::vector<std::uint32_t>{2, 1, 3, 0, 1, 2}));
  const IndexStream& stream = result.scene.draws[1].levels[0].orders[0];
  EXPECT_EQ(stream.cache_size, 24);
  EXPECT_EQ(stream.triangle_origin.view()[0], 1u);
  EXPECT_TRUE(traits_of(result.scene.draws[1]).has(traits::cache_ordered));
  ASSERT_EQ(result.report.stages.size(), 1u);
  EXPECT_EQ(result.report.stages[0].changed, 2u);
}

TEST_F(Runner, AppliesClustersAndKeepsThemWhereTheyHold) {
  const Result kept = run("pairs", two_);
  EXPECT_EQ(kept.scene.draws[0].levels[0].orders[0].clusters->offsets, (std::vector<std::uint32_t>{0, 2, 4}));
  // The last triangle first turns each cluster round but keeps it in one piece.
  const Result turned = run("pairs, reverse-draw", two_);
  EXPECT_TRUE(traits_of(turned.scene.draws[0]).has(traits::clustered));
  EXPECT_EQ(turned.scene.draws[0].levels[0].orders[0].clusters->offsets, (std::vector<std::uint32_t>{0, 2, 4}));
}

TEST_F(Runner, NumbersVerticesForEveryDrawThatSharesThem) {
  Scene shared = two_;
  shared.draws[1].levels[0].vertices = shared.draws[0].levels[0].vertices;
  const Result result = run("reverse-vertices", shared);
  EXPECT_EQ(result.report.stages[0].candidates, 1u);
  EXPECT_EQ(result.scene.draws[0].levels[0].vertices, result.scene.draws[1].levels[0].vertices);
  EXPECT_EQ(indices(result.scene, 1), (std::vector<std::uint32_t>{5, 4, 3, 3, 4, 2}));
  EXPECT_EQ(decode_vec3(*result.scene.draws[0].levels[0].vertices->find("POSITION"))[0], glm::vec3(2, 1, 0));
}

TEST_F(Runner, AppliesTheOrdersOfASubject) {
  const Result result = run("two-orders", two_);
  ASSERT_EQ(order_tables(result.scene).size(), 2u);
  EXPECT_EQ(order_tables(result.scene)[1].order, (std::vector<std::uint8_t>{0, 1}));  // the unnamed one is left out
  ASSERT_EQ(result.scene.draws[1].levels[0].orders.size(), 2u);
  EXPECT_EQ(indices(result.scene, 1, 0), indices(two_, 1));
  EXPECT_EQ(indices(result.scene, 1, 1), (std::vector<std::uint32_t>{2, 1, 3, 0, 1, 2}));
}

TEST_F(Runner, RunsProcessorsOfEveryShape) {
  const Result result = run("add-draw, double-triangles(only=\"B\")", two_, "count-draws, count-triangles");
  EXPECT_FALSE(result.failed);
  EXPECT_EQ(result.scene.draws.size(), 3u);
  EXPECT_EQ(result.scene.draws[1].levels[0].orders[0].triangle_count(), 4u);
  const Report& report = result.report;
  EXPECT_EQ(report.before.metrics.find("count-draws", "draws")->value(), 2);
  EXPECT_EQ(report.after.metrics.find("count-draws", "draws")->value(), 3);
  EXPECT_EQ(report.before.metrics.find("count-triangles", "triangles")->value(), 6);
  EXPECT_EQ(report.after.metrics.find("count-triangles", "triangles")->value(), 12);
}

TEST_F(Runner, BooksWhatIsMeasuredOfDrawsThatAStageAdded) {
  const Result result = run("add-draw, double-triangles", two_, "count-triangles");
  const std::vector<DrawRecord>& draws = result.report.draws;
  ASSERT_EQ(draws.size(), 3u);
  EXPECT_EQ(draws[2].name, "A again");
  EXPECT_TRUE(draws[2].before.metrics.empty());
  ASSERT_NE(draws[2].after.metrics.find("add-draw", "added"), nullptr);
  EXPECT_EQ(draws[2].after.metrics.find("add-draw", "added")->value(), 1);
  ASSERT_NE(draws[2].after.metrics.find("count-triangles", "triangles"), nullptr);
  EXPECT_EQ(draws[2].after.metrics.find("count-triangles", "triangles")->value(), 8);
  EXPECT_EQ(draws[2].after.triangles, 8u);
  ASSERT_EQ(result.report.stages[0].notes.size(), 1u);
  EXPECT_EQ(result.report.stages[0].notes[0].about, "A again");
}

/// An evaluator: how many triangles the scene had that the run began with.
Plugin count_original() {
  class CountOriginal final : public Evaluator {
   public:
    void evaluate(const Scene&, Run& run) const override {
      std::size_t triangles = 0;
      for (const Draw& draw : run.original->draws) triangles += draw.full().stream().triangle_count();
      run.count("triangles", static_cast<double>(triangles));
    }
  };
  Plugin plugin;
  plugin.kind = Kind::evaluator;
  plugin.card = {.name = "count-original", .summary = "For tests", .reference = "own"};
  plugin.card.metrics = {{"triangles", "triangles", "Of the original"}};
  plugin.create = [](const Settings&) -> Technique { return std::make_unique<CountOriginal>(); };
  return plugin;
}

TEST_F(Runner, EvaluatorsSeeTheSceneThatTheRunBeganWith) {
  registry_.add(count_original());
  const Result result = run("add-draw, double-triangles", two_, "count-original, count-triangles");
  ASSERT_FALSE(result.failed);
  EXPECT_EQ(result.report.after.metrics.find("count-triangles", "triangles")->value(), 20);
  EXPECT_EQ(result.report.before.metrics.find("count-original", "triangles")->value(), 6);
  EXPECT_EQ(result.report.after.metrics.find("count-original", "triangles")->value(), 6);
}

/// A processor that fails where it sees more than what it changes.
Plugin needs_no_original() {
  class NeedsNoOriginal final : public DrawProcessor {
   public:
    Draw process(const DrawView& draw, Run& run) const override {
      if (run.original != nullptr) throw std::runtime_error("it sees more than what it is given");
      return draw.draw();
    }
  };
  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {.name = "needs-no-original", .summary = "For tests", .reference = "own"};
  plugin.create = [](const Settings&) -> Technique { return std::make_unique<NeedsNoOriginal>(); };
  return plugin;
}

TEST_F(Runner, WhatChangesASceneSeesThatAlone) {
  registry_.add(needs_no_original());
  EXPECT_FALSE(run("needs-no-original", two_).failed);
}

TEST_F(Runner, TotalsAreSumsOfNumeratorsOverSumsOfDenominators) {
  const Result result = run("", two_, "count-triangles");
  const Figure* total = result.report.after.metrics.find("count-triangles", "corners-per-vertex");
  ASSERT_NE(total, nullptr);
  EXPECT_DOUBLE_EQ(total->value(), (12.0 + 6.0) / (6.0 + 4.0));
  EXPECT_EQ(total->unit, "corners per vertex");
}

TEST_F(Runner, TwoUsesOfAnEvaluatorAreKeptApart) {
  const Result result = run("", two_, "count-draws, count-draws");
  EXPECT_EQ(result.report.after.metrics.find("count-draws", "draws")->value(), 2);
  EXPECT_EQ(result.report.after.metrics.find("count-draws#2", "draws")->value(), 2);
}

TEST_F(Runner, ComparesPlansAsIfEachRanAlone) {
  const std::vector<std::string> lines = {"pairs, reverse-draw", "pairs",
                                          "pairs, faulty(fault=\"throw\"), reverse-vertices"};
  std::vector<Plan> plans;
  for (const std::string& line : lines) {
    Diagnostics diagnostics;
    Pipeline pipeline = *parse_line(line, diagnostics);
    pipeline.measure = *parse_stages("count-triangles", "measure", diagnostics);
    plans.push_back(*foredraw::plan(pipeline, registry_, two_, diagnostics));
  }
  const Executor executor(2);
  Analyses analyses;
  for (const int rounds : {1, 4}) {
    const std::vector<Result> compared = compare(plans, two_, rounds, {executor, analyses});
    ASSERT_EQ(compared.size(), lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const Result alone = run(lines[i], two_, "count-triangles");
      for (DrawId draw = 0; draw < 2; ++draw) EXPECT_EQ(indices(compared[i].scene, draw), indices(alone.scene, draw));
      EXPECT_EQ(compared[i].failed, alone.failed);
      EXPECT_EQ(compared[i].report.diagnostics.size(), alone.report.diagnostics.size());
      EXPECT_EQ(compared[i].report.pipeline, alone.report.pipeline);
      EXPECT_EQ(compared[i].report.before.metrics.all().size(), alone.report.before.metrics.all().size());
      ASSERT_EQ(compared[i].report.stages.size(), alone.report.stages.size());
      for (const StageRecord& stage : compared[i].report.stages) {
        ASSERT_EQ(stage.rounds.size(), rounds == 1 ? 0u : 4u);
        if (rounds == 1) continue;
        std::vector<double> sorted = stage.rounds;
        std::ranges::sort(sorted);
        EXPECT_EQ(stage.seconds, (sorted[1] + sorted[2]) / 2);
      }
    }
    EXPECT_EQ(compared[0].report.stages[0].seconds, compared[1].report.stages[0].seconds);  // it ran for all of them
  }
}

TEST_F(Runner, ComparingLeavesTheAnalysesOfItsCallerAlone) {
  Diagnostics diagnostics;
  const std::vector<Plan> plans = {*foredraw::plan(*parse_line("pairs", diagnostics), registry_, two_, diagnostics)};
  const Executor executor(2);
  Analyses analyses;
  positions_of(analyses, *two_.draws[0].levels[0].vertices);
  compare(plans, two_, 2, {executor, analyses});
  EXPECT_EQ(analyses.size(), 1u);
}

TEST_F(Runner, ComparingNoPlansGivesNoResults) {
  const Executor executor(1);
  Analyses analyses;
  EXPECT_TRUE(compare({}, two_, 1, {executor, analyses}).empty());
}

class Fault : public Runner, public ::testing::WithParamInterface<const char*> {};

TEST_P(Fault, KeepsTheDrawAsItWasAndGoesOn) {
  const Result result =
      run(std::string("faulty(on=\"A\", fault=\"") + GetParam() + "\"), reverse-draw(only=\"B\")", two_);
  EXPECT_TRUE(result.failed);
  EXPECT_EQ(indices(result.scene, 0), indices(two_, 0));
  EXPECT_NE(indices(result.scene, 1), indices(two_, 1));
  ASSERT_EQ(result.report.diagnostics.size(), 1u);
  EXPECT_EQ(result.report.diagnostics[0].code, "stage-failed");
  EXPECT_EQ(result.report.diagnostics[0].where.inside, "A");
  EXPECT_EQ(result.report.stages[0].changed, 1u);
}
INSTANTIATE_TEST_SUITE_P(EveryKind, Fault, ::testing::Values("throw", "odd-throw", "short", "repeat"),
                         [](const auto& info) {
                           std::string name = info.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

Plugin failing_evaluator() {
  class Fails final : public Evaluator {
   public:
    void evaluate(const Scene&, Run&) const override { throw std::runtime_error("there is nothing to count with"); }
  };
  Plugin plugin;
  plugin.kind = Kind::evaluator;
  plugin.card = {.name = "fails", .summary = "For tests", .reference = "own"};
  plugin.create = [](const Settings&) -> Technique { return std::make_unique<Fails>(); };
  return plugin;
}

/// It fails on the input and on the output.
TEST_F(Runner, AFailingEvaluatorIsToldOnce) {
  registry_.add(failing_evaluator());
  const Result result = run("reverse-draw", two_, "fails, count-draws");
  EXPECT_TRUE(result.failed);
  ASSERT_EQ(result.report.diagnostics.size(), 1u);
  EXPECT_EQ(result.report.diagnostics[0].message, "stage 2 'fails' failed: there is nothing to count with");
  EXPECT_EQ(result.report.diagnostics[0].hint, "its figures are left out; the run continues");
}

TEST_F(Runner, AsksTheServiceThatThePipelineNames) {
  const Result result = run("ask-overdraw", two_);
  EXPECT_FALSE(result.failed);
  EXPECT_EQ(indices(result.scene, 1), (std::vector<std::uint32_t>{2, 1, 3, 0, 1, 2}));  // reversed: 3 > 2
}

TEST_F(Runner, SaysWhichDrawHoldsVerticesBack) {
  Scene shared = two_;
  shared.draws[1].levels[0].vertices = shared.draws[0].levels[0].vertices;
  shared.draws[1].traits.add(traits::extended);
  const Result result = run("reverse-vertices", shared);
  ASSERT_EQ(result.report.stages[0].skipped.size(), 2u);
  EXPECT_EQ(result.report.stages[0].skipped[1].code, "shared-vertices");
  EXPECT_EQ(result.report.stages[0].skipped[1].about, (std::vector<std::string>{"A"}));
  EXPECT_EQ(result.scene.draws[0].levels[0].vertices, shared.draws[0].levels[0].vertices);
}

TEST_F(Runner, GivesNoSecondReasonForASubjectWhoseDrawsHaveOne) {
  Scene glass = two_;
  glass.draws[0].traits.add(traits::blended);
  const Result result = run("two-orders", glass);
  ASSERT_EQ(result.report.stages[0].skipped.size(), 1u);
  EXPECT_EQ(result.report.stages[0].skipped[0].code, "blended");
  EXPECT_EQ(result.report.stages[0].skipped[0].about, std::vector<std::string>{"A"});
  EXPECT_EQ(result.report.stages[0].changed, 1u);
}

TEST_F(Runner, ForgetsTablesWhoseOrdersAreGone) {
  const Result again = run("two-orders, two-orders", two_);
  EXPECT_EQ(order_tables(again.scene).size(), 2u);
  EXPECT_EQ(again.scene.draws[0].levels[0].orders.size(), 2u);
  const Result after = run("two-orders, reverse-draw(only=\"A\")", two_);
  ASSERT_EQ(order_tables(after.scene).size(), 1u);
  EXPECT_EQ(order_tables(after.scene)[0].draws, (std::vector<DrawId>{1}));
  EXPECT_EQ(after.scene.draws[0].levels[0].orders.size(), 1u);
}

TEST_F(Runner, OrdersWithoutTheirTableAreForgottenToo) {
  Scene scene = two_;
  for (Draw& draw : scene.draws) {
    draw.levels[0].orders.push_back(draw.levels[0].orders[0]);
    draw.levels[0].orders.push_back(draw.levels[0].orders[0]);
  }
  testing::edit<DrawOrders>(scene)->tables.push_back({{0, 1}, {}, 1, 1, {2}});
  const Result kept = run("pairs, reverse-vertices", scene);
  EXPECT_TRUE(kept.scene.products.same(DrawOrders::product, scene.products));
  EXPECT_EQ(kept.scene.draws[1].levels[0].orders.size(), 3u);
  for (const char* stages : {"reverse-draw(only=\"A\")", "double-triangles(only=\"A\")"}) {
    const Result result = run(stages, scene);
    EXPECT_FALSE(result.failed);
    EXPECT_TRUE(order_tables(result.scene).empty()) << stages;
    EXPECT_EQ(result.scene.draws[0].levels[0].orders.size(), 1u) << stages;
    EXPECT_EQ(result.scene.draws[1].levels[0].orders.size(), 1u) << stages;
  }
}

TEST_F(Runner, TellsWhatAStageMade) {
  const Result result = run("two-orders", two_);
  ASSERT_EQ(result.report.stages[0].notes.size(), 2u);
  EXPECT_EQ(result.report.stages[0].notes[0].code, "draw-orders");
  EXPECT_EQ(result.report.stages[0].notes[0].message, "A: 2 x 1 directions; 2 orders of 4 triangles: 48 bytes");
}

TEST_F(Runner, KeepsWhatADrawHadWhereNothingIsToBeGained) {
  const Result result = run("pairs, keeps-everything", two_);
  EXPECT_FALSE(result.failed);
  const Draw& draw = result.scene.draws[0];
  EXPECT_TRUE(traits_of(draw).has(traits::clustered));      // it would break these
  EXPECT_TRUE(traits_of(draw).has(traits::cache_ordered));  // and provide this
  EXPECT_EQ(draw.levels[0].orders[0].cache_size, 48);
  EXPECT_EQ(result.report.stages[1].changed, 0u);
  EXPECT_EQ(result.report.stages[1].skipped[0].reason, "it is best as it is");
}

TEST_F(Runner, GivesTheSameAtAnyThreadCount) {
  std::vector<Draw> draws;
  for (std::uint32_t i = 1; i < 40; ++i)
    draws.push_back(testing::draw_of(testing::soup(i * 5, i), "Soup " + std::to_string(i)));
  const Scene scene = testing::scene_of(std::move(draws));
  const std::string stages = "pairs, reverse-draw, two-orders, reverse-vertices";
  const Result one = run(stages, scene, "count-triangles", 1);
  const Result many = run(stages, scene, "count-triangles", 7);
  expect_same(many, one);
}

TEST_F(Runner, GivesTheSameWithACallersLoop) {
  std::vector<Draw> draws;
  for (std::uint32_t i = 1; i < 40; ++i) draws.push_back(testing::draw_of(testing::soup(i * 5, i)));
  const Scene scene = testing::scene_of(std::move(draws));
  const std::string stages = "pairs, reverse-draw, two-orders, reverse-vertices";
  const Result expected = run(stages, scene, "count-triangles");
  const Executor backwards(1, [](std::size_t count, const std::function<void(std::size_t)>& task) {
    for (std::size_t i = count; i-- > 0;) task(i);
  });
  const Executor on_threads(4, [](std::size_t count, const std::function<void(std::size_t)>& task) {
    std::vector<std::thread> threads;
    for (std::size_t first = 0; first < 4; ++first) {
      threads.emplace_back([&task, first, count] {
        for (std::size_t i = first; i < count; i += 4) task(i);
      });
    }
    for (std::thread& thread : threads) thread.join();
  });
  for (const Executor* executor : {&backwards, &on_threads}) {
    const Result result = run(stages, scene, "count-triangles", *executor);
    expect_same(result, expected);
    EXPECT_EQ(result.report.threads, executor->threads());
  }
}

/// Counts that scatter over the views, so that who wants a small error asks for more of them.
struct ScatteredOverdraw final : OverdrawService {
  OverdrawCounts draw(std::span<const RasterPart> parts, const Views& views, Run&) const override {
    std::vector<OverdrawCount> counts;
    for (std::size_t view = 0; view < views.views.size(); ++view) counts.push_back({10 + view * view % 7, 10, 0});
    return OverdrawCounts(parts.size(), counts);
  }
};

TEST_F(Runner, OnePlanRunsTwiceAtOnce) {
  registry_.add(overdraw_plugin<OverdrawOptions>(
      {.name = "scattered", .summary = "For tests", .reference = "own"}, [](auto&) {},
      [](const OverdrawOptions&) { return std::make_unique<ScatteredOverdraw>(); }));
  Diagnostics diagnostics;
  Pipeline pipeline = *parse_line("pairs, reverse-draw, two-orders, reverse-vertices, add-draw", diagnostics);
  pipeline.measure = *parse_stages("count-triangles, scattered(error=0.02)", "measure", diagnostics);
  const std::optional<Plan> plan = foredraw::plan(pipeline, registry_, two_, diagnostics);
  ASSERT_TRUE(plan) << to_text(diagnostics);
  const Executor executor(2);
  Analyses analyses;
  const auto run = [&] { return foredraw::optimize(*plan, two_, {executor, analyses}); };
  const Result alone = run();
  ASSERT_FALSE(alone.failed);
  ASSERT_NE(alone.report.after.metrics.find("scattered", "ratio"), nullptr);
  std::vector<Result> at_once(2);
  std::vector<std::thread> threads;
  for (Result& result : at_once) threads.emplace_back([&result, &run] { result = run(); });
  for (std::thread& thread : threads) thread.join();
  for (const Result& result : at_once) {
    expect_same(result, alone);
    for (const StateRecord Report::*state : {&Report::before, &Report::after}) {
      const Figure* ratio = (result.report.*state).metrics.find("scattered", "ratio");
      ASSERT_NE(ratio, nullptr);
      EXPECT_EQ(ratio->value(), (alone.report.*state).metrics.find("scattered", "ratio")->value());
    }
  }
}

TEST_F(Runner, ReportsAsJson) {
  Result result = run("reverse-draw", two_, "count-triangles");
  result.report.command = "optimize";
  result.report.after.metrics.set("sight", "poses.root.001@0.5.ratio", {3, 2});
  result.report.after.metrics.set("sight", "shaded-times.1", {7});
  const auto json = nlohmann::json::parse(to_json(result.report));
  EXPECT_EQ(json["report"], report_version);
  EXPECT_EQ(json["totals"]["metrics"]["count-triangles"]["triangles"]["value"], 6);
  EXPECT_EQ(json["totals"]["before"]["metrics"]["count-triangles"]["triangles"]["unit"], "triangles");
  EXPECT_EQ(json["draws"][1]["metrics"]["count-triangles"]["triangles"]["value"], 2);
  EXPECT_EQ(json["stages"][0]["use"], "reverse-draw");
  const auto& sight = json["totals"]["metrics"]["sight"];
  EXPECT_EQ(sight["poses"]["root.001@0.5"]["ratio"]["value"], 1.5);
  EXPECT_EQ(sight["shaded-times"]["1"]["value"], 7);
  // The pipeline in the report runs again.
  Diagnostics diagnostics;
  EXPECT_TRUE(parse_file(json["pipeline"].get<std::string>(), "report", diagnostics));
}

}  // namespace
}  // namespace foredraw

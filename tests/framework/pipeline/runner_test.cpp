// What stages answer is applied, what evaluators measure is booked, and both are told.
#include <foredraw/pipeline/runner.h>

#include "runs_stages.h"
#include "support/edit_product.h"

#include <foredraw/scene/levels.h>
#include <foredraw/scene/order_table.h>

#include <nlohmann/json.hpp>

namespace foredraw::runner_test {
namespace {

class Runner : public testing::RunsStages {};

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

/// How many triangles the scene had that the run began with.
struct CountOriginal final : Evaluator {
  void evaluate(const Scene&, Run& run) const override {
    std::size_t triangles = 0;
    for (const Draw& draw : run.original->draws) triangles += draw.full().stream().triangle_count();
    run.count("triangles", static_cast<double>(triangles));
  }
};

TEST_F(Runner, EvaluatorsSeeTheSceneThatTheRunBeganWith) {
  registry_.add(testing::plugin_of<CountOriginal>(
      Kind::evaluator, {.name = "count-original", .metrics = {{"triangles", "triangles", "Of the original"}}}));
  const Result result = run("add-draw, double-triangles", two_, "count-original, count-triangles");
  ASSERT_FALSE(result.failed);
  EXPECT_EQ(result.report.after.metrics.find("count-triangles", "triangles")->value(), 20);
  EXPECT_EQ(result.report.before.metrics.find("count-original", "triangles")->value(), 6);
  EXPECT_EQ(result.report.after.metrics.find("count-original", "triangles")->value(), 6);
}

/// Fails where it sees more than what it changes.
struct NeedsNoOriginal final : DrawProcessor {
  Draw process(const DrawView& draw, Run& run) const override {
    if (run.original != nullptr) throw std::runtime_error("it sees more than what it is given");
    return draw.draw();
  }
};

TEST_F(Runner, WhatChangesASceneSeesThatAlone) {
  registry_.add(testing::plugin_of<NeedsNoOriginal>(Kind::processor, {.name = "needs-no-original"}));
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
}  // namespace foredraw::runner_test

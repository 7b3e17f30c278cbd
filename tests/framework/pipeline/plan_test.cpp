#include <foredraw/measuring/overdraw_service.h>
#include <foredraw/pipeline/plan.h>

#include "support/meshes.h"
#include "support/test_plugins.h"

#include <foredraw/pipeline/parse.h>

#include <gtest/gtest.h>

namespace foredraw::plan_test {
namespace {

Registry registry() {
  Registry registry;
  testing::add_test_plugins(registry);
  return registry;
}

/// Two draws: a plain one, and one that is blended.
Scene scene() {
  Draw glass = testing::draw_of(testing::grid(2, 2), "Glass");
  glass.traits.add(traits::blended);
  return testing::scene_of({testing::draw_of(testing::grid(3, 3), "Rock"), std::move(glass)});
}

struct Planned {
  std::optional<Plan> plan;
  Diagnostics diagnostics;
  const Registry plugins = registry();

  Planned(const std::string& stages, const Scene& scene, const std::string& measure = "") {
    auto pipeline = parse_line(stages, diagnostics);
    if (pipeline && !measure.empty()) pipeline->measure = *parse_stages(measure, "measure", diagnostics);
    if (pipeline) plan = foredraw::plan(*pipeline, plugins, scene, diagnostics);
  }
  std::vector<std::string> codes() const {
    std::vector<std::string> codes;
    for (const Diagnostic& diagnostic : diagnostics.all()) codes.push_back(diagnostic.code);
    return codes;
  }
};

using Codes = std::vector<std::string>;

TEST(Plan, TellsEveryMistakeAtOnce) {
  const Planned planned("reverse-drow, faulty(fualt=\"throw\"), count-draws, faulty(fault=3)", scene(), "reverse-draw");
  EXPECT_FALSE(planned.plan);
  EXPECT_EQ(planned.codes(), (Codes{"unknown-plugin", "unknown-option", "wrong-list", "bad-option", "wrong-list"}));
  const auto& all = planned.diagnostics.all();
  EXPECT_EQ(all[0].hint, "did you mean 'reverse-draw'?");
  EXPECT_EQ(all[1].hint, "did you mean 'fault'?");
  EXPECT_EQ(all[0].where.column, 1);
  EXPECT_GT(all[1].where.column, 15);
}

TEST(Plan, KeepsTheOrderOfBlendedDrawsUnlessAsked) {
  const Planned planned("reverse-draw", scene());
  ASSERT_TRUE(planned.plan);
  EXPECT_EQ(planned.plan->stages[0].draws, (std::vector<DrawId>{0}));
  ASSERT_EQ(planned.plan->stages[0].skips.size(), 1u);
  EXPECT_EQ(planned.plan->stages[0].skips[0].code, "blended");
  const Planned asked("reverse-draw(blended=true)", scene());
  EXPECT_EQ(asked.plan->stages[0].draws, (std::vector<DrawId>{0, 1}));
}

TEST(Plan, LeavesDrawsWithUnknownExtensionsAlone) {
  Scene extended = scene();
  extended.draws[0].traits.add(traits::extended);
  const Planned planned("reverse-draw, reverse-vertices, pairs", extended);
  for (const PlannedStage& stage : planned.plan->stages) EXPECT_EQ(stage.skips.front().code, "extended");
}

TEST(Plan, RefusesANeedThatNoStageMeetsAndNamesWhoWould) {
  const Planned planned("needs-clusters, pairs", scene());
  EXPECT_FALSE(planned.plan);
  ASSERT_EQ(planned.codes(), (Codes{"needs", "unused"}));
  EXPECT_EQ(planned.diagnostics.all()[0].hint, "put 'pairs' before it, and 'reverse-draw' after it");
}

TEST(Plan, MissesNothingThatAStageWithAMistakeWouldHaveMade) {
  const Planned option("pairs(fast=true), needs-clusters(required=true)", scene());
  EXPECT_EQ(option.codes(), (Codes{"unknown-option"}));
  const Planned name("paris, needs-clusters(required=true)", scene());
  EXPECT_EQ(name.codes(), (Codes{"unknown-plugin"}));
}

TEST(Plan, SkipsDrawsForWhichTheNeedWasNotMet) {
  const Planned planned("pairs(only=\"Rock\"), needs-clusters(blended=true)", scene());
  ASSERT_TRUE(planned.plan);
  EXPECT_EQ(planned.plan->stages[1].draws, (std::vector<DrawId>{0}));
  EXPECT_EQ(planned.plan->stages[1].skips[0].reason, "not clustered");
}

TEST(Plan, WarnsWhereAStageUndoesAnother) {
  const Planned planned("pairs, reverse-draw, needs-clusters", scene());
  ASSERT_TRUE(planned.plan);
  EXPECT_EQ(planned.codes(), (Codes{"undoes"}));
}

TEST(Plan, SkipsWithAReasonUnlessRequired) {
  Scene points = scene();
  for (Draw& draw : points.draws) draw.traits.remove(traits::triangles);
  EXPECT_TRUE(Planned("reverse-draw", points).plan);
  EXPECT_EQ(Planned("reverse-draw(required=true)", points).codes(), (Codes{"required"}));
  EXPECT_EQ(Planned("unavailable(required=true)", scene()).codes(), (Codes{"required"}));
  EXPECT_EQ(Planned("unavailable", scene()).plan->stages[0].left_out, "no such device");
}

TEST(Plan, FollowsOnlyAndEnabled) {
  const Planned planned("reverse-draw(only=\"R*k\"), reverse-draw(enabled=false)", scene());
  ASSERT_EQ(planned.plan->stages.size(), 1u);
  EXPECT_EQ(planned.plan->stages[0].draws, (std::vector<DrawId>{0}));
}

TEST(Plan, WarnsWhereOnlyNamesNothing) {
  const auto told = [](const std::string& stages, Scene of) {
    const Planned planned(stages, std::move(of));
    EXPECT_TRUE(planned.plan);
    return to_text(planned.diagnostics);
  };
  EXPECT_EQ(told("reverse-draw(only=\"Rok\")", scene()),
            "pipeline:1:1: warning: 'reverse-draw' works on nothing: only = \"Rok\" names no draw of test scene\n"
            "    hint: did you mean 'Rock'?\n");
  EXPECT_NE(told("reverse-draw(only=\"Tree_*\")", scene()).find("hint: its draws are called 'Rock', "),
            std::string::npos);
  Scene escaping = scene();
  escaping.draws[0].name = "Ro\x1b[ck";
  EXPECT_EQ(told("reverse-draw(only=\"Ro[ck\")", escaping).find('\x1b'), std::string::npos);
  Scene many = scene();
  many.draws.resize(20, many.draws[0]);
  for (std::size_t i = 0; i < many.draws.size(); ++i) many.draws[i].name = "Stone_" + std::to_string(i);
  EXPECT_NE(told("reverse-draw(only=\"Tree_*\")", many).find("'Stone_7' and so on; * stands for any characters"),
            std::string::npos);
  EXPECT_EQ(told("reverse-draw(only=\"Tree_*\")", {}), "") << "what has no draws has no names";
}

TEST(Plan, FindsAServiceForWhoAsks) {
  EXPECT_TRUE(Planned("ask-overdraw", scene()).plan->overdraw);
  EXPECT_FALSE(Planned("reverse-draw", scene()).plan->overdraw);
}

TEST(Plan, AsksAnExactServiceBeforeOthers) {
  Registry plugins = registry();
  Plugin exact = testing::answer_overdraw();
  exact.card.name = "the-last-of-all";
  exact.exact = true;
  bool is_asked = false;
  exact.overdraw_service = [&is_asked](const Settings& settings) {
    is_asked = true;
    return testing::answer_overdraw().overdraw_service(settings);
  };
  plugins.add(exact);
  Diagnostics diagnostics;
  EXPECT_TRUE(plan(*parse_line("ask-overdraw", diagnostics), plugins, scene(), diagnostics)->overdraw);
  EXPECT_TRUE(is_asked);
}

TEST(Plan, RefusesAServiceThatThisMachineCanNotRun) {
  Registry plugins = registry();
  Plugin gone = testing::answer_overdraw();
  gone.card.name = "gone";
  gone.unavailable = [] { return std::optional<std::string>("no such device"); };
  plugins.add(gone);
  Diagnostics diagnostics;
  Pipeline pipeline = *parse_line("ask-overdraw", diagnostics);
  pipeline.overdraw = Stage{.use = "gone"};
  EXPECT_FALSE(plan(pipeline, plugins, scene(), diagnostics));
  ASSERT_EQ(diagnostics.all().size(), 1u);
  EXPECT_EQ(diagnostics.all()[0].message, "'gone' cannot run on this machine: no such device");
  pipeline.overdraw.reset();
  EXPECT_TRUE(plan(pipeline, plugins, scene(), diagnostics)->overdraw);
}

TEST(Plan, TellsPeopleWhatRunsAndWhatDoesNot) {
  const Scene held = scene();
  const std::string text = to_text(*Planned("pairs, reverse-draw", held, "count-draws").plan, held);
  EXPECT_NE(text.find("pairs: 2 of 2 draws"), std::string::npos) << text;
  EXPECT_NE(text.find("leaves Glass alone: alpha-blended"), std::string::npos) << text;
  EXPECT_NE(text.find("count-draws"), std::string::npos) << text;
}

/// A scene with two clips of a key each, planned with these poses.
Planned with_poses(const PoseSet& poses) {
  Scene animated = scene();
  for (const char* name : {"Walk", "Run"}) {
    AnimationChannel channel;
    channel.times = Shared<float>({0.5f});
    channel.values = Shared<float>({0, 0, 0});
    animated.animations.push_back({name, {channel}});
  }
  Planned planned("", animated);
  Pipeline pipeline;
  pipeline.poses = poses;
  planned.plan = plan(pipeline, planned.plugins, animated, planned.diagnostics);
  return planned;
}

TEST(Plan, MakesThePosesOfTheScene) {
  EXPECT_EQ(with_poses({.poses = "bind"}).plan->poses, rest_pose);
  EXPECT_EQ(with_poses({}).plan->poses, (Poses{{{0, 0.5, 8}, {1, 0.5, 8}}, true}));
  EXPECT_EQ(with_poses({.poses = "all", .clips = "R*"}).plan->poses, (Poses{{{1, 0.5}}}));
  EXPECT_EQ(with_poses({.poses = "64"}).plan->poses, (Poses{{{0, 0.5, 32}, {1, 0.5, 32}}}));
}

TEST(Plan, RefusesPosesThatCanNotBeMadeAndTellsOfThoseThatThereAreNot) {
  const Planned wrong = with_poses({.poses = "al"});
  EXPECT_FALSE(wrong.plan);
  EXPECT_EQ(to_text(wrong.diagnostics), "error: poses: there is no pose set 'al'; did you mean 'all'?\n");
  const Planned none = with_poses({.poses = "all", .clips = "Wlak"});
  EXPECT_TRUE(none.plan);
  EXPECT_EQ(none.codes(), Codes{"at-rest"});
  EXPECT_EQ(none.plan->poses, rest_pose);
}

}  // namespace
}  // namespace foredraw::plan_test

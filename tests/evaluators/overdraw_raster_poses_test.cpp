// Overdraw over the poses of an animation.

#include "../../evaluators/overdraw_raster/overdraw_raster.h"

#include "support/overdraw.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace foredraw::overdraw_raster_poses_test {
namespace {

/// A ball that hangs from a joint and moves into a ring and out on its other side within two seconds; then it stands
/// still.
Scene ball_and_ring() {
  Draw ball = testing::draw_of(testing::sphere(16, 8, 0.5f), "ball");
  Draw ring = testing::draw_of(testing::torus(16, 8), "ring");
  Scene scene = testing::scene_of({std::move(ball), std::move(ring)});
  Node root;
  root.children = {0, 1};
  scene.nodes.push_back(root);
  scene.skins.resize(1);
  scene.skins[0].joints = {2};
  const Shared<float> times({0, 1, 2, 3});
  scene.animations.push_back({"Through",
                              {{0, AnimatedPath::translation, Interpolation::linear, times,
                                Shared<float>({0, -1.5f, 0, 0, 0, 0, 1.2f, 0, 0, 1.2f, 0, 0})}}});
  scene.animations.push_back(
      {"Still",
       {{0, AnimatedPath::scale, Interpolation::step, Shared<float>({0, 5}), Shared<float>({1, 1, 1, 1, 1, 1})}}});
  return scene;
}

Settings with(Settings settings) {
  settings.insert({{"count", std::int64_t{12}}, {"size", std::int64_t{64}}});
  return settings;
}

Findings evaluate(const Scene& scene, const Settings& settings, int threads = 2) {
  return testing::evaluate(overdraw_raster_plugin(), scene, with(settings), threads);
}

const Measured& find(const Findings& findings, const std::string& metric, std::optional<DrawId> draw = {}) {
  for (const Measured& measured : findings.measured) {
    if (measured.metric == metric && measured.about.draw == draw) return measured;
  }
  throw std::out_of_range(metric);
}

const Settings all = {{"poses", std::string("all")}};

/// The scene with the ball there to stay.
Scene stopped(glm::vec3 at) {
  Scene scene = ball_and_ring();
  scene.nodes[0].transform.translation = at;
  scene.animations.clear();
  return scene;
}

TEST(OverdrawPoses, figures_are_the_sums_over_scenes_that_stand_like_that) {
  const Findings moved = evaluate(ball_and_ring(), all);
  // Keys at 0, 1, 2, 3 (as 2), and of the other clip 0 and 5 (at rest, as at 1).
  std::vector<Findings> poses;
  for (const glm::vec3 at : {glm::vec3(0, -1.5f, 0), glm::vec3(0), glm::vec3(1.2f, 0, 0), glm::vec3(1.2f, 0, 0),
                             glm::vec3(0), glm::vec3(0)}) {
    poses.push_back(evaluate(stopped(at), {}));
  }
  for (const std::optional<DrawId> draw :
       {std::optional<DrawId>(), std::optional<DrawId>(0), std::optional<DrawId>(1)}) {
    for (const char* metric : {"ratio", "view-mean"}) {
      double numerator = 0;
      double denominator = 0;
      for (const Findings& pose : poses) {
        numerator += find(pose, metric, draw).numerator;
        denominator += *find(pose, metric, draw).denominator;
      }
      EXPECT_DOUBLE_EQ(find(moved, metric, draw).numerator, numerator) << metric;
      EXPECT_EQ(find(moved, metric, draw).denominator, denominator) << metric;
    }
    double hidden = 0;
    double worst = 0;
    for (const Findings& pose : poses) {
      hidden += find(pose, "hidden", draw).numerator;
      const Measured& view = find(pose, "worst-view", draw);
      worst = std::max(worst, view.numerator / *view.denominator);
    }
    EXPECT_EQ(find(moved, "hidden", draw).numerator, hidden);
    EXPECT_EQ(find(moved, "worst-view", draw).numerator / *find(moved, "worst-view", draw).denominator, worst);
  }
  EXPECT_GT(find(moved, "hidden").numerator, 1000);
  const char* names[] = {"Through@0", "Through@1", "Through@2", "Through@3", "Still@0", "Still@5"};
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Measured& told = find(moved, std::string("poses.") + names[i] + ".ratio");
    EXPECT_EQ(told.numerator, find(poses[i], "ratio").numerator);
    EXPECT_EQ(told.denominator, find(poses[i], "ratio").denominator);
    EXPECT_EQ(told.error, find(poses[i], "ratio").error);
  }
}

TEST(OverdrawPoses, a_scene_without_clips_is_at_rest_and_tells_of_no_poses) {
  const Findings findings = evaluate(stopped({}), all);
  for (const Measured& measured : findings.measured) EXPECT_FALSE(measured.metric.starts_with("poses."));
  EXPECT_TRUE(findings.notes.empty());
}

TEST(OverdrawPoses, the_worst_pose_is_told) {
  const Findings findings = evaluate(ball_and_ring(), all);
  std::string worst;
  double highest = 0;
  for (const Measured& measured : findings.measured) {
    if (!measured.metric.starts_with("poses.")) continue;
    const double ratio = measured.numerator / *measured.denominator;
    if (ratio > highest) {
      highest = ratio;
      worst = measured.metric.substr(6, measured.metric.rfind('.') - 6);
    }
  }
  ASSERT_EQ(findings.notes.size(), 1u);
  EXPECT_EQ(findings.notes[0].code, "worst-pose");
  EXPECT_TRUE(
      findings.notes[0].message.starts_with("measured in 6 poses (3 different); the worst is " + worst + ", with "))
      << findings.notes[0].message;
}

TEST(OverdrawPoses, sixteen_are_looked_at_and_up_to_64_are_told_one_by_one) {
  const auto told = [](const Settings& settings) {
    const Findings findings = evaluate(ball_and_ring(), settings);
    return std::ranges::count_if(findings.measured, [](const Measured& m) { return m.metric.starts_with("poses."); });
  };
  EXPECT_EQ(told({}), 16);
  EXPECT_EQ(told({{"poses", std::string("64")}}), 64);
  EXPECT_EQ(told({{"poses", std::string("65")}}), 0);
  EXPECT_EQ(evaluate(ball_and_ring(), {{"poses", std::string("65")}}).notes[0].code, "worst-pose");
  EXPECT_EQ(told({{"poses", std::string("bind")}}), 0);
}

TEST(OverdrawPoses, figures_are_the_same_at_any_number_of_threads) {
  const Settings settings = {{"poses", std::string("40")}, {"distance", 3.0}};
  const Findings one = evaluate(ball_and_ring(), settings, 1);
  const Findings many = evaluate(ball_and_ring(), settings, 5);
  ASSERT_EQ(one.measured.size(), many.measured.size());
  for (std::size_t i = 0; i < one.measured.size(); ++i) {
    EXPECT_EQ(one.measured[i].metric, many.measured[i].metric);
    EXPECT_EQ(one.measured[i].numerator, many.measured[i].numerator);
    EXPECT_EQ(one.measured[i].denominator, many.measured[i].denominator);
    EXPECT_EQ(one.measured[i].error, many.measured[i].error);
  }
}

TEST(OverdrawPoses, a_wanted_error_is_of_the_sum_over_the_poses) {
  const Findings findings = evaluate(ball_and_ring(), {{"poses", std::string("3")}, {"error", 0.01}});
  EXPECT_GT(find(findings, "ratio").error, 0);
  EXPECT_LE(find(findings, "ratio").error, 0.01);
}

TEST(OverdrawPoses, details_are_of_all_poses) {
  Settings settings = all;
  settings["details"] = true;
  const Findings findings = evaluate(ball_and_ring(), settings);
  double pixels = 0;
  double shaded = 0;
  for (int times = 1; times <= 8; ++times) {
    const double count = find(findings, "shaded-times." + std::to_string(times)).numerator;
    pixels += count;
    shaded += times * count;
  }
  EXPECT_EQ(pixels, *find(findings, "ratio").denominator);
  EXPECT_EQ(shaded, find(findings, "ratio").numerator);
}

TEST(OverdrawPoses, an_animated_scene_that_is_looked_at_at_rest_says_why) {
  const Findings findings = evaluate(ball_and_ring(), {{"clips", std::string("Trough")}});
  ASSERT_EQ(findings.notes.size(), 1u);
  EXPECT_EQ(findings.notes[0].message, "drawn at rest: no clip with keys is called 'Trough'; did you mean 'Through'?");
  EXPECT_EQ(find(findings, "ratio").numerator, find(evaluate(stopped({}), {}), "ratio").numerator);
}

TEST(OverdrawPoses, broken_poses_are_left_out_and_counted_once) {
  Scene scene = ball_and_ring();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  scene.animations[0].channels[0].values = Shared<float>({0, 0, 0, nan, 0, 0, 0, 0, 0, 0, 0, 0});
  const Findings findings = evaluate(scene, all);
  const double triangles = static_cast<double>(scene.draws[0].levels[0].orders[0].triangle_count());
  EXPECT_EQ(find(findings, "triangles-left-out").numerator, triangles);
  // Nothing but a point is left of the ball.
  scene.animations[0].channels[0] = {0, AnimatedPath::scale, Interpolation::linear, Shared<float>({0}),
                                     Shared<float>({0, 0, 0})};
  EXPECT_GT(find(evaluate(scene, all), "ratio").numerator, 0);
}

TEST(OverdrawPoses, sets_that_can_not_be_made_are_refused) {
  const Plugin plugin = overdraw_raster_plugin();
  EXPECT_THROW(plugin.create({{"poses", std::string("al")}}), std::invalid_argument);
  EXPECT_THROW(plugin.create({{"rate", 30.0}, {"moments", std::string("1")}}), std::invalid_argument);
  EXPECT_NO_THROW(plugin.create({{"rate", 30.0}}));
}

}  // namespace
}  // namespace foredraw::overdraw_raster_poses_test

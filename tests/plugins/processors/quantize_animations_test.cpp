// Keys rounded and left out: never farther off than asked for, and the animation lasts as long.
#include "plugins/processors/quantize/rounded_animations.h"

#include "support/meshes.h"
#include "support/staged.h"

#include <foredraw/io/gltf/gltf.h>
#include <foredraw/viewing/pose_set.h>
#include <foredraw/viewing/posed_positions.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace foredraw::quantize_animations_test {
namespace {

using ::testing::ElementsAre;
using Path = AnimatedPath;

AnimationChannel channel(Path path, std::vector<float> times, std::vector<float> values,
                         Interpolation interpolation = Interpolation::linear) {
  return {0, path, interpolation, Shared<float>(std::move(times)), Shared<float>(std::move(values))};
}

std::vector<float> list(const Shared<float>& values) { return {values.view().begin(), values.view().end()}; }

/// A turn about z by so many degrees.
std::vector<float> turn(double degrees) {
  const double half = degrees * 3.14159265358979 / 360;
  return {0, 0, static_cast<float>(std::sin(half)), static_cast<float>(std::cos(half))};
}

AnimationChannel turning(int keys, double degrees_a_key) {
  std::vector<float> times, values;
  for (int k = 0; k < keys; ++k) {
    times.push_back(static_cast<float>(k) / 16);
    for (const float part : turn(k * degrees_a_key)) values.push_back(part);
  }
  return channel(Path::rotation, times, values);
}

constexpr KeyTolerances usual{.001, .1, .001};
constexpr double unit[] = {1};  // of the only node

TEST(QuantizeAnimations, WhatGoesStraightKeepsItsEnds) {
  std::vector<float> times, values;
  for (int k = 0; k <= 100; ++k) {
    times.push_back(static_cast<float>(k));
    values.insert(values.end(), {static_cast<float>(k) * .01f, 0, 0});
  }
  const RoundedAnimation made = rounded({"", {channel(Path::translation, times, values)}}, usual, unit);
  EXPECT_THAT(list(made.animation.channels[0].times), ElementsAre(0, 100));
  EXPECT_EQ(made.keys_before, 101u);
  EXPECT_EQ(made.keys_after, 2u);
  EXPECT_LE(made.largest.translation, usual.translation);
}

TEST(QuantizeAnimations, AnEvenTurnKeepsAsManyKeysAsItHasHalfTurns) {
  const RoundedAnimation made = rounded({"", {turning(200, 5)}}, usual, unit);  // 995 degrees
  EXPECT_LE(made.keys_after, 9u);
  EXPECT_GE(made.keys_after, 6u);
  EXPECT_LE(made.largest.rotation, usual.rotation);
}

TEST(QuantizeAnimations, CornersStay) {
  const RoundedAnimation made = rounded(
      {"", {channel(Path::translation, {0, 1, 2, 3, 4}, {0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0})}}, usual, unit);
  EXPECT_EQ(made.keys_after, 5u);
}

TEST(QuantizeAnimations, WhatStandsStillKeepsOneKeyButTheEndOfTheAnimationStays) {
  const std::vector<float> times{0, 1, 2}, still{1, 1, 1, 1, 1, 1, 1, 1, 1};
  const AnimationChannel stands = channel(Path::scale, times, still);
  const RoundedAnimation alone = rounded({"", {stands, stands}}, usual, unit);
  EXPECT_THAT(list(alone.animation.channels[0].times), ElementsAre(0, 2));
  EXPECT_THAT(list(alone.animation.channels[1].times), ElementsAre(0));
  const RoundedAnimation beside = rounded({"", {stands, turning(33, 3)}}, usual, unit);
  EXPECT_THAT(list(beside.animation.channels[0].times), ElementsAre(0));
  EXPECT_EQ(list(beside.animation.channels[1].times).back(), 2);
}

TEST(QuantizeAnimations, ChannelsWithTheSameTimesKeepTheSameKeys) {
  const std::vector<float> times{0, 1, 2, 3, 4};
  const AnimationChannel straight = channel(Path::translation, times, {0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0});
  const AnimationChannel bent = channel(Path::scale, times, {1, 1, 1, 1, 1, 1, 2, 1, 1, 1, 1, 1, 1, 1, 1});
  const RoundedAnimation made = rounded({"", {straight, bent}}, usual, unit);
  EXPECT_EQ(list(made.animation.channels[0].times), list(made.animation.channels[1].times));
  EXPECT_EQ(list(made.animation.channels[0].times), (std::vector<float>{0, 1, 2, 3, 4}));
}

TEST(QuantizeAnimations, StepsKeepWhereTheyStep) {
  const RoundedAnimation made = rounded({"",
                                         {channel(Path::translation, {0, 1, 2, 3, 4},
                                                  {0, 0, 0, 0, 0, 0, 5, 0, 0, 5, 0, 0, 0, 0, 0}, Interpolation::step)}},
                                        usual, unit);
  EXPECT_THAT(list(made.animation.channels[0].times), ElementsAre(0, 2, 4));
}

TEST(QuantizeAnimations, OddChannelsStayAsTheyAre) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<AnimationChannel> odd{
      channel(Path::translation, {0, 1}, {nan, 0, 0, 0, 0, 0}),
      channel(Path::translation, {0, 1}, {1e30f, 0, 0, 0, 0, 0}),
      channel(Path::translation, {0, 1}, std::vector<float>(18, .1f), Interpolation::cubic_spline),
      channel(Path::weights, {0, 1}, {.1f, .2f}),
      channel(Path::translation, {}, {}),
      channel(Path::rotation, {0, nan}, {0, 0, 0, 1, 0, 0, 0, 1}),
      channel(Path::scale, {0, 1}, {1}),
  };
  const RoundedAnimation made = rounded({"", odd}, usual, unit);
  for (std::size_t c = 0; c < odd.size(); ++c) {
    EXPECT_EQ(made.animation.channels[c].times.stamp(), odd[c].times.stamp()) << c;
    EXPECT_EQ(made.animation.channels[c].values.stamp(), odd[c].values.stamp()) << c;
  }
}

TEST(QuantizeAnimations, EqualTimesAndQuaternionsOfNoLengthDoNoHarm) {
  const RoundedAnimation made = rounded({"",
                                         {channel(Path::rotation, {0, 0, 0, 1}, std::vector<float>(16, 0)),
                                          channel(Path::translation, {1, 1, 1}, {0, 0, 0, 1, 0, 0, 0, 0, 0})}},
                                        usual, unit);
  EXPECT_LE(made.largest.rotation, usual.rotation);
  EXPECT_LE(made.largest.translation, usual.translation);
}

TEST(QuantizeAnimations, ATranslationIsRoundedByItsLengthInTheWorld) {
  const auto made = [](double scale_above) {
    const double units[] = {scale_above};
    return rounded({"", {channel(Path::translation, {0, 1}, {0, 0, 0, .123456f, .2f, .3f})}}, usual, units);
  };
  EXPECT_LE(made(1).largest.translation, usual.translation);
  EXPECT_GT(made(1).largest.translation, usual.translation / 8);
  EXPECT_LE(made(1000).largest.translation, usual.translation);
  EXPECT_NEAR(list(made(1000).animation.channels[0].values)[3], .123456f, usual.translation / 1000);
  EXPECT_EQ(list(made(.0001).animation.channels[0].values).back(), 0.0f) << "a tenth of the tolerance";
  EXPECT_EQ(list(made(0).animation.channels[0].values)[3], .123456f);
}

/// A node of a thousandth's size above, which an animation makes as large as it was; a draw of 1000 units.
TEST(QuantizeAnimations, ScalesOfNodesCountAtTheirLargest) {
  Scene scene = testing::scene_of(testing::sphere(8, 8, 500));
  scene.nodes[0].name = "moved";
  scene.nodes.push_back(
      Node{.name = "above", .transform = {{0, 0, 0}, glm::quat(1, 0, 0, 0), {.001f, .001f, .001f}}, .children = {0}});
  scene.animations.push_back({"grow",
                              {{1, Path::scale, Interpolation::linear, Shared<float>({0.0f, 1.0f}),
                                Shared<float>({.001f, .001f, .001f, 1.0f, 1.0f, 1.0f})},
                               {0, Path::translation, Interpolation::linear, Shared<float>({0.0f, 1.0f}),
                                Shared<float>({0.0f, 0.0f, 0.0f, .0123456f, 0.0f, 0.0f})}}});
  const Result result = testing::run("quantize", scene);
  const double at_rest = 3e-5 * std::sqrt(3.0);  // the diagonal is a thousandth of 1000 * sqrt(3)
  EXPECT_NEAR(result.scene.animations[0].channels[1].values.view()[3], .0123456f, at_rest);
}

void expect_moves_as_it_did(const std::string& model) {
  Diagnostics diagnostics;
  const auto scene = read_gltf(testing::project_file("benchmarks/corpus/animated/" + model), diagnostics);
  ASSERT_TRUE(scene) << to_text(diagnostics);
  const Result result = testing::run("quantize", *scene);
  ASSERT_FALSE(result.failed);
  const auto files = encode_gltf(result.scene, "out.glb", diagnostics, {.compression = Compression::khr});
  ASSERT_TRUE(files) << to_text(diagnostics);
  const auto again = read_gltf(files->front().bytes, "out.glb", {}, diagnostics);
  ASSERT_TRUE(again) << to_text(diagnostics);
  const Poses poses = make_poses(*scene, {.poses = "9"});
  double farthest = 0, size = 0;
  for (DrawId draw = 0; draw < scene->draws.size(); ++draw) {
    const auto part = shown_part(*scene, draw), part_again = shown_part(*again, draw);
    ASSERT_EQ(part.has_value(), part_again.has_value());
    EXPECT_EQ(again->draws[draw].full().vertices->find("POSITION")->format.component, Component::uint16);
    if (!part) continue;
    for (const Pose& pose : poses.poses) {
      const auto was = posed_positions(*scene, *part, posed_nodes(*scene, pose));
      const auto is = posed_positions(*again, *part_again, posed_nodes(*again, pose));
      ASSERT_EQ(was.size(), is.size());
      for (std::size_t v = 0; v < was.size(); ++v) {
        farthest = std::max(farthest, static_cast<double>(glm::length(was[v] - is[v])));
        size = std::max(size, static_cast<double>(glm::length(was[v] - was[0])));
      }
    }
  }
  EXPECT_GT(farthest, 0);
  EXPECT_LT(farthest, .002 * size);
  for (std::size_t a = 0; a < again->animations.size(); ++a) {
    for (std::size_t c = 0; c < again->animations[a].channels.size(); ++c) {
      EXPECT_EQ(again->animations[a].channels[c].values, result.scene.animations[a].channels[c].values) << c;
    }
  }
}

TEST(QuantizeAnimations, CharactersMoveAsTheyDid) {
  for (const char* model : {"cesium_man_notex.glb", "fox.glb", "robot_expressive.glb", "mannequiny.glb"}) {
    SCOPED_TRACE(model);
    expect_moves_as_it_did(model);
  }
}

}  // namespace
}  // namespace foredraw::quantize_animations_test

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

namespace foredraw {
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

TEST(QuantizeAnimations, WhatGoesStraightKeepsItsEnds) {
  std::vector<float> times, values;
  for (int k = 0; k <= 100; ++k) {
    times.push_back(static_cast<float>(k));
    values.insert(values.end(), {static_cast<float>(k) * .01f, 0, 0});
  }
  const RoundedAnimation made = rounded({"", {channel(Path::translation, times, values)}}, usual);
  EXPECT_THAT(list(made.animation.channels[0].times), ElementsAre(0, 100));
  EXPECT_EQ(made.keys_before, 101u);
  EXPECT_EQ(made.keys_after, 2u);
  EXPECT_LE(made.largest.translation, usual.translation);
}

TEST(QuantizeAnimations, AnEvenTurnKeepsAsManyKeysAsItHasHalfTurns) {
  const RoundedAnimation made = rounded({"", {turning(200, 5)}}, usual);  // 995 degrees
  EXPECT_LE(made.keys_after, 9u);
  EXPECT_GE(made.keys_after, 6u);
  EXPECT_LE(made.largest.rotation, usual.rotation);
}

TEST(QuantizeAnimations, CornersStay) {
  const RoundedAnimation made = rounded(
      {"", {channel(Path::translation, {0, 1, 2, 3, 4}, {0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0})}}, usual);
  EXPECT_EQ(made.keys_after, 5u);
}

TEST(QuantizeAnimations, WhatStandsStillKeepsOneKeyButTheEndOfTheAnimationStays) {
  const std::vector<float> times{0, 1, 2}, still{1, 1, 1, 1, 1, 1, 1, 1, 1};
  const AnimationChannel stands = channel(Path::scale, times, still);
  const RoundedAnimation alone = rounded({"", {stands, stands}}, usual);
  EXPECT_THAT(list(alone.animation.channels[0].times), ElementsAre(0, 2));
  EXPECT_THAT(list(alone.animation.channels[1].times), ElementsAre(0));
  const RoundedAnimation beside = rounded({"", {stands, turning(33, 3)}}, usual);
  EXPECT_THAT(list(beside.animation.channels[0].times), ElementsAre(0));
  EXPECT_EQ(list(beside.animation.channels[1].times).back(), 2);
}

TEST(QuantizeAnimations, ChannelsWithTheSameTimesKeepTheSameKeys) {
  const std::vector<float> times{0, 1, 2, 3, 4};
  const AnimationChannel straight = channel(Path::translation, times, {0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0});
  const AnimationChannel bent = channel(Path::scale, times, {1, 1, 1, 1, 1, 1, 2, 1, 1, 1, 1, 1, 1, 1, 1});
  const RoundedAnimation made = rounded({"", {straight, bent}}, usual);
  EXPECT_EQ(list(made.animation.channels[0].times), list(made.animation.channels[1].times));
  EXPECT_EQ(list(made.animation.channels[0].times), (std::vector<float>{0, 1, 2, 3, 4}));
}

TEST(QuantizeAnimations, StepsKeepWhereTheyStep) {
  const RoundedAnimation made = rounded({"",
                                         {channel(Path::translation, {0, 1, 2, 3, 4},
                                                  {0, 0, 0, 0, 0, 0, 5, 0, 0, 5, 0, 0, 0, 0, 0}, Interpolation::step)}},
                                        usual);
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
  const RoundedAnimation made = rounded({"", odd}, usual);
  for (std::size_t c = 0; c < odd.size(); ++c) {
    EXPECT_EQ(made.animation.channels[c].times.stamp(), odd[c].times.stamp()) << c;
    EXPECT_EQ(made.animation.channels[c].values.stamp(), odd[c].values.stamp()) << c;
  }
}

TEST(QuantizeAnimations, EqualTimesAndQuaternionsOfNoLengthDoNoHarm) {
  const RoundedAnimation made = rounded({"",
                                         {channel(Path::rotation, {0, 0, 0, 1}, std::vector<float>(16, 0)),
                                          channel(Path::translation, {1, 1, 1}, {0, 0, 0, 1, 0, 0, 0, 0, 0})}},
                                        usual);
  EXPECT_LE(made.largest.rotation, usual.rotation);
  EXPECT_LE(made.largest.translation, usual.translation);
}

TEST(QuantizeAnimations, ACharacterMovesAsItDid) {
  Diagnostics diagnostics;
  const auto scene = read_gltf(testing::project_file("benchmarks/corpus/animated/cesium_man_notex.glb"), diagnostics);
  ASSERT_TRUE(scene) << to_text(diagnostics);
  const Result result = testing::run("quantize", *scene);
  ASSERT_FALSE(result.failed);
  const auto files = encode_gltf(result.scene, "out.glb", diagnostics, {.compression = Compression::khr});
  ASSERT_TRUE(files) << to_text(diagnostics);
  const auto again = read_gltf(files->front().bytes, "out.glb", {}, diagnostics);
  ASSERT_TRUE(again) << to_text(diagnostics);
  const Poses poses = make_poses(*scene, {.poses = "9"});
  const SubjectPart part = *shown_part(*scene, 0);
  double farthest = 0, size = 0;
  for (const Pose& pose : poses.poses) {
    const auto was = posed_positions(*scene, part, posed_nodes(*scene, pose));
    const auto is = posed_positions(*again, part, posed_nodes(*again, pose));
    ASSERT_EQ(was.size(), is.size());
    for (std::size_t v = 0; v < was.size(); ++v) {
      farthest = std::max(farthest, static_cast<double>(glm::length(was[v] - is[v])));
      size = std::max(size, static_cast<double>(glm::length(was[v] - was[0])));
    }
  }
  EXPECT_GT(farthest, 0);
  EXPECT_LT(farthest, .002 * size);
  for (std::size_t c = 0; c < again->animations[0].channels.size(); ++c) {
    EXPECT_EQ(again->animations[0].channels[c].values, result.scene.animations[0].channels[c].values) << c;
  }
}

}  // namespace
}  // namespace foredraw

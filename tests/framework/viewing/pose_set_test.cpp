#include <foredraw/viewing/pose_set.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace foredraw::pose_set_test {
namespace {

using Keys = std::vector<float>;

/// One channel for each list of keys.
Animation clip(std::string name, const std::vector<Keys>& channels) {
  Animation animation;
  animation.name = std::move(name);
  for (const Keys& keys : channels) {
    AnimationChannel channel;
    channel.times = Shared<float>(keys);
    channel.values = Shared<float>(std::vector<float>(3 * keys.size()));
    animation.channels.push_back(std::move(channel));
  }
  return animation;
}

Scene scene_with(std::vector<Animation> animations) {
  Scene scene;
  scene.nodes.resize(1);
  scene.animations = std::move(animations);
  return scene;
}

/// "Walk@0 Walk@1 Idle@0*3", with the weight where it is not 1.
std::string told(const Scene& scene, const PoseSet& set) {
  std::string text;
  for (const Pose& pose : make_poses(scene, set).poses) {
    text += (text.empty() ? "" : " ") + pose_name(pose, clip_names(scene));
    if (pose.weight != 1) text += "*" + std::to_string(static_cast<int>(pose.weight));
  }
  return text;
}

PoseSet poses(std::string words) { return {.poses = std::move(words)}; }

Scene walk_and_jump() { return scene_with({clip("Walk", {{0, 0.5f, 1}, {0, 0.25f}}), clip("Jump", {{2, 3}})}); }

TEST(PoseSet, bind_is_how_the_nodes_stand) {
  EXPECT_EQ(told(walk_and_jump(), poses("bind")), "rest");
  EXPECT_EQ(make_poses(walk_and_jump(), poses("bind")), rest_pose);
}

TEST(PoseSet, by_default_sixteen_share_the_views_and_are_none_of_sixteen) {
  const Poses automatic = make_poses(walk_and_jump(), PoseSet());
  const Poses sixteen = make_poses(walk_and_jump(), poses("16"));
  EXPECT_EQ(automatic.poses.size(), 16u);
  EXPECT_TRUE(automatic.share_views);
  EXPECT_FALSE(sixteen.share_views);
  for (const Pose& pose : automatic.poses) EXPECT_EQ(std::ranges::count(sixteen.poses, pose), 0) << pose.time;
  EXPECT_EQ(make_poses(Scene(), PoseSet()), rest_pose);
}

TEST(PoseSet, all_are_the_keys_of_all_channels_of_each_clip) {
  EXPECT_EQ(told(walk_and_jump(), poses("all")), "Walk@0 Walk@0.25 Walk@0.5 Walk@1 Jump@2 Jump@3");
}

TEST(PoseSet, a_rate_takes_frames_from_the_first_key_to_the_last) {
  EXPECT_EQ(told(walk_and_jump(), {.poses = "all", .rate = 2}), "Walk@0 Walk@0.5 Walk@1 Jump@2 Jump@2.5 Jump@3");
  EXPECT_EQ(told(walk_and_jump(), {.poses = "64", .rate = 1.5}), "Walk@0 Walk@0.666667 Jump@2 Jump@2.66667");
  EXPECT_EQ(told(walk_and_jump(), {.poses = "bind", .rate = 0.1}), "Walk@0 Jump@2");
  // A second in floats at 30 frames a second has 31 of them.
  const Scene baked = scene_with({clip("Run", {{0.1f, 0.1f + 1}})});
  EXPECT_EQ(make_poses(baked, {.poses = "all", .rate = 30}).poses.size(), 31u);
}

TEST(PoseSet, moments_are_taken_from_the_clips_that_last_for_them) {
  EXPECT_EQ(told(walk_and_jump(), {.poses = "all", .moments = "3 0.1  1 2.5 1"}), "Walk@0.1 Walk@1 Jump@2.5 Jump@3");
  EXPECT_EQ(told(walk_and_jump(), {.moments = "77"}), "rest");
}

TEST(PoseSet, a_number_is_spread_evenly_over_the_clips) {
  const Scene scene = scene_with({clip("Short", {{1, 2}}), clip("Long", {{0, 1, 3}}), clip("Still", {{5}})});
  EXPECT_EQ(told(scene, poses("3")), "Short@1.5 Long@1.5 Still@5");
  EXPECT_EQ(told(scene, poses("4")), "Short@1.5 Long@0.75 Long@2.25 Still@5");
  EXPECT_EQ(told(scene, poses("5")), "Short@1.25 Short@1.75 Long@0.75 Long@2.25 Still@5");
  EXPECT_EQ(told(scene, poses("7")), "Short@1.25 Short@1.75 Long@0.5 Long@1.5 Long@2.5 Still@5*2");
  EXPECT_EQ(told(scene, poses("1")), "Long@1.5");
  EXPECT_EQ(told(scene, poses("2")), "Short@1.5 Still@5");
  for (int count = 1; count < 100; ++count) {
    double weights = 0;
    for (const Pose& pose : make_poses(scene, poses(std::to_string(count))).poses) weights += pose.weight;
    EXPECT_EQ(weights, count);
  }
}

TEST(PoseSet, clips_are_chosen_by_name) {
  const Scene scene = scene_with({clip("Walk", {{0}}), clip("Run", {{0}}), clip("", {{0}}), clip("Walk", {{1}})});
  EXPECT_EQ(told(scene, {.poses = "all", .clips = "W*"}), "Walk@0 Walk#2@1");
  EXPECT_EQ(told(scene, {.poses = "all", .clips = "Walk"}), "Walk@0 Walk#2@1");
  EXPECT_EQ(told(scene, {.poses = "all", .clips = "Walk#2"}), "Walk#2@1");
  EXPECT_EQ(told(scene, {.poses = "all", .clips = "?un"}), "Run@0");
  EXPECT_EQ(told(scene, {.poses = "64", .clips = "animation2"}), "animation2@0*64");
}

TEST(PoseSet, clips_without_keys_have_no_poses) {
  Scene scene = scene_with({clip("Empty", {}), clip("NoKeys", {{}}), clip("Walk", {{0}})});
  AnimationChannel too_short;
  too_short.times = Shared<float>(Keys{0, 1, 2});
  too_short.values = Shared<float>(Keys{0, 0, 0});
  scene.animations.push_back({"TooShort", {too_short}});
  scene.animations.push_back(clip("NoTime", {{std::numeric_limits<float>::quiet_NaN()}}));
  EXPECT_EQ(told(scene, poses("all")), "Walk@0");
  EXPECT_EQ(told(scene_with({clip("Empty", {})}), poses("all")), "rest");
  EXPECT_EQ(told(Scene(), poses("64")), "rest");
}

TEST(PoseSet, says_why_an_animated_scene_is_at_rest) {
  const Scene scene = walk_and_jump();
  EXPECT_EQ(why_at_rest(scene, {.poses = "64", .clips = "Wlak"}),
            "no clip with keys is called 'Wlak'; did you mean 'Walk'?");
  EXPECT_EQ(why_at_rest(scene, {.poses = "64", .clips = "Swimming*"}),
            "no clip with keys is called 'Swimming*'; there are Walk, Jump");
  EXPECT_EQ(why_at_rest(scene, {.poses = "all", .moments = "77"}), "no clip lasts for any of the moments 77");
  EXPECT_FALSE(why_at_rest(scene, poses("64")));
  EXPECT_FALSE(why_at_rest(scene, PoseSet()));
  EXPECT_FALSE(why_at_rest(Scene(), {.poses = "64", .clips = "Wlak"}));
}

TEST(PoseSet, mistakes_are_told) {
  const auto mistake = [](const PoseSet& set) { return mistake_in(set).value_or("none"); };
  EXPECT_EQ(mistake(poses("al")), "there is no pose set 'al'; did you mean 'all'?");
  EXPECT_EQ(mistake(poses("keyframes")), "there is no pose set 'keyframes'; expected auto, all, bind or a number");
  EXPECT_EQ(mistake(poses("0")), "poses is 0, but must be 1 to 100000");
  EXPECT_EQ(mistake(poses("100001")), "poses is 100001, but must be 1 to 100000");
  EXPECT_EQ(mistake(poses("-3")), "poses is -3, but must be 1 to 100000");
  EXPECT_EQ(mistake({.poses = "all", .rate = 30, .moments = "1"}),
            "rate and moments both choose the poses; leave one of them out");
  EXPECT_EQ(mistake({.poses = "all", .rate = -1}), "rate is -1.000000, but must be above 0 poses a second");
  for (const char* times : {"now", "1 x", "-1", "1,2", "nan", "inf", "1e999"}) {
    EXPECT_EQ(mistake({.poses = "all", .moments = times}),
              std::string("moments is '") + times + "', but must be seconds such as '0 0.5 2'");
  }
  EXPECT_EQ(mistake({.clips = ""}), "clips is empty; leave it out, or name some, with * and ?");
  EXPECT_EQ(mistake(PoseSet()), "none");
  EXPECT_EQ(mistake({.poses = "all", .moments = " 0 1.5 "}), "none");
  EXPECT_THROW(make_poses(Scene(), poses("al")), std::invalid_argument);
}

TEST(PoseSet, more_poses_than_anybody_draws_are_refused) {
  const Scene scene = scene_with({clip("Ages", {{0, std::numeric_limits<float>::max()}})});
  EXPECT_THROW(make_poses(scene, {.poses = "all", .rate = 30}), std::invalid_argument);
  EXPECT_EQ(make_poses(scene, poses("64")).poses.size(), 64u);
  EXPECT_EQ(make_poses(scene, poses("all")).poses.size(), 2u);
}

}  // namespace
}  // namespace foredraw::pose_set_test

#include <foredraw/viewing/animation.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace foredraw::viewing_animation_test {
namespace {

using Floats = std::vector<float>;

AnimationChannel channel(NodeId node, AnimatedPath path, Interpolation interpolation, Floats times, Floats values) {
  return {node, path, interpolation, Shared<float>(std::move(times)), Shared<float>(std::move(values))};
}

Scene scene_with(std::size_t nodes, std::vector<AnimationChannel> channels) {
  Scene scene;
  scene.nodes.resize(nodes);
  scene.animations.push_back({"clip", std::move(channels)});
  return scene;
}

glm::vec3 at(const Scene& scene, double time, NodeId node = 0, glm::vec3 point = glm::vec3(0)) {
  return glm::vec3(posed_nodes(scene, {0, time}).world[node] * glm::vec4(point, 1));
}

void expect_near(glm::vec3 a, glm::vec3 b) { EXPECT_LT(glm::length(a - b), 1e-6f) << a.x << ' ' << a.y << ' ' << a.z; }

constexpr float half = 0.70710678f;

TEST(Animation, is_linear_between_keys_and_stands_still_outside_of_them) {
  const Scene scene = scene_with(
      1, {channel(0, AnimatedPath::translation, Interpolation::linear, {1, 2, 4}, {0, 0, 0, 4, 0, 0, 4, 8, 0})});
  EXPECT_EQ(at(scene, 0), glm::vec3(0));
  EXPECT_EQ(at(scene, 1), glm::vec3(0));
  EXPECT_EQ(at(scene, 1.25), glm::vec3(1, 0, 0));
  EXPECT_EQ(at(scene, 2), glm::vec3(4, 0, 0));
  EXPECT_EQ(at(scene, 3.5), glm::vec3(4, 6, 0));
  EXPECT_EQ(at(scene, 4), glm::vec3(4, 8, 0));
  EXPECT_EQ(at(scene, 99), glm::vec3(4, 8, 0));
  EXPECT_EQ(at(scene, std::numeric_limits<double>::infinity()), glm::vec3(4, 8, 0));
}

TEST(Animation, steps_happen_at_their_key) {
  const Scene scene =
      scene_with(1, {channel(0, AnimatedPath::scale, Interpolation::step, {0, 1, 2}, {1, 1, 1, 2, 2, 2, 3, 3, 3})});
  const auto scale = [&](double time) { return at(scene, time, 0, {1, 0, 0}).x; };
  EXPECT_EQ(scale(0), 1);
  EXPECT_EQ(scale(std::nextafter(1.0, 0.0)), 1);
  EXPECT_EQ(scale(1), 2);
  EXPECT_EQ(scale(1.999), 2);
  EXPECT_EQ(scale(2), 3);
  EXPECT_EQ(scale(-1), 1);
}

TEST(Animation, turns_along_the_shorter_arc_at_an_even_speed) {
  // From no turn to a quarter turn around z, that one with its sign turned round.
  const Scene scene = scene_with(
      1, {channel(0, AnimatedPath::rotation, Interpolation::linear, {0, 3}, {0, 0, 0, 1, 0, 0, -half, -half})});
  for (const double time : {0.0, 0.5, 1.0, 1.7, 3.0}) {
    const double angle = std::numbers::pi / 2 * time / 3;
    expect_near(at(scene, time, 0, {1, 0, 0}), {std::cos(angle), std::sin(angle), 0});
  }
}

// By hand. Keys at 1 and 3 seconds: p = 0, leaving at 2 a second; p = 10, arriving at -4 a second. Half-way t = 0.5 and
// two seconds between: 0.5 * 0 + 2 * 0.125 * 2 + 0.5 * 10 - 2 * 0.125 * -4 = 6.5. At t = 0.25: h00 = 0.84375,
// h10 = 0.140625, h01 = 0.15625, h11 = -0.046875: 2 * 0.140625 * 2 + 1.5625 + 2 * -0.046875 * -4 = 2.5.
TEST(Animation, tangents_of_cubic_splines_are_per_second) {
  const Floats values = {99, 0, 0, 0, 0, 0, 2, 0, 0, -4, 0, 0, 10, 0, 0, 99, 0, 0};
  const Scene scene =
      scene_with(1, {channel(0, AnimatedPath::translation, Interpolation::cubic_spline, {1, 3}, values)});
  EXPECT_EQ(at(scene, 0).x, 0);
  EXPECT_EQ(at(scene, 1).x, 0);
  EXPECT_EQ(at(scene, 1.5).x, 2.5f);
  EXPECT_EQ(at(scene, 2).x, 6.5f);
  EXPECT_EQ(at(scene, 3).x, 10);
  EXPECT_EQ(at(scene, 4).x, 10);
}

TEST(Animation, cubic_rotations_are_brought_to_unit_length) {
  const Floats values = {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, half, half, 0, 0, 0, 0};
  const Scene scene = scene_with(1, {channel(0, AnimatedPath::rotation, Interpolation::cubic_spline, {0, 1}, values)});
  expect_near(at(scene, 0.5, 0, {1, 0, 0}), {half, half, 0});  // without tangents half-way is the middle
  EXPECT_NEAR(glm::length(at(scene, 0.3, 0, {1, 0, 0})), 1, 1e-6);
}

TEST(Animation, weights_have_a_value_for_each_target) {
  Scene scene = scene_with(2, {channel(0, AnimatedPath::weights, Interpolation::linear, {0, 1}, {0, 1, 1, 0.5f}),
                               channel(1, AnimatedPath::weights, Interpolation::cubic_spline, {0, 1},
                                       {9, 9, 1, 2, 0, 0, 0, 0, 3, 4, 9, 9})});
  EXPECT_EQ(posed_nodes(scene, {0, 0.5}).weights, (std::vector<Floats>{{0.5f, 0.75f}, {2, 3}}));
  scene.nodes[0].weights = {7, 8};
  scene.nodes[1].mesh = 0;
  scene.meshes.resize(1);
  scene.meshes[0].weights = {5};
  EXPECT_EQ(posed_nodes(scene).weights, (std::vector<Floats>{{7, 8}, {5}}));
}

TEST(Animation, what_a_clip_does_not_move_stays_as_it_stands) {
  Scene scene = scene_with(2, {channel(1, AnimatedPath::rotation, Interpolation::linear, {0}, {0, 0, half, half})});
  scene.nodes[0].transform.translation = {0, 0, 5};  // above the animated node
  scene.nodes[0].children = {1};
  scene.nodes[1].transform.translation = {1, 2, 3};
  scene.nodes[1].transform.scale = {2, 2, 2};
  expect_near(at(scene, 0, 1, {1, 0, 0}), {1, 4, 8});
  EXPECT_EQ(posed_nodes(scene).world, world_transforms(scene));
  EXPECT_EQ(posed_nodes(scene, {7, 0}).world, world_transforms(scene));  // there is no such clip
}

TEST(Animation, channels_that_make_no_sense_move_nothing) {
  const auto path = AnimatedPath::translation;
  Scene scene = scene_with(
      2, {channel(0, path, Interpolation::linear, {}, {}), channel(0, path, Interpolation::linear, {0, 1}, {5, 5, 5}),
          channel(0, path, Interpolation::cubic_spline, {0}, {5, 5, 5}),
          channel(0, AnimatedPath::weights, Interpolation::linear, {0, 1}, {5}),
          channel(77, path, Interpolation::linear, {0}, {5, 5, 5}),
          channel(1, path, Interpolation::linear, {0}, {5, 5, 5})});
  scene.nodes[1].matrix = glm::mat4(1);  // which no animation may move
  const PosedNodes nodes = posed_nodes(scene, {0, 0.5});
  EXPECT_EQ(nodes.world, world_transforms(scene));
  EXPECT_TRUE(nodes.weights[0].empty());
}

TEST(Animation, a_rotation_of_length_0_turns_nothing_and_scale_0_is_a_point) {
  const Scene scene =
      scene_with(2, {channel(0, AnimatedPath::rotation, Interpolation::linear, {0, 1}, {0, 0, 0, 0, 0, 0, 0, 0}),
                     channel(1, AnimatedPath::scale, Interpolation::linear, {0}, {0, 0, 0})});
  EXPECT_EQ(at(scene, 0.5, 0, {1, 2, 3}), glm::vec3(1, 2, 3));
  EXPECT_EQ(at(scene, 0, 1, {1, 2, 3}), glm::vec3(0));
}

TEST(Animation, quantised_rotations_do_not_scale) {
  // As 8 bits store a quarter turn: 90 / 127.
  const float coarse = 90.0f / 127;
  const Scene scene =
      scene_with(1, {channel(0, AnimatedPath::rotation, Interpolation::step, {0}, {0, 0, coarse, coarse})});
  expect_near(at(scene, 0, 0, {1, 0, 0}), {0, 1, 0});
}

}  // namespace
}  // namespace foredraw::viewing_animation_test

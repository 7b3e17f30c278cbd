// Positions as integers: whatever places a draw brings them back, wherever it is drawn.
#include "support/meshes.h"
#include "support/staged.h"

#include <foredraw/scene/walk.h>
#include <foredraw/viewing/animation.h>
#include <foredraw/viewing/posed_positions.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace foredraw::quantize_integers_test {
namespace {

using ::testing::HasSubstr;
using testing::TestMesh;

const VertexStream& positions_of(const Scene& scene, DrawId draw) {
  return *scene.draws[draw].full().vertices->find("POSITION");
}

bool has_integers(const Scene& scene, DrawId draw) {
  return positions_of(scene, draw).format.component == Component::uint16;
}

/// All vertices as nodes draw them, node by node as the file's walk has them, and each instance.
std::vector<glm::vec3> drawn(const Scene& scene, const Pose& pose = {}) {
  const PosedNodes nodes = posed_nodes(scene, pose);
  std::vector<glm::vec3> all;
  for (const NodeId n : walk(scene)) {
    const Node& node = scene.nodes[n];
    if (!node.mesh) continue;
    for (const DrawId draw : scene.meshes[*node.mesh].draws) {
      const std::vector<glm::vec3> at_node = posed_positions(scene, {draw, n}, nodes);
      if (node.instances.empty()) all.insert(all.end(), at_node.begin(), at_node.end());
      for (const Transform& instance : node.instances.view()) {
        for (const glm::vec3& p : decode_vec3(positions_of(scene, draw)))
          all.push_back(glm::vec3(nodes.world[n] * (instance.matrix() * glm::vec4(p, 1))));
      }
    }
  }
  return all;
}

double farthest(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
  EXPECT_EQ(a.size(), b.size());
  double most = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    most = std::max(most, double{glm::distance(glm::dvec3(a[i]), glm::dvec3(b[i]))});
  return most;
}

/// A ball from .5 to 2.5, moved away from its origin, that an unnamed node draws.
Scene ball() {
  Scene scene = testing::scene_of(testing::sphere(16, 12, 1, {1.5f, -3, .25f}));
  scene.nodes[0].name.clear();
  return scene;
}

constexpr const char* coarse = "quantize(position-error=.001)";  // of a diagonal of 2 * sqrt(3): .0035

TEST(QuantizeIntegers, ANodeWithoutANameTakesTheGridIn) {
  Scene scene = ball();
  scene.nodes[0].transform = {{1, 2, 3}, glm::quat(.5f, .5f, .5f, .5f), {1, 2, 1}};
  const Result result = testing::run(coarse, scene);
  ASSERT_TRUE(has_integers(result.scene, 0));
  EXPECT_EQ(result.scene.nodes.size(), 1u);
  EXPECT_LT(farthest(drawn(scene), drawn(result.scene)), 2 * .0035);
  EXPECT_GT(farthest(drawn(scene), drawn(result.scene)), .0007);
}

TEST(QuantizeIntegers, AMatrixTakesTheGridIn) {
  Scene scene = ball();
  scene.nodes[0].matrix = glm::rotate(glm::scale(glm::mat4(1), {2, 1, 1}), .7f, {0, 1, 0});
  const Result result = testing::run(coarse, scene);
  ASSERT_TRUE(has_integers(result.scene, 0));
  ASSERT_TRUE(result.scene.nodes[0].matrix);
  EXPECT_LT(farthest(drawn(scene), drawn(result.scene)), 2 * .0035);
}

TEST(QuantizeIntegers, ANodeThatAProgramMayMoveStaysWhereItIs) {
  for (const char* by : {"name", "child", "camera", "animation", "joint"}) {
    Scene scene = ball();
    Node& node = scene.nodes[0];
    node.transform.translation = {4, 0, 0};
    if (by == std::string("name")) node.name = "door";
    if (by == std::string("camera")) node.has_camera = true;
    if (by == std::string("child")) {
      node.children = {1};
      scene.nodes.push_back(Node{.name = "knob", .mesh = 0});
    }
    if (by == std::string("animation")) {
      scene.animations.push_back({"turn",
                                  {{0, AnimatedPath::rotation, Interpolation::linear, Shared<float>({0.0f, 1.0f}),
                                    Shared<float>({0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 1.0f, 0.0f, 0.0f})}}});
    }
    if (by == std::string("joint")) scene.skins.push_back({"skin", {0}, {glm::mat4(1)}});
    const Result result = testing::run(coarse, scene);
    ASSERT_TRUE(has_integers(result.scene, 0)) << by;
    const Node& now = result.scene.nodes[0];
    EXPECT_FALSE(now.mesh) << by;
    EXPECT_EQ(now.transform.translation, glm::vec3(4, 0, 0)) << by;
    EXPECT_EQ(now.transform.scale, glm::vec3(1)) << by;
    ASSERT_FALSE(now.children.empty()) << by;
    EXPECT_EQ(result.scene.nodes[now.children.front()].mesh, 0u) << by << ": it is drawn before its children";
    const Pose pose = scene.animations.empty() ? Pose{} : Pose{.clip = 0u, .time = .5};
    EXPECT_LT(farthest(drawn(scene, pose), drawn(result.scene, pose)), .0035) << by;
  }
}

TEST(QuantizeIntegers, InstancesTakeTheGridIn) {
  Scene scene = ball();
  scene.nodes[0].instances = Shared<Transform>(
      {{{1, 0, 0}, glm::quat(.5f, .5f, .5f, .5f), {1, 1, 1}}, {{9, 0, 0}, glm::quat(1, 0, 0, 0), {1, 3, .5f}}});
  const Result result = testing::run(coarse, scene);
  ASSERT_TRUE(has_integers(result.scene, 0));
  EXPECT_EQ(result.scene.nodes[0].transform.scale, glm::vec3(1));
  EXPECT_LT(farthest(drawn(scene), drawn(result.scene)), 3 * .0035);
}

/// Two balls, which two joints move, one mesh each.
Scene two_skinned_balls() {
  std::vector<Draw> draws;
  for (const float x : {0.0f, 5.0f}) {
    Draw draw = testing::draw_of(testing::sphere(12, 8, 1, {x, 0, 0}), "ball");
    auto vertices = std::make_shared<VertexStreams>(*draw.full().vertices);
    std::vector<std::uint8_t> joints;
    std::vector<float> weights;
    for (std::uint32_t v = 0; v < vertices->count; ++v) {
      const float part = static_cast<float>(v % 4) / 3;
      joints.insert(joints.end(), {0, 1, 0, 0});
      weights.insert(weights.end(), {part, 1 - part, 0, 0});
    }
    const auto j = std::as_bytes(std::span(joints)), w = std::as_bytes(std::span(weights));
    vertices->base.push_back({"JOINTS_0", {Component::uint8, 4, false, 4}, Shared<std::byte>({j.begin(), j.end()})});
    vertices->base.push_back(
        {"WEIGHTS_0", {Component::float32, 4, false, 16}, Shared<std::byte>({w.begin(), w.end()})});
    draw.full().vertices = std::move(vertices);
    draws.push_back(std::move(draw));
  }
  Scene scene = testing::scene_of(std::move(draws));
  scene.nodes.push_back(Node{.name = "root", .transform = {{0, 1, 0}}, .children = {3}});
  scene.nodes.push_back(Node{.name = "tip", .transform = {{0, 2, 0}, glm::quat(.8f, .6f, 0, 0), {1, 2, 1}}});
  scene.skins.push_back({"skin", {2, 3}, {glm::translate(glm::mat4(1), {0, -1, 0}), glm::mat4(1)}});
  for (const NodeId n : {0u, 1u}) scene.nodes[n].skin = 0;
  return scene;
}

TEST(QuantizeIntegers, ASkinTakesTheGridOfAllItsMeshesIn) {
  const Scene scene = two_skinned_balls();
  const Result result = testing::run(coarse, scene);
  ASSERT_TRUE(has_integers(result.scene, 0));
  ASSERT_TRUE(has_integers(result.scene, 1));
  EXPECT_EQ(result.scene.nodes.size(), 4u);
  EXPECT_EQ(result.scene.nodes[0].transform.scale, glm::vec3(1));
  EXPECT_LT(farthest(drawn(scene), drawn(result.scene)), 2 * .0035 + 1e-6);
}

TEST(QuantizeIntegers, WhatNoJointMovesStaysFloats) {
  Scene scene = two_skinned_balls();
  scene.skins[0].joints.pop_back();
  scene.skins[0].inverse_bind_matrices.pop_back();
  const Result result = testing::run(coarse, scene);
  EXPECT_FALSE(has_integers(result.scene, 0));
  EXPECT_EQ(result.scene.skins[0].inverse_bind_matrices, scene.skins[0].inverse_bind_matrices);
  EXPECT_THAT(to_text(result.report), HasSubstr("have no joint that moves them"));
  EXPECT_LT(farthest(drawn(scene), drawn(result.scene)), 2 * .0035);
}

TEST(QuantizeIntegers, MorphTargetsAndTheirWeightsGoToTheChild) {
  Scene scene = ball();
  auto vertices = std::make_shared<VertexStreams>(*scene.draws[0].full().vertices);
  std::vector<float> moved(vertices->count * 3, -.5f);
  const auto bytes = std::as_bytes(std::span(moved));
  vertices->morph_targets = {
      {{"POSITION", {Component::float32, 3, false, 12}, Shared<std::byte>({bytes.begin(), bytes.end()})}}};
  scene.draws[0].full().vertices = vertices;
  scene.nodes[0].name = "face";
  scene.nodes[0].weights = {.25f};
  scene.animations.push_back(
      {"smile",
       {{0, AnimatedPath::weights, Interpolation::linear, Shared<float>({0.0f, 1.0f}), Shared<float>({0.0f, 1.0f})}}});
  const Result result = testing::run(coarse, scene);
  ASSERT_TRUE(has_integers(result.scene, 0));
  EXPECT_EQ(result.scene.draws[0].full().vertices->morph_targets[0][0].format.component, Component::int16);
  EXPECT_TRUE(result.scene.nodes[0].weights.empty());
  EXPECT_EQ(result.scene.nodes[1].weights, std::vector<float>{.25f});
  EXPECT_EQ(result.scene.animations[0].channels[0].node, 1u);
  for (const Pose& pose : {Pose{}, Pose{.clip = 0u, .time = .75}})
    EXPECT_LT(farthest(drawn(scene, pose), drawn(result.scene, pose)), 2 * .0035);
}

TEST(QuantizeIntegers, DrawsThatMeetStillMeet) {
  TestMesh left = testing::grid(10, 10), right = testing::grid(30, 10);
  for (glm::vec3& p : left.positions) p = {p.x * .1f, p.y * .0977f, 0};
  for (glm::vec3& p : right.positions) p = {p.x * .1f + 1, p.y * .0977f, 0};
  const Scene scene = testing::scene_of({testing::draw_of(left, "left"), testing::draw_of(right, "right")});
  const Result result = testing::run("quantize(position-error=.003)", scene);
  ASSERT_TRUE(has_integers(result.scene, 0));
  ASSERT_TRUE(has_integers(result.scene, 1));
  const std::vector<glm::vec3> all = drawn(result.scene);
  std::size_t met = 0;
  for (std::size_t a = 0; a < 121; ++a)
    met += static_cast<std::size_t>(std::count(all.begin() + 121, all.end(), all[a]));
  EXPECT_EQ(met, 11u) << "the border of eleven vertices, to the last bit";
}

TEST(QuantizeIntegers, WhatMeetsFloatsHasTheirPoints) {
  TestMesh left = testing::grid(10, 10), right = testing::grid(30, 10);
  for (glm::vec3& p : left.positions) p = {p.x * .1f, p.y * .0977f, 0};
  for (glm::vec3& p : right.positions) p = {p.x * .1f + 1, p.y * .0977f, 0};
  Scene scene = testing::scene_of({testing::draw_of(left, "left"), testing::draw_of(right, "right")});
  scene.nodes[1].keeps_mesh = true;
  const Result result = testing::run("quantize(position-error=.003)", scene);
  ASSERT_TRUE(has_integers(result.scene, 0));
  ASSERT_FALSE(has_integers(result.scene, 1));
  EXPECT_THAT(to_text(result.report), HasSubstr("positions of right stay floats: an extension"));
  const std::vector<glm::vec3> all = drawn(result.scene);
  std::size_t met = 0;
  for (std::size_t a = 0; a < 121; ++a)
    met += static_cast<std::size_t>(std::count(all.begin() + 121, all.end(), all[a]));
  EXPECT_EQ(met, 11u);
  EXPECT_LT(farthest(drawn(scene), all), .003 * std::sqrt(9.1));
}

TEST(QuantizeIntegers, LengthsOfMaterialsFollow) {
  Scene scene = testing::scene_of({testing::draw_of(testing::sphere(8, 8), "small"),
                                   testing::draw_of(testing::sphere(8, 8, 40, {100, 0, 0}), "large"),
                                   testing::draw_of(testing::sphere(8, 8, 1, {900, 0, 0}), "other")});
  scene.materials.resize(2);
  scene.materials[0].thickness = 2;
  scene.materials[0].look = scene.materials[0].kind = Stamp{1, 2};
  scene.draws[0].material = scene.draws[1].material = 0;
  scene.draws[2].material = 1;
  const Result result = testing::run(coarse, scene);
  for (const DrawId id : {0u, 1u}) {
    const Draw& draw = result.scene.draws[id];
    ASSERT_TRUE(has_integers(result.scene, id));
    EXPECT_NEAR(*result.scene.material_of(draw)->thickness * draw.space.scale, 2, 1e-6);
  }
  EXPECT_NE(result.scene.draws[0].material, result.scene.draws[1].material);
  EXPECT_EQ(result.scene.materials.size(), 3u);
}

TEST(QuantizeIntegers, WhatOtherMaterialsStandInForStays) {
  Scene scene = ball();
  scene.materials.push_back({.name = "paint", .keeps_spaces = true});
  scene.draws[0].material = 0;
  const Result result = testing::run(coarse, scene);
  EXPECT_FALSE(has_integers(result.scene, 0));
  EXPECT_THAT(to_text(result.report), HasSubstr("another material may stand in for paint"));
}

TEST(QuantizeIntegers, FarFromItsOriginADrawHasAPowerOfTwo) {
  for (const float away : {100.0f, 3000.0f, 1e6f}) {
    Scene scene = ball();
    auto vertices = std::make_shared<VertexStreams>(*scene.draws[0].full().vertices);
    auto positions = decode_vec3(vertices->base[0]);
    for (glm::vec3& p : positions) p.x += away;
    scene.draws[0].full().vertices = testing::vertex_streams(positions);
    const Result result = testing::run(coarse, scene);
    EXPECT_EQ(has_integers(result.scene, 0), away < 1e6f) << away;
    EXPECT_LE(farthest(drawn(scene), drawn(result.scene)), .0035) << away;
  }
}

TEST(QuantizeIntegers, MoreThan16BitsStayFloats) {
  const Result result = testing::run("quantize(position-error=3e-6)", ball());
  EXPECT_FALSE(has_integers(result.scene, 0));
  EXPECT_THAT(to_text(result.report), HasSubstr("65,535 steps"));
}

TEST(QuantizeIntegers, OneVertexAndFlatDrawsHaveAGridToo) {
  TestMesh flat = testing::grid(3, 3);
  const Result result = testing::run(coarse, testing::scene_of(flat));
  EXPECT_TRUE(has_integers(result.scene, 0));
  TestMesh one;
  one.positions = {{1, 2, 3}};
  one.indices = {0, 0, 0};
  EXPECT_FALSE(has_integers(testing::run(coarse, testing::scene_of(one)).scene, 0)) << "it has no diagonal";
}

TEST(QuantizeIntegers, ErrorsOfLevelsAreInTheNewUnits) {
  const Scene scene = testing::run("quadric-collapse, levels", ball()).scene;
  ASSERT_GT(scene.draws[0].levels.size(), 1u);
  Scene plain = scene;
  plain.products = {};
  const Result result = testing::run(coarse, plain);
  ASSERT_TRUE(has_integers(result.scene, 0));
  for (std::size_t l = 1; l < scene.draws[0].levels.size(); ++l) {
    const double error = result.scene.draws[0].levels[l].error * result.scene.draws[0].space.scale;
    EXPECT_GT(error, scene.draws[0].levels[l].error);
    EXPECT_LT(error, scene.draws[0].levels[l].error + 2 * .0036);
  }
}

TEST(QuantizeIntegers, OrdersOfStagesBehindAreAsGood) {
  const Scene scene = ball();
  const Result integers = testing::run("quantize, tipsify", scene);
  const Result floats = testing::run("quantize(integers=false), tipsify", scene);
  EXPECT_EQ(integers.scene.draws[0].full().stream().indices, floats.scene.draws[0].full().stream().indices);
}

}  // namespace
}  // namespace foredraw::quantize_integers_test

#include "plugins/processors/prune/prune.h"

#include "support/meshes.h"
#include "support/staged.h"

#include <foredraw/io/gltf/gltf.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace foredraw::prune_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

VertexStream floats(std::string name, std::uint8_t components, std::vector<float> values) {
  const auto bytes = std::as_bytes(std::span(values));
  return {std::move(name),
          {Component::float32, components, false, static_cast<std::uint16_t>(4 * components)},
          Shared<std::byte>(std::vector<std::byte>(bytes.begin(), bytes.end()))};
}

std::vector<std::string> left_of(std::vector<VertexStream> streams) {
  VertexStreams vertices;
  vertices.count = static_cast<std::uint32_t>(streams.front().count());
  vertices.base = std::move(streams);
  std::vector<std::string> names;
  const PrunedStreams pruned = prune_streams(vertices);
  for (const VertexStream& stream : pruned.vertices->base) names.push_back(stream.semantic);
  return names;
}

TEST(Prune, WhiteColoursGoOthersStay) {
  const VertexStream position = floats("POSITION", 3, {0, 0, 0, 1, 1, 1});
  const VertexStream white = floats("COLOR_0", 3, {1, 1, 1, 1, 1, 1});
  EXPECT_THAT(left_of({position, white}), ElementsAre("POSITION"));
  EXPECT_THAT(left_of({position, floats("COLOR_0", 3, {1, 1, 1, 1, 1, .99f})}), ElementsAre("POSITION", "COLOR_0"));
  EXPECT_THAT(left_of({position, white, floats("COLOR_1", 3, {0, 0, 0, 0, 0, 0})}),
              ElementsAre("POSITION", "COLOR_0", "COLOR_1"))
      << "a second set would lose its number";
}

TEST(Prune, LastSetsOfJointsWithoutWeightGo) {
  const VertexStream used = floats("WEIGHTS_0", 4, {1, 0, 0, 0}), none = floats("WEIGHTS_1", 4, {0, 0, 0, 0});
  const VertexStream first = floats("JOINTS_0", 4, {0, 0, 0, 0}), second = floats("JOINTS_1", 4, {3, 0, 0, 0});
  EXPECT_THAT(left_of({used, first, none, second}), ElementsAre("WEIGHTS_0", "JOINTS_0"));
  EXPECT_EQ(left_of({floats("WEIGHTS_0", 4, {0, 0, 0, 0}), first}).size(), 2u);
  EXPECT_EQ(
      left_of({used, first, none, second, floats("WEIGHTS_2", 4, {.1f, 0, 0, 0}), floats("JOINTS_2", 4, {1, 0, 0, 0})})
          .size(),
      6u);
}

std::vector<std::string> left_with(const VertexNeeds& needs) {
  VertexStreams vertices;
  vertices.count = 1;
  vertices.base = {floats("POSITION", 3, {0, 0, 0}), floats("TANGENT", 4, {1, 0, 0, 1}),
                   floats("TEXCOORD_0", 2, {0, 0}), floats("TEXCOORD_1", 2, {0, 0})};
  vertices.morph_targets = {{floats("POSITION", 3, {1, 0, 0}), floats("TANGENT", 3, {0, 1, 0})}};
  const PrunedStreams pruned = prune_streams(vertices, needs);
  std::vector<std::string> names;
  for (const VertexStream& stream : pruned.vertices->base) names.push_back(stream.semantic);
  const bool has_tangents = std::ranges::find(names, "TANGENT") != names.end();
  EXPECT_EQ(pruned.vertices->morph_targets[0].size(), has_tangents ? 2u : 1u) << "targets go along";
  return names;
}

TEST(Prune, WhatNoTextureLooksUpGoes) {
  EXPECT_THAT(left_with({}), ElementsAre("POSITION"));
  EXPECT_THAT(left_with({.texcoords = 1}), ElementsAre("POSITION", "TEXCOORD_0"));
  EXPECT_THAT(left_with({.texcoords = 2}), ElementsAre("POSITION", "TEXCOORD_0", "TEXCOORD_1"))
      << "sets are numbered without a gap";
  EXPECT_THAT(left_with({.texcoords = 1, .has_tangents = true}), ElementsAre("POSITION", "TANGENT", "TEXCOORD_0"));
}

TEST(Prune, NeedsAreNotKnownWithoutAMaterialOrWithAnExtension) {
  Scene scene;
  scene.materials = {Material{.needs = VertexNeeds{.texcoords = 2}}, Material{}};
  Draw draw;
  EXPECT_FALSE(needs_of(draw, scene)) << "whoever shows it puts one there";
  draw.material = 0;
  EXPECT_EQ(needs_of(draw, scene), (VertexNeeds{.texcoords = 2}));
  scene.materials[0].displacement = Displacement{.texture = {.image = 0, .texcoord = 3}};
  EXPECT_EQ(needs_of(draw, scene), (VertexNeeds{.texcoords = 0b1010})) << "a stage gave it a map";
  draw.traits.add(traits::extended);
  EXPECT_FALSE(needs_of(draw, scene));
  draw = {};
  draw.material = 1;
  EXPECT_FALSE(needs_of(draw, scene));
}

AnimationChannel channel(AnimatedPath path, std::vector<float> times, std::vector<float> values, NodeId node = 0) {
  return {node, path, Interpolation::linear, Shared<float>(std::move(times)), Shared<float>(std::move(values))};
}

constexpr RestTolerances near{.translation = 1e-3};

TEST(Prune, TracksThatStayWhereTheirNodeRestsGo) {
  std::vector<Node> nodes(1);
  nodes[0].transform.translation = {1, 2, 3};
  nodes[0].transform.rotation = glm::quat(.6f, 0, .8f, 0);
  const std::vector<AnimationChannel> channels{
      channel(AnimatedPath::translation, {0, 1}, {1, 2, 3, 1, 2, 3.0004f}),
      channel(AnimatedPath::rotation, {0, 1}, {0, .8f, 0, .6f, 0, -.8f, 0, -.6f}),
      channel(AnimatedPath::scale, {0, 1}, {1, 1, 1, 1, 1.1f, 1}),
      channel(AnimatedPath::weights, {0, 1}, {0, 0}),
      channel(AnimatedPath::translation, {0}, {1, 2, 3.1f}),
      channel(AnimatedPath::translation, {0}, {1, 2, 3}, 7),
  };
  EXPECT_THAT(resting_tracks({"", channels}, nodes, near), ElementsAre(true, true, false, false, false, false));
}

TEST(Prune, OneTrackStaysAndTheAnimationKeepsItsTime) {
  const std::vector<Node> nodes(1);
  const AnimationChannel short_one = channel(AnimatedPath::translation, {0, 1}, {0, 0, 0, 0, 0, 0});
  const AnimationChannel long_one = channel(AnimatedPath::translation, {0, 2}, {0, 0, 0, 0, 0, 0});
  const AnimationChannel moves = channel(AnimatedPath::scale, {0, 1}, {1, 1, 1, 2, 2, 2});
  EXPECT_THAT(resting_tracks({"", {short_one, long_one}}, nodes, near), ElementsAre(true, false));
  EXPECT_THAT(resting_tracks({"", {short_one, long_one, moves}}, nodes, near), ElementsAre(true, false, false));
  EXPECT_THAT(resting_tracks({"", {short_one, moves}}, nodes, near), ElementsAre(true, false));
  EXPECT_TRUE(resting_tracks({"", {}}, nodes, near).empty());
}

TEST(PruneStage, AnAnimationOfFewerTracksComesBackFromTheFile) {
  Diagnostics diagnostics;
  const auto scene = read_gltf(testing::project_file("benchmarks/corpus/animated/fox.glb"), diagnostics);
  ASSERT_TRUE(scene);
  Scene extended = *scene;
  Animation& animation = extended.animations[0];
  const Node& node = extended.nodes[animation.channels[0].node];
  animation.channels.insert(animation.channels.begin() + 1, animation.channels[0]);
  animation.channels[1].path = AnimatedPath::scale;
  animation.channels[1].times = Shared<float>({0, .1f});
  animation.channels[1].values =
      Shared<float>({node.transform.scale.x, node.transform.scale.y, node.transform.scale.z, node.transform.scale.x,
                     node.transform.scale.y, node.transform.scale.z});
  extended.source = nullptr;
  const auto first = encode_gltf(extended, "first.glb", diagnostics);
  ASSERT_TRUE(first) << to_text(diagnostics);
  const auto again = read_gltf(first->front().bytes, "first.glb", {}, diagnostics);
  ASSERT_TRUE(again);
  const Result result = testing::run("prune", *again);
  EXPECT_THAT(to_text(result.report), HasSubstr("stay where their node rests"));
  const auto second = encode_gltf(result.scene, "second.glb", diagnostics);
  ASSERT_TRUE(second) << to_text(diagnostics);
  const auto pruned = read_gltf(second->front().bytes, "second.glb", {}, diagnostics);
  ASSERT_TRUE(pruned);
  EXPECT_LT(pruned->animations[0].channels.size(), extended.animations[0].channels.size());
  ASSERT_EQ(pruned->animations[0].channels.size(), result.scene.animations[0].channels.size());
  for (std::size_t c = 0; c < pruned->animations[0].channels.size(); ++c) {
    const AnimationChannel &is = pruned->animations[0].channels[c], &want = result.scene.animations[0].channels[c];
    EXPECT_EQ(is.node, want.node) << c;
    EXPECT_EQ(is.path, want.path) << c;
    EXPECT_EQ(is.values, want.values) << c;
  }
}

}  // namespace
}  // namespace foredraw::prune_test

// What is hidden of scenes: materials, nodes, skins and poses.

#include "hidden_in_scene.h"
#include "plugins/processors/hidden/bodies.h"

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <numeric>

namespace foredraw::hidden_scene_test {
namespace {

using processors::hidden::Moving;
using namespace testing;

TEST(HiddenScene, DrawsOfAMeshHideEachOther) { EXPECT_EQ(hidden_of(one_mesh({box(), box(0.5f)})), inner_goes); }

TEST(HiddenScene, WhatOneSeesThroughHidesNothing) {
  const auto with_shell = [](auto change) {
    Scene scene = one_mesh({box(), box(0.5f)});
    scene.materials.resize(2);
    scene.draws[1].material = 1;
    change(scene.materials[0], scene.draws[0]);
    return hidden_of(scene);
  };
  EXPECT_EQ(with_shell([](Material&, Draw&) {}), inner_goes);
  EXPECT_EQ(with_shell([](Material& m, Draw&) { m.alpha_mode = AlphaMode::mask; }), all_stay);
  EXPECT_EQ(with_shell([](Material& m, Draw&) { m.alpha_mode = AlphaMode::blend; }), all_stay);
  EXPECT_EQ(with_shell([](Material& m, Draw&) { m.keeps_sides = true; }), all_stay);
  EXPECT_EQ(with_shell([](Material&, Draw& d) { d.traits.add(traits::morphed); }), all_stay);
  EXPECT_EQ(with_shell([](Material&, Draw& d) { d.traits.add(traits::extended); }), all_stay);
}

TEST(HiddenScene, WhatMayChangeStays) {
  const auto with_inner = [](auto change) {
    Scene scene = one_mesh({box(), box(0.5f)});
    scene.materials.resize(2);
    scene.draws[1].material = 1;
    change(scene.materials[1], scene.draws[1]);
    return hidden_of(scene);
  };
  EXPECT_EQ(with_inner([](Material& m, Draw&) { m.alpha_mode = AlphaMode::mask; }), inner_goes);
  EXPECT_EQ(with_inner([](Material& m, Draw&) { m.alpha_mode = AlphaMode::blend; }), all_stay);
  EXPECT_EQ(with_inner([](Material& m, Draw&) { m.keeps_sides = true; }), all_stay);
  EXPECT_EQ(with_inner([](Material&, Draw& d) { d.traits.add(traits::morphed); }), all_stay);
  EXPECT_EQ(with_inner([](Material&, Draw& d) { d.levels.resize(2, d.full()); }), all_stay);
  EXPECT_EQ(with_inner([](Material&, Draw& d) { d.full().orders.resize(2, d.full().stream()); }), all_stay);
}

/// A shell and what is in it, each a mesh with a node of its own.
Scene two_nodes() {
  Scene scene = testing::scene_of({testing::draw_of(box(), "shell"), testing::draw_of(box(0.5f), "inner")});
  find_traits(scene);
  return scene;
}

TEST(HiddenScene, MeshesAreByThemselvesUnlessTheSceneIsSeenAsOne) {
  EXPECT_EQ(hidden_of(two_nodes()), all_stay);
  EXPECT_EQ(hidden_of(two_nodes(), as_scene()), inner_goes);
}

TEST(HiddenScene, AMirroredShellHides) {
  Scene scene = two_nodes();
  scene.nodes[0].transform.scale = {-1, 1, 1};
  EXPECT_EQ(hidden_of(scene, as_scene()), inner_goes);
  scene = one_mesh({box(), box(0.5f)});
  scene.nodes[0].transform.scale = {1, -2, 1};
  EXPECT_EQ(hidden_of(scene), inner_goes);
  EXPECT_EQ(hidden_of(scene, as_scene()), inner_goes);
  // One that is turned inside out shows what is in it, mirrored or not.
  scene = one_mesh({testing::turned(box()), box(0.5f)});
  scene.nodes[0].transform.scale = {1, -2, 1};
  EXPECT_EQ(hidden_of(scene, as_scene()), all_stay);
}

TEST(HiddenScene, WhatSeveralNodesShowIsHiddenWhereItIsHiddenEverywhere) {
  Scene scene = two_nodes();
  scene.nodes.push_back(scene.nodes[1]);
  scene.nodes[2].transform.scale = glm::vec3(0.5f);
  EXPECT_EQ(hidden_of(scene, as_scene()), inner_goes);
  scene.nodes[2].transform.translation = {9, 0, 0};
  EXPECT_EQ(hidden_of(scene, as_scene()), all_stay);
  scene.nodes[2].is_shown = false;  // by another scene, perhaps
  EXPECT_EQ(hidden_of(scene, as_scene()), all_stay);
}

TEST(HiddenScene, WhatANodeShowsManyTimesStays) {
  Scene scene = two_nodes();
  Transform far;
  far.translation = {9, 0, 0};
  scene.nodes[1].instances = Shared(std::vector<Transform>{Transform{}, far});
  EXPECT_EQ(hidden_of(scene, as_scene()), all_stay);
  scene = two_nodes();
  scene.nodes[0].instances = Shared(std::vector<Transform>{far});
  EXPECT_EQ(hidden_of(scene, as_scene()), all_stay);
}

TEST(HiddenScene, WhatMovesHidesNothingUnlessAllClipsSaySo) {
  Scene still = two_nodes(), moving = two_nodes(), shaking = two_nodes();
  add_clip(moving, 0, {9, 0, 0});
  add_clip(shaking, 1, {0.1f, 0, 0});
  HiddenSearchOptions clips = as_scene();
  clips.moving = Moving::clips;
  EXPECT_EQ(hidden_of(still, clips), inner_goes);
  EXPECT_EQ(hidden_of(moving, as_scene()), all_stay);
  EXPECT_EQ(hidden_of(moving, clips), all_stay);
  EXPECT_EQ(hidden_of(shaking, as_scene()), all_stay);
  EXPECT_EQ(hidden_of(shaking, clips), inner_goes);
  // What hangs below what moves, moves along.
  Scene together = two_nodes();
  add_clip(together, 0, {9, 0, 0});
  together.nodes[0].children = {1};
  EXPECT_EQ(hidden_of(together, as_scene()), inner_goes);
}

template <class T>
void add_stream(Draw& draw, const std::string& semantic, Component component, const std::vector<T>& values) {
  VertexStreams streams = *draw.full().vertices;
  const auto bytes = std::as_bytes(std::span(values));
  const Format format{component, 4, false, static_cast<std::uint16_t>(4 * sizeof(T))};
  streams.base.push_back({semantic, format, Shared<std::byte>({bytes.begin(), bytes.end()})});
  draw.full().vertices = std::make_shared<const VertexStreams>(streams);
}

/// Each vertex follows the joint wholly, or, where there are two, both by half.
void bind(Draw& draw, std::uint8_t joint, std::uint8_t other) {
  std::vector<std::uint8_t> joints;
  std::vector<float> weights;
  for (std::uint32_t v = 0; v < draw.full().vertices->count; ++v) {
    joints.insert(joints.end(), {joint, other, 0, 0});
    weights.insert(weights.end(), {joint == other ? 1.f : 0.5f, joint == other ? 0.f : 0.5f, 0, 0});
  }
  add_stream(draw, "JOINTS_0", Component::uint8, joints);
  add_stream(draw, "WEIGHTS_0", Component::float32, weights);
}

/// Two draws of a character with joints 1 and 2.
Scene character(std::pair<int, int> shell, std::pair<int, int> inner) {
  Scene scene = one_mesh({box(), box(0.5f)});
  bind(scene.draws[0], static_cast<std::uint8_t>(shell.first), static_cast<std::uint8_t>(shell.second));
  bind(scene.draws[1], static_cast<std::uint8_t>(inner.first), static_cast<std::uint8_t>(inner.second));
  scene.nodes.resize(3);
  scene.nodes[0].skin = 0;
  scene.skins.resize(1);
  scene.skins[0].joints = {1, 2};
  scene.skins[0].inverse_bind_matrices.assign(2, glm::mat4(1));
  find_traits(scene);
  return scene;
}

TEST(HiddenScene, PartsOfACharacterHideWhatFollowsTheSameJointAlone) {
  EXPECT_EQ(hidden_of(character({0, 0}, {0, 0})), inner_goes);
  EXPECT_EQ(hidden_of(character({1, 1}, {1, 1})), inner_goes);
  EXPECT_EQ(hidden_of(character({0, 0}, {1, 1})), all_stay);
  EXPECT_EQ(hidden_of(character({0, 1}, {0, 1})), all_stay);
  EXPECT_EQ(hidden_of(character({0, 0}, {0, 1})), all_stay);
  EXPECT_EQ(hidden_of(character({0, 1}, {0, 0})), all_stay);
  // Corners of the inner one's triangles, or of the shell's, follow joints by turns.
  for (const DrawId by_turns : {0, 1}) {
    Scene scene = character({0, 0}, {0, 0});
    VertexStreams streams = *scene.draws[by_turns].full().vertices;
    for (VertexStream& stream : streams.base) {
      if (stream.semantic != "JOINTS_0") continue;
      std::vector<std::byte> joints(stream.bytes.view().begin(), stream.bytes.view().end());
      for (std::size_t v = 1; v < streams.count; v += 2) joints[4 * v] = std::byte{1};
      stream.bytes = Shared(std::move(joints));
    }
    scene.draws[by_turns].full().vertices = std::make_shared<const VertexStreams>(streams);
    EXPECT_EQ(hidden_of(scene), all_stay);
    const auto bodies = processors::hidden::bodies_of(scene, {by_turns, 0}, processors::hidden::carriers(scene));
    EXPECT_EQ(std::ranges::count(bodies, processors::hidden::bends), 8);  // not the four at -X and +X
  }
}

TEST(HiddenScene, WithClipsACharacterIsSeenInAllKeys) {
  HiddenSearchOptions clips = searched();
  clips.moving = Moving::clips;
  Scene scene = character({0, 0}, {1, 1});
  add_clip(scene, 1, {0.1f, 0, 0});
  EXPECT_EQ(hidden_of(scene), all_stay);
  EXPECT_EQ(hidden_of(scene, clips), inner_goes);
  add_clip(scene, 2, {0, 0, 0.8f});  // at its end the inner one looks out
  EXPECT_EQ(hidden_of(scene, clips), all_stay);
}

TEST(HiddenScene, TheSameAtAnyThreadCount) {
  const Scene scene = one_mesh({testing::soup(400, 1), box(0.2f, glm::vec3(0.5f))});
  HiddenSearchOptions options = searched();
  options.unit = processors::hidden::Unit::triangle;
  const DrawId asked[] = {0, 1};
  const auto one = processors::hidden::find_hidden(
      scene, asked, options, [] {}, Executor(1));
  const auto four = processors::hidden::find_hidden(
      scene, asked, options, [] {}, Executor(4));
  EXPECT_EQ(one.hidden, four.hidden);
  EXPECT_EQ(one.last_check.shown, four.last_check.shown);
}

TEST(HiddenScene, ACallerMayEndIt) {
  const Scene scene = one_mesh({box(), box(0.5f)});
  const DrawId asked[] = {0, 1};
  EXPECT_THROW(processors::hidden::find_hidden(
                   scene, asked, searched(), [] { throw std::runtime_error("cancelled"); }, Executor(2)),
               std::runtime_error);
}

}  // namespace
}  // namespace foredraw::hidden_scene_test

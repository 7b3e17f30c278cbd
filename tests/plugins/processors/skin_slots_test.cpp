// Which joints a vertex has, and with which weights, stays; where they stand follows the vertex before.
#include "plugins/processors/skin_slots/skin_slots.h"

#include "support/meshes.h"
#include "support/staged.h"

#include <foredraw/io/gltf/gltf.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <set>

namespace foredraw::skin_slots_test {
namespace {

using ::testing::ElementsAreArray;
using ::testing::HasSubstr;

template <class T>
VertexStream stream(std::string name, Component component, bool normalized, const std::vector<T>& values) {
  const auto bytes = std::as_bytes(std::span(values));
  return {std::move(name), {component, 4, normalized, 4 * sizeof(T)}, Shared<std::byte>({bytes.begin(), bytes.end()})};
}

VertexStreams skin(const std::vector<std::uint8_t>& joints, const std::vector<std::uint8_t>& weights) {
  VertexStreams vertices;
  vertices.count = static_cast<std::uint32_t>(joints.size() / 4);
  vertices.base = {stream("JOINTS_0", Component::uint8, false, joints),
                   stream("WEIGHTS_0", Component::uint8, true, weights)};
  return vertices;
}

std::vector<int> values(const VertexStreams& vertices, const char* name) {
  const auto bytes = vertices.find(name)->bytes.view();
  std::vector<int> result;
  for (const std::byte one : bytes) result.push_back(static_cast<int>(one));
  return result;
}

using Row = std::vector<std::uint8_t>;

/// Four joints and four weights for each vertex, before and afterwards.
SlottedSkin expect_slots(const Row& joints, const Row& weights, const std::vector<int>& joints_then,
                         const std::vector<int>& weights_then, const SkinSlotsOptions& options = {}) {
  SlottedSkin made = keep_slots(skin(joints, weights), options);
  EXPECT_EQ(values(*made.vertices, "JOINTS_0"), joints_then);
  EXPECT_EQ(values(*made.vertices, "WEIGHTS_0"), weights_then);
  return made;
}

TEST(SkinSlots, JointsStayWhereTheVertexBeforeHasThem) {
  const SlottedSkin made =
      expect_slots({3, 5, 0, 0, 5, 3, 0, 0, 5, 7, 3, 0}, {200, 55, 0, 0, 130, 125, 0, 0, 90, 85, 80, 0},
                   {3, 5, 0, 0, 3, 5, 0, 0, 3, 5, 7, 0}, {200, 55, 0, 0, 125, 130, 0, 0, 80, 90, 85, 0});
  EXPECT_EQ(made.moved, 2u);
  EXPECT_TRUE(made.why_not.empty());
}

TEST(SkinSlots, ASlotWithoutWeightNamesItsLastJointOr0) {
  const Row joints{3, 5, 0, 0, 5, 0, 0, 0, 3, 5, 0, 0}, weights{200, 55, 0, 0, 255, 0, 0, 0, 100, 155, 0, 0};
  const std::vector<int> weights_then{200, 55, 0, 0, 0, 255, 0, 0, 100, 155, 0, 0};
  expect_slots(joints, weights, {3, 5, 0, 0, 3, 5, 0, 0, 3, 5, 0, 0}, weights_then);
  expect_slots(joints, weights, {3, 5, 0, 0, 0, 5, 0, 0, 3, 5, 0, 0}, weights_then, {.zero_unused = true});
}

RC_GTEST_PROP(SkinSlots, EveryVertexKeepsItsInfluences, (std::vector<std::array<std::uint8_t, 4>> rows, bool zero)) {
  RC_PRE(!rows.empty());
  std::vector<std::uint8_t> joints, weights;
  for (const auto& row : rows) {
    for (const std::uint8_t one : row) {
      joints.push_back(one % 5);
      weights.push_back(one % 3 == 0 ? 0 : one);
    }
  }
  const VertexStreams before = skin(joints, weights);
  const VertexStreams after = *keep_slots(before, {.zero_unused = zero}).vertices;
  const auto of = [](const VertexStreams& vertices, std::size_t v) {
    const std::vector<int> joints = values(vertices, "JOINTS_0"), weights = values(vertices, "WEIGHTS_0");
    std::multiset<std::pair<int, int>> influences;
    for (std::size_t i = 4 * v; i < 4 * v + 4; ++i) {
      if (weights[i] != 0) influences.emplace(joints[i], weights[i]);
    }
    return influences;
  };
  for (std::size_t v = 0; v < rows.size(); ++v) RC_ASSERT(of(before, v) == of(after, v));
  RC_ASSERT(keep_slots(after, {.zero_unused = zero}).vertices->stamp() == after.stamp());
}

TEST(SkinSlots, SetsOfJointsAreOneRow) {
  VertexStreams vertices = skin({1, 2, 3, 4, 5, 1, 2, 3}, {60, 50, 45, 40, 60, 50, 45, 40});
  vertices.base.push_back(stream<std::uint8_t>("JOINTS_1", Component::uint8, false, {5, 0, 0, 0, 4, 0, 0, 0}));
  vertices.base.push_back(stream<std::uint8_t>("WEIGHTS_1", Component::uint8, true, {60, 0, 0, 0, 60, 0, 0, 0}));
  const SlottedSkin made = keep_slots(vertices);
  const std::vector<int> first = values(*made.vertices, "JOINTS_0"), second = values(*made.vertices, "JOINTS_1");
  EXPECT_THAT(std::vector<int>(first.begin() + 4, first.end()), ElementsAreArray(first.begin(), first.begin() + 4));
  EXPECT_EQ(second[4], second[0]);
}

TEST(SkinSlots, WhatHasNoSenseStays) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  VertexStreams vertices = skin({1, 2, 3, 4}, {});
  vertices.base[1] = stream<float>("WEIGHTS_0", Component::float32, false, {nan, 1, 0, 0});
  EXPECT_THAT(keep_slots(vertices).why_not, HasSubstr("not finite"));
  EXPECT_EQ(keep_slots(vertices).vertices->stamp(), vertices.stamp());
  vertices.base.pop_back();
  EXPECT_THAT(keep_slots(vertices).why_not, HasSubstr("no skin"));
  VertexStreams mixed = skin({1, 2, 3, 4}, {60, 60, 60, 75});
  mixed.base.push_back(stream<std::uint16_t>("JOINTS_1", Component::uint16, false, {5, 0, 0, 0}));
  mixed.base.push_back(stream<std::uint8_t>("WEIGHTS_1", Component::uint8, true, {0, 0, 0, 0}));
  EXPECT_THAT(keep_slots(mixed).why_not, HasSubstr("different formats"));
}

TEST(SkinSlotsStage, CompressedFilesAreShorter) {
  Diagnostics diagnostics;
  const auto scene = read_gltf(testing::project_file("benchmarks/corpus/animated/robot_expressive.glb"), diagnostics);
  ASSERT_TRUE(scene);
  const std::string before = "quantize, weld, codec-order, vertex-fetch(always=true)";
  const auto bytes = [&](const std::string& stages) {
    const Result result = testing::run(stages, *scene);
    const auto files = encode_gltf(result.scene, "out.glb", diagnostics, {.compression = Compression::khr});
    EXPECT_TRUE(files) << to_text(diagnostics);
    return files ? files->front().bytes.size() : 0;
  };
  EXPECT_LT(bytes(before + ", skin-slots"), bytes(before) - 500);
  EXPECT_THAT(to_text(testing::run("skin-slots, skin-slots", *scene).report), HasSubstr("already"));
}

}  // namespace
}  // namespace foredraw::skin_slots_test

#include <foredraw/collapses/cut.h>

#include "support/meshes.h"

#include <foredraw/collapses/replay.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace foredraw::cut_test {
namespace {

template <class T>
VertexStream stream(std::string semantic, Component component, std::uint8_t components, bool normalized,
                    const std::vector<T>& values) {
  const auto bytes = std::as_bytes(std::span(values));
  return {std::move(semantic),
          {component, components, normalized, static_cast<std::uint16_t>(components * sizeof(T))},
          Shared<std::byte>({bytes.begin(), bytes.end()})};
}

/// A square of two triangles and a third beside it, with all kinds of attributes. Vertex 0 goes to vertex 1.
class Cut : public ::testing::Test {
 protected:
  Cut() {
    VertexStreams vertices{.count = 5};
    vertices.base = {
        stream<float>("POSITION", Component::float32, 3, false, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0}),
        stream<float>("NORMAL", Component::float32, 3, false, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 1}),
        stream<std::uint8_t>("COLOR_0", Component::uint8, 4, true,
                             {0, 0, 0, 255, 255, 100, 0, 255, 1, 2, 3, 4, 5, 6, 7, 8, 9, 9, 9, 9}),
        stream<std::uint8_t>("JOINTS_0", Component::uint8, 4, false,
                             {1, 2, 0, 0, 2, 3, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0}),
        stream<std::uint8_t>("WEIGHTS_0", Component::uint8, 4, true,
                             {128, 127, 0, 0, 55, 200, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0}),
        stream<std::uint16_t>("_PART", Component::uint16, 1, false, {7, 8, 9, 10, 11}),
    };
    vertices.morph_targets = {
        {stream<float>("POSITION", Component::float32, 3, false, {4, 0, 0, 0, 4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0})}};
    Draw draw;
    draw.levels.emplace_back();
    draw.full().vertices = std::make_shared<const VertexStreams>(std::move(vertices));
    draw.full().orders.push_back({.indices = Shared<std::uint32_t>({0, 1, 2, 2, 1, 3})});
    Draw other = draw;
    other.full().orders.front().indices = Shared<std::uint32_t>({2, 3, 4});
    scene_ = testing::scene_of({draw, other});
    mesh_ = *joined_mesh(scene_, std::vector<DrawId>{0, 1}, analyses_);
  }

  float value(const CutDraw& draw, std::string_view semantic, std::size_t vertex, std::size_t component) const {
    return decode_component(*draw.vertices->find(semantic), vertex, component);
  }

  const CollapseSequence sequence_{
      .collapses = {{0, 1, 0.25f, 0.1f}}, .pairs = {{0, 1}}, .first_pair = {0, 1}, .places = {0.75f, 0, 0.5f}};
  Analyses analyses_;
  Scene scene_;
  JoinedMesh mesh_;
};

TEST_F(Cut, NothingCollapsedIsFullDetail) {
  const std::vector<CutDraw> full = cut(sequence_, 0, collapsed(sequence_, 0, mesh_), mesh_);
  EXPECT_EQ(full[0].vertices->stamp(), scene_.draws[0].full().vertices->stamp());
  EXPECT_EQ(full[0].indices, scene_.draws[0].full().stream().indices);
  EXPECT_EQ(full[1].indices, scene_.draws[1].full().stream().indices);
}

TEST_F(Cut, DrawsThatSharedVerticesStillDo) {
  const std::vector<CutDraw> draws = cut(sequence_, 1, collapsed(sequence_, 1, mesh_), mesh_);
  EXPECT_EQ(draws[0].vertices, draws[1].vertices);
  EXPECT_EQ(draws[0].vertices->count, 4u);
  EXPECT_EQ(draws[0].indices, Shared<std::uint32_t>({1, 0, 2}));
  EXPECT_EQ(draws[1].indices, Shared<std::uint32_t>({1, 2, 3}));
}

TEST_F(Cut, AttributesAreBlendedInTheirFormats) {
  const CutDraw draw = cut(sequence_, 1, collapsed(sequence_, 1, mesh_), mesh_).front();
  EXPECT_EQ(value(draw, "POSITION", 0, 0), 0.75f);
  EXPECT_EQ(value(draw, "POSITION", 0, 2), 0.5f);
  const float x = value(draw, "NORMAL", 0, 0), y = value(draw, "NORMAL", 0, 1);
  EXPECT_FLOAT_EQ(x / y, 1.0f / 3);
  EXPECT_FLOAT_EQ(std::hypot(x, y), 1);
  EXPECT_EQ(value(draw, "COLOR_0", 0, 0), 191 / 255.0f);
  EXPECT_EQ(value(draw, "COLOR_0", 0, 1), 75 / 255.0f);
  EXPECT_EQ(value(draw, "_PART", 0, 0), 8);  // a number that names something is not blended
  const VertexStream& target = draw.vertices->morph_targets[0][0];
  EXPECT_EQ(decode_component(target, 0, 0), 1);
  EXPECT_EQ(decode_component(target, 0, 1), 3);
}

TEST_F(Cut, WeightsOfJointsSumUpToOne) {
  const CutDraw draw = cut(sequence_, 1, collapsed(sequence_, 1, mesh_), mesh_).front();
  EXPECT_EQ(value(draw, "JOINTS_0", 0, 0), 3);  // .75 * 200
  EXPECT_EQ(value(draw, "JOINTS_0", 0, 1), 2);
  EXPECT_EQ(value(draw, "JOINTS_0", 0, 2), 1);
  int sum = 0;
  for (std::size_t c = 0; c < 4; ++c) sum += std::lround(255 * value(draw, "WEIGHTS_0", 0, c));
  EXPECT_EQ(sum, 255);
}

/// A third draw, of its own vertices, has a vertex where vertex 1 is. No pair of the collapse names it.
TEST_F(Cut, SeamsThatWereClosedStayClosedInPoses) {
  Draw beside = scene_.draws[0];
  auto vertices = std::make_shared<VertexStreams>(*beside.full().vertices);
  for (VertexStream& of : vertices->base) {
    if (of.semantic != "POSITION") continue;
    of = stream<float>("POSITION", Component::float32, 3, false, {9, 0, 0, 1, 0, 0, 9, 1, 0, 8, 1, 0, 8, 2, 0});
  }
  beside.full().vertices = std::move(vertices);
  const Scene scene = testing::scene_of({scene_.draws[0], beside});
  const JoinedMesh mesh = *joined_mesh(scene, std::vector<DrawId>{0, 1}, analyses_);
  const std::vector<CutDraw> draws = cut(sequence_, 1, collapsed(sequence_, 1, mesh), mesh);
  for (const char* semantic : {"POSITION", "JOINTS_0", "WEIGHTS_0"}) {
    for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(value(draws[1], semantic, 1, c), value(draws[0], semantic, 0, c));
  }
  EXPECT_EQ(decode_component(draws[1].vertices->morph_targets[0][0], 1, 0), 1);
  EXPECT_EQ(decode_component(draws[1].vertices->morph_targets[0][0], 1, 1), 3);
  for (std::size_t c = 0; c < 3; ++c) {  // what does not move it stays
    EXPECT_EQ(value(draws[1], "NORMAL", 1, c), c == 1 ? 1 : 0);
  }
  EXPECT_EQ(value(draws[1], "COLOR_0", 1, 0), 1);
}

TEST_F(Cut, WhatDidNotChangeKeepsItsBytes) {
  const CutDraw draw = cut(sequence_, 1, collapsed(sequence_, 1, mesh_), mesh_).front();
  for (std::size_t s = 0; s < draw.vertices->base.size(); ++s) {
    const VertexStream& now = draw.vertices->base[s];
    const VertexStream& was = mesh_.streams[0]->base[s];
    EXPECT_EQ(std::memcmp(now.bytes.view().data() + now.format.bytes, was.bytes.view().data() + 2 * was.format.bytes,
                          std::size_t{3} * now.format.bytes),
              0)
        << now.semantic;
  }
}

}  // namespace
}  // namespace foredraw::cut_test

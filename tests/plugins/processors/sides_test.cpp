#include "plugins/processors/sides/sides.h"

#include "plugins/processors/sides/needed_sides.h"
#include "plugins/processors/sides/side_search.h"
#include "plugins/processors/sides/surrounding.h"
#include "plugins/processors/sides/turned_vertices.h"
#include "support/collapses.h"
#include "support/meshes.h"

#include <foredraw/analysis/closed_surfaces.h>
#include <foredraw/image/found_traits.h>
#include <foredraw/viewing/view_directions.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <gtest/gtest.h>

#include <cstring>

namespace foredraw::sides_test {
namespace {

using processors::sides::Side;
using testing::moved;
using testing::TestMesh;

/// Outwards: a box has 12 triangles, an open one 10.
TestMesh box(float size = 1, bool is_open = false) {
  TestMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.positions.push_back(size * glm::vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
  }
  mesh.indices = {0, 2, 1, 1, 2, 3, 0, 1, 4, 1, 5, 4, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5, 2, 6, 3, 3, 6, 7};
  if (!is_open) mesh.indices.insert(mesh.indices.end(), {4, 5, 6, 5, 7, 6});
  return mesh;
}

TestMesh inside_out(TestMesh mesh) {
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
  return mesh;
}

/// Bent so far that nobody sees through; outwards.
TestMesh tube(std::uint32_t slices) {
  TestMesh mesh = testing::torus(slices, 12, 1, 0.15f);
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const glm::vec3 at = mesh.positions[mesh.indices[i]];
    if (at.x < 0 || at.z < 0) kept.insert(kept.end(), mesh.indices.begin() + i, mesh.indices.begin() + i + 3);
  }
  mesh.indices = kept;
  return mesh;
}

Scene double_sided(std::vector<TestMesh> meshes) {
  std::vector<Draw> draws;
  for (const TestMesh& mesh : meshes) {
    draws.push_back(testing::draw_of(mesh, "draw" + std::to_string(draws.size())));
    draws.back().material = 0;
  }
  Scene scene = testing::scene_of(std::move(draws));
  scene.materials.resize(1);
  scene.materials[0].double_sided = true;
  find_traits(scene);
  return scene;
}

processors::sides::SideSearchOptions searched() {
  processors::sides::SideSearchOptions options{.rays = 512, .checks = 30, .views = {{}, 96}};
  for (const glm::dvec3& direction : fibonacci_directions(40)) options.views.views.push_back({direction});
  return options;
}

std::vector<Side> wanted(const Scene& scene, DrawId id = 0) {
  testing::RunFixture fixture;
  const DrawId asked[] = {id};
  return processors::sides::find_sides(scene, asked, searched(), fixture.analyses, fixture.executor).wanted.at(id);
}

std::size_t count(const std::vector<Side>& all, Side side) {
  return static_cast<std::size_t>(std::ranges::count(all, side));
}

TEST(SidesClosed, TellsBodiesFromSheets) {
  const auto closed = [](const TestMesh& mesh) {
    const std::vector<bool> is = closed_outwards(mesh.positions, mesh.indices);
    return static_cast<std::size_t>(std::ranges::count(is, true));
  };
  EXPECT_EQ(closed(box()), 12u);
  EXPECT_EQ(closed(inside_out(box())), 0u);
  EXPECT_EQ(closed(box(1, true)), 0u);
  EXPECT_EQ(closed(moved(box(), {1000, 2000, -5000})), 12u);
  EXPECT_EQ(closed(testing::joined(box(), moved(inside_out(box()), {5, 0, 0}))), 12u);
  EXPECT_EQ(closed(testing::grid(3, 3)), 0u);
  TestMesh one_turned = box();
  std::swap(one_turned.indices[1], one_turned.indices[2]);
  EXPECT_EQ(closed(one_turned), 0u);
  TestMesh far = box();
  far.positions[3].x = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(closed(far), 0u);
}

TEST(Sides, OfAClosedBodyOnlyTheFrontsAreSeen) {
  EXPECT_EQ(count(wanted(double_sided({box()})), processors::sides::front), 12u);
  EXPECT_EQ(count(wanted(double_sided({testing::torus(20, 12)})), processors::sides::front), 20u * 12 * 2);
}

TEST(Sides, OfAnOpenBodyTheInsideIsSeen) {
  const std::vector<Side> open = wanted(double_sided({box(1, true)}));
  EXPECT_EQ(count(open, processors::sides::both), 10u);
  const std::vector<Side> hose = wanted(double_sided({tube(40)}));
  EXPECT_GT(count(hose, processors::sides::both), 0u);
  EXPECT_GT(count(hose, processors::sides::front), 0u);
}

TEST(Sides, WhatIsInsideOutIsTurned) {
  EXPECT_EQ(count(wanted(double_sided({inside_out(box())})), processors::sides::back), 12u);
  const std::vector<Side> two = wanted(double_sided({testing::joined(box(), moved(inside_out(box()), {5, 0, 0}))}));
  EXPECT_EQ(count(two, processors::sides::front), 12u);
  EXPECT_EQ(count(two, processors::sides::back), 12u);
}

TEST(Sides, ASheetNeedsBoth) {
  EXPECT_EQ(count(wanted(double_sided({testing::grid(4, 4)})), processors::sides::both), 32u);
}

/// A hole that no picture of 96 pixels shows.
TEST(Sides, RaysFindWhatPicturesMiss) {
  TestMesh room = testing::sphere(64, 33);
  room.indices.erase(room.indices.begin() + 3000, room.indices.begin() + 3003);
  EXPECT_GT(count(wanted(double_sided({room})), processors::sides::both), 0u);
}

TEST(Sides, SingleSidedMeshesDrawEachSideOnce) {
  const std::vector<std::uint32_t> indices = {0, 1, 2, 2, 1, 3, 4, 5, 6};
  const Side sides[] = {processors::sides::both, processors::sides::front, processors::sides::back};
  const SingleSided made = single_sided(indices, 7, sides);
  EXPECT_EQ(made.triangles, (std::vector<std::uint32_t>{0, 1, 0, 2}));
  EXPECT_EQ(made.copies, (std::vector<std::uint32_t>{0, 2, 1, 4, 6, 5}));
  EXPECT_EQ(made.indices, (std::vector<std::uint32_t>{0, 1, 2, 2, 1, 3, 7, 8, 9, 10, 11, 12}));
  EXPECT_EQ(made.added, 1u);
  EXPECT_EQ(made.turned, 1u);
}

Shared<std::byte> floats(const std::vector<float>& values) {
  std::vector<std::byte> bytes(values.size() * 4);
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return Shared(std::move(bytes));
}

TEST(Sides, CopiesHaveTheirNormalsTurned) {
  VertexStreams streams;
  streams.count = 2;
  streams.base = {{"POSITION", {Component::float32, 3, false, 12}, floats({1, 2, 3, 4, 5, 6})},
                  {"NORMAL",
                   {Component::int8, 3, true, 4},
                   Shared(std::vector<std::byte>{std::byte{1}, std::byte{0x80}, std::byte{0}, std::byte{7},
                                                 std::byte{5}, std::byte{6}, std::byte{7}, std::byte{9}})},
                  {"TANGENT", {Component::float32, 4, false, 16}, floats({1, 0, 0, 1, 0, 1, 0, -1})}};
  streams.morph_targets = {{{"NORMAL", {Component::float32, 3, false, 12}, floats({0, 0, 1, 0, 2, 0})}}};
  const std::uint32_t copies[] = {1, 0};
  const auto made = processors::sides::with_turned_copies(streams, copies);
  EXPECT_EQ(made->count, 4u);
  EXPECT_EQ(made->base[0].bytes, floats({1, 2, 3, 4, 5, 6, 4, 5, 6, 1, 2, 3}));
  EXPECT_EQ(decode_component(made->base[1], 2, 0), decode_component(made->base[1], 1, 0) * -1);
  EXPECT_EQ(static_cast<int>(made->base[1].bytes.view()[3 * 4 + 1]), 127);
  EXPECT_EQ(static_cast<int>(made->base[1].bytes.view()[3 * 4 + 3]), 7);  // padding is no component
  EXPECT_EQ(made->base[2].bytes, floats({1, 0, 0, 1, 0, 1, 0, -1, -0.f, -1, -0.f, 1, -1, -0.f, -0.f, -1}));
  EXPECT_EQ(made->morph_targets[0][0].bytes, floats({0, 0, 1, 0, 2, 0, -0.f, -2, -0.f, -0.f, -0.f, -1}));
}

TEST(Sides, CopiesOfTangentsOfNoLengthGetOne) {
  VertexStreams streams;
  streams.count = 2;
  streams.base = {{"NORMAL", {Component::float32, 3, false, 12}, floats({0, 3, 4, 1, 0, 0})},
                  {"TANGENT", {Component::float32, 4, false, 16}, floats({0, 0, 0, 1, 0, 0, 0, -1})}};
  const std::uint32_t copies[] = {0, 1};
  const auto made = processors::sides::with_turned_copies(streams, copies);
  const float tangents[] = {0, 0, 0, 1, 0, 0, 0, -1, 0, .8f, -.6f, -1, 0, -1, 0, 1};
  for (std::size_t i = 0; i < std::size(tangents); ++i)
    EXPECT_EQ(decode_component(made->base[1], i / 4, i % 4), tangents[i]) << i;
}

Scene placed(std::vector<TestMesh> meshes, std::vector<glm::vec3> at) {
  Scene scene = double_sided(std::move(meshes));
  for (MeshId mesh = 0; mesh < scene.meshes.size(); ++mesh) {
    Node node;
    node.mesh = mesh;
    node.transform.translation = at[mesh];
    scene.nodes.push_back(node);
  }
  return scene;
}

TEST(SidesSurrounding, SkiesAndRoomsSurroundWhatIsInThem) {
  const Executor executor(2);
  const Scene sky = placed({testing::sphere(24, 13, 100), box()}, {{0, 0, 0}, {10, 0, 0}});
  EXPECT_EQ(processors::sides::surrounding_draws(sky, executor), (std::vector<bool>{true, false}));
  const Scene room = placed({inside_out(box(10)), box(), box()}, {{0, 0, 0}, {3, 0, 0}, {-3, 1, 0}});
  EXPECT_EQ(processors::sides::surrounding_draws(room, executor),
            (std::vector<bool>{false, false, false}));  // its fronts are seen
  const Scene helmet = placed({testing::sphere(24, 13, 1.2f), box(0.7f)}, {{0, 0, 0}, {0, 0, 0}});
  EXPECT_EQ(processors::sides::surrounding_draws(helmet, executor), (std::vector<bool>{false, false}));
  Scene tunnel = placed({testing::torus(40, 12, 10, 2)}, {{0, 0, 0}});
  EXPECT_EQ(processors::sides::surrounding_draws(tunnel, executor), (std::vector<bool>{false}));
  Node camera;
  camera.has_camera = true;
  camera.transform.translation = {10, 0, 0};
  tunnel.nodes.push_back(camera);
  EXPECT_EQ(processors::sides::surrounding_draws(tunnel, executor), (std::vector<bool>{true}));
}

}  // namespace
}  // namespace foredraw::sides_test

// The stage over draws, meshes and skins: what is looked at together, and what stays shared.
#include "plugins/processors/wire_radius/wires_product.h"

#include "benchmarks/wire_radius/wire_sets.h"
#include "support/closed_bodies.h"
#include "support/gltf_builder.h"
#include "support/meshes.h"
#include "support/staged.h"

#include <foredraw/io/gltf/gltf.h>
#include <foredraw/wires/wires.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace foredraw::wire_radius_stage_test {
namespace {

using ::testing::HasSubstr;
using testing::TestMesh;

constexpr std::uint32_t sides = 8;

/// Twelve times as long as wide, in so many rings apart by its width.
TestMesh tube(std::uint32_t first_ring, std::uint32_t last_ring) {
  TestMesh mesh;
  for (std::uint32_t r = first_ring; r <= last_ring; ++r) {
    for (std::uint32_t s = 0; s < sides; ++s) {
      const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(s) / sides;
      mesh.positions.emplace_back(static_cast<float>(r), 0.5f * std::cos(angle), 0.5f * std::sin(angle));
    }
  }
  for (std::uint32_t r = 0; r < last_ring - first_ring; ++r) {
    for (std::uint32_t s = 0; s < sides; ++s) {
      const std::uint32_t a = r * sides + s, b = r * sides + (s + 1) % sides, c = a + sides, d = b + sides;
      mesh.indices.insert(mesh.indices.end(), {a, b, d, a, d, c});
    }
  }
  return mesh;
}

template <class T>
VertexStream stream_of(const char* semantic, Component component, const std::vector<T>& values) {
  const auto bytes = std::as_bytes(std::span(values));
  return {semantic, {component, 4, false, 4 * sizeof(T)}, Shared<std::byte>({bytes.begin(), bytes.end()})};
}

/// Half by one joint and half by another, from end to end more by the second one; but for one vertex, if there is one.
void add_joints(Draw& draw, std::size_t odd_vertex) {
  auto vertices = std::make_shared<VertexStreams>(*draw.full().vertices);
  const std::vector<glm::vec3> positions = decode_vec3(*vertices->find("POSITION"));
  std::vector<std::uint8_t> joints;
  std::vector<float> weights;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const float second = v == odd_vertex ? 0.9f : positions[v].x / 24;
    joints.insert(joints.end(), {0, 1, 0, 0});
    weights.insert(weights.end(), {1 - second, second, 0, 0});
  }
  vertices->base.push_back(stream_of("JOINTS_0", Component::uint8, joints));
  vertices->base.push_back(stream_of("WEIGHTS_0", Component::float32, weights));
  draw.full().vertices = vertices;
}

const Wires* wires_of(const Scene& scene) { return scene.products.find<Wires>(); }

TEST(WireRadiusStage, SkinnedWiresAreTakenWhereRingsFollowTheSameJoints) {
  Scene scene = testing::scene_of(tube(0, 12));
  add_joints(scene.draws[0], ~std::size_t{0});
  const Scene found = testing::run("wire-radius", scene).scene;
  ASSERT_NE(wires_of(found), nullptr);
  EXPECT_EQ(wires_of(found)->draws[0].wires.size(), 1u);

  Scene odd = testing::scene_of(tube(0, 12));
  add_joints(odd.draws[0], 6 * sides + 3);
  const Result bent = testing::run("wire-radius", odd);
  EXPECT_EQ(wires_of(bent.scene), nullptr);
  std::string notes;
  for (const NoteRecord& note : bent.report.stages.at(0).notes) notes += note.message + '\n';
  EXPECT_THAT(notes, HasSubstr("follow different joints"));
}

TEST(WireRadiusStage, WhatIsNamedIsTakenWhateverItsShapeAndNothingElse) {
  Scene scene = testing::scene_of({testing::draw_of(tube(0, 4), "peg"), testing::draw_of(tube(0, 12), "rope")});
  scene.nodes[1].name = "Mast rope";
  const auto taken = [&](const std::string& stage) {
    const Result result = testing::run(stage, scene);
    std::vector<std::string> names;
    if (const Wires* wires = wires_of(result.scene)) {
      for (const DrawWires& draw : wires->draws) names.push_back(result.scene.draws[draw.draw].name);
    }
    return names;
  };
  EXPECT_EQ(taken("wire-radius"), std::vector<std::string>{"rope"});
  EXPECT_EQ(taken("wire-radius(names=\"pe?\")"), std::vector<std::string>{"peg"});
  EXPECT_EQ(taken("wire-radius(names=\"p*, Mast*\")"), (std::vector<std::string>{"peg", "rope"}));
  EXPECT_THAT(to_text(testing::run("wire-radius(names=\"cable*\")", scene).report), HasSubstr("`names` asks for"));
}

TEST(WireRadiusStage, MorphedDrawsAreLeftAloneAndTold) {
  Scene scene = testing::scene_of(tube(0, 12));
  auto vertices = std::make_shared<VertexStreams>(*scene.draws[0].full().vertices);
  vertices->morph_targets.push_back({*vertices->find("POSITION")});
  scene.draws[0].full().vertices = vertices;
  scene.draws[0].traits.add(traits::morphed);
  const Result result = testing::run("wire-radius", scene);
  EXPECT_EQ(wires_of(result.scene), nullptr);
  EXPECT_THAT(to_text(result.report), HasSubstr("morph targets may move its vertices"));
}

/// Each half of six times its width is none; of a character in two meshes it is one wire.
TEST(WireRadiusStage, AWireMayGoOnInAnotherMeshOfTheSameSkin) {
  Scene scene = testing::scene_of(tube(0, 6));
  const Scene other = testing::scene_of(tube(6, 12));
  scene.draws.push_back(other.draws[0]);
  scene.meshes.push_back(other.meshes[0]);
  scene.meshes[1].draws = {1};
  scene.nodes.push_back(other.nodes[0]);
  scene.nodes[1].mesh = 1;
  scene.roots = {0, 1};
  EXPECT_EQ(wires_of(testing::run("wire-radius", scene).scene), nullptr);
  for (Draw& draw : scene.draws) add_joints(draw, ~std::size_t{0});
  scene.nodes.resize(4);
  scene.skins.push_back({"both", {2, 3}, {glm::mat4(1), glm::mat4(1)}});
  scene.nodes[0].skin = scene.nodes[1].skin = 0;
  const Scene found = testing::run("wire-radius", scene).scene;
  ASSERT_NE(wires_of(found), nullptr);
  ASSERT_EQ(wires_of(found)->draws.size(), 2u);
  for (const DrawWires& of : wires_of(found)->draws) EXPECT_NEAR(of.wires[0].length, 12, 0.1);
}

/// One stream, of which one draw shows a wire and the other one a body: they keep sharing it.
TEST(WireRadiusStage, DrawsThatShareVerticesKeepSharingThem) {
  const TestMesh wire = tube(0, 12), both = testing::joined(wire, testing::closed_sphere(24, 12));
  Scene scene = testing::scene_of(both);
  scene.draws.push_back(scene.draws[0]);
  scene.meshes.push_back(scene.meshes[0]);
  scene.meshes[1].draws = {1};
  scene.nodes.push_back(scene.nodes[0]);
  scene.nodes[1].mesh = 1;
  scene.roots = {0, 1};
  const auto split = static_cast<std::ptrdiff_t>(wire.indices.size());
  IndexStream parts[2];
  parts[0].indices = Shared<std::uint32_t>({both.indices.begin(), both.indices.begin() + split});
  parts[1].indices = Shared<std::uint32_t>({both.indices.begin() + split, both.indices.end()});
  for (std::size_t d = 0; d < 2; ++d) scene.draws[d].full().orders[0] = parts[d];
  ASSERT_EQ(scene.draws[0].full().vertices, scene.draws[1].full().vertices);
  const Scene found = testing::run("wire-radius", scene).scene;
  ASSERT_NE(wires_of(found), nullptr);
  ASSERT_EQ(wires_of(found)->draws.size(), 1u);
  EXPECT_EQ(wires_of(found)->draws[0].draw, 0u);
  EXPECT_NE(found.draws[0].full().vertices->find(wire_semantic), nullptr);
  EXPECT_EQ(found.draws[0].full().vertices, found.draws[1].full().vertices);
}

/// As many vertices as 16 bits can name: indices stay as short as they are, and the last vertex is a wire's.
TEST(WireRadiusStage, SixteenBitsStaySixteen) {
  const TestMesh wire = tube(0, 12);
  const std::size_t all = 65535, first = all - wire.positions.size();
  std::vector<float> positions(3 * first, 0);
  for (const glm::vec3& at : wire.positions) positions.insert(positions.end(), {at.x, at.y, at.z});
  std::vector<std::uint16_t> indices;
  for (const std::uint32_t v : wire.indices) indices.push_back(static_cast<std::uint16_t>(first + v));
  testing::GltfBuilder builder;
  const std::size_t at = builder.add_values(positions, "VEC3");
  builder.json["accessors"][at]["min"] = {-1, -1, -1};
  builder.json["accessors"][at]["max"] = {12, 1, 1};
  builder.add_mesh({{"attributes", {{"POSITION", at}}}, {"indices", builder.add_values(indices, "SCALAR")}});
  Diagnostics diagnostics;
  const ProductRows rows{wires_product()};
  const auto scene = read_gltf(builder.glb(), "scene.glb", {}, diagnostics, {.products = rows});
  ASSERT_TRUE(scene) << to_text(diagnostics);
  const Scene found = testing::run("wire-radius", *scene).scene;
  const auto files = encode_gltf(found, "out.glb", diagnostics, {.products = rows});
  ASSERT_TRUE(files && !diagnostics.has_errors()) << to_text(diagnostics);
  const testing::GltfJson json = testing::json_of(files->front().bytes);
  const testing::GltfJson& primitive = json["meshes"][0]["primitives"][0];
  ASSERT_TRUE(primitive["extensions"].contains("FOREDRAW_wires"));
  EXPECT_EQ(json["accessors"][primitive["indices"].get<std::size_t>()]["componentType"], 5123);
  EXPECT_EQ(json["accessors"][primitive["attributes"]["_FOREDRAW_WIRE"].get<std::size_t>()]["count"], all);
  const auto again = read_gltf(files->front().bytes, "out.glb", {}, diagnostics, {.products = rows});
  ASSERT_TRUE(again);
  EXPECT_EQ(*again->products.find<Wires>(), *found.products.find<Wires>());
}

}  // namespace
}  // namespace foredraw::wire_radius_stage_test

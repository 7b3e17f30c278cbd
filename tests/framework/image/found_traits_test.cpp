#include <foredraw/image/found_traits.h>

#include <foredraw/scene/triangle_draw.h>

#include <gtest/gtest.h>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace foredraw::found_traits_test {
namespace {

const std::vector<glm::vec3> corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
const std::vector<std::uint32_t> quad = {0, 1, 2, 0, 2, 3};

/// One quad on one node.
Scene scene_of(std::vector<VertexStream> streams = {}) {
  Scene scene;
  scene.draws = {triangle_draw("quad", corners, quad, std::move(streams))};
  scene.meshes = {{.name = "quad", .draws = {0}}};
  scene.nodes = {{.name = "quad", .mesh = 0}};
  return scene;
}

Traits found(Scene scene) {
  find_traits(scene);
  return scene.draws[0].traits;
}

VertexStream texcoords() { return float_stream("TEXCOORD_0", std::vector<glm::vec2>{{0, 1}, {1, 1}, {1, 0}, {0, 0}}); }

TEST(FindTraits, OfVertices) {
  EXPECT_EQ(found(scene_of()), Traits({traits::triangles}));
  EXPECT_EQ(found(scene_of({texcoords(), float_stream("NORMAL", corners)})),
            Traits({traits::triangles, traits::uv0, traits::normals}));
  Scene points = scene_of();
  points.draws[0].topology = Topology::points;
  EXPECT_EQ(found(points), Traits());
  Scene quantized = scene_of();
  VertexStreams streams;
  streams.count = 4;
  streams.base = {{"POSITION", {Component::int16, 3, true, 8}, Shared<std::byte>(std::vector<std::byte>(32))}};
  quantized.draws[0].levels[0].vertices = std::make_shared<const VertexStreams>(std::move(streams));
  EXPECT_TRUE(found(quantized).has(traits::quantized));
}

TEST(FindTraits, OfMaterials) {
  Scene scene = scene_of({texcoords()});
  scene.draws[0].material = 0;
  scene.materials = {{.alpha_mode = AlphaMode::mask, .double_sided = true}};
  EXPECT_EQ(found(scene), Traits({traits::triangles, traits::uv0, traits::masked, traits::double_sided}));
  scene.materials = {{.alpha_mode = AlphaMode::blend}};
  EXPECT_EQ(found(scene), Traits({traits::triangles, traits::uv0, traits::blended}));
  scene.materials[0].base_colour = Texture{.image = 0};
  EXPECT_TRUE(found(scene).has(traits::sprite));
  scene.materials[0].alpha_mode = AlphaMode::opaque;
  EXPECT_FALSE(found(scene).has(traits::sprite));
  scene.draws[0].frame = SpriteFrame{0, 0, 8, 8};
  EXPECT_TRUE(found(scene).has(traits::sprite)) << "whoever gives it a part of an image says that it is one";
}

TEST(FindTraits, OfNodes) {
  Scene scene = scene_of();
  EXPECT_FALSE(found(scene).has(traits::instanced));
  scene.nodes.push_back({.name = "again", .mesh = 0});
  EXPECT_TRUE(found(scene).has(traits::instanced));
  scene = scene_of();
  scene.nodes[0].instances = Shared<Transform>({Transform(), Transform()});
  EXPECT_TRUE(found(scene).has(traits::instanced));
  scene = scene_of();
  scene.meshes.push_back({.name = "another", .draws = {0}});
  scene.nodes.push_back({.name = "another", .mesh = 1});
  EXPECT_TRUE(found(scene).has(traits::instanced)) << "by another mesh";
}

TEST(FindTraits, OfSkinsAndAnimations) {
  Scene scene = scene_of({float_stream("JOINTS_0", std::vector<glm::vec4>(4))});
  scene.nodes.push_back({.name = "root", .children = {2}});
  scene.nodes.push_back({.name = "tip"});
  scene.skins = {{.name = "skin", .joints = {1, 2}, .inverse_bind_matrices = {glm::mat4(1), glm::mat4(1)}}};
  scene.nodes[0].skin = 0;
  EXPECT_EQ(found(scene), Traits({traits::triangles, traits::skinned}));
  scene.animations = {{.name = "walk", .channels = {{.node = 1}}}};
  EXPECT_TRUE(found(scene).has(traits::animated));

  Scene morphed = scene_of();
  VertexStreams streams = *morphed.draws[0].levels[0].vertices;
  streams.morph_targets = {{float_stream("POSITION", corners)}};
  morphed.draws[0].levels[0].vertices = std::make_shared<const VertexStreams>(std::move(streams));
  EXPECT_EQ(found(morphed), Traits({traits::triangles, traits::morphed}));
  morphed.animations = {{.name = "talk", .channels = {{.node = 0, .path = AnimatedPath::weights}}}};
  EXPECT_EQ(found(morphed), Traits({traits::triangles, traits::morphed, traits::animated}));
}

TEST(FindTraits, WhatStagesMadeStays) {
  Scene scene = scene_of();
  scene.draws[0].traits = {traits::welded};
  EXPECT_EQ(found(scene), Traits({traits::triangles, traits::welded}));
}

}  // namespace
}  // namespace foredraw::found_traits_test

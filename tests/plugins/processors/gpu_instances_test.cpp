#include "plugins/processors/gpu_instances/gpu_instances.h"

#include <foredraw/instances/merged_instances.h>

#include "plugins/processors/gpu_instances/instance_transform.h"
#include "support/edit_product.h"
#include "support/meshes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>

namespace foredraw::gpu_instances_test {
namespace {

Transform at(float x, float y = 0, float z = 0) { return {.translation = {x, y, z}}; }

Node placed(MeshId mesh, const Transform& transform) {
  Node node;
  node.name = "placed " + std::to_string(transform.translation.x);
  node.mesh = mesh;
  node.transform = transform;
  return node;
}

/// One mesh for each count, placed as often, one beside the other.
Scene rows(const std::vector<int>& counts) {
  std::vector<Draw> draws;
  for (std::size_t m = 0; m < counts.size(); ++m) {
    draws.push_back(testing::draw_of(testing::grid(1, 1), "mesh" + std::to_string(m)));
  }
  Scene scene = testing::scene_of(std::move(draws));
  scene.nodes.clear();
  for (MeshId m = 0; m < counts.size(); ++m) {
    for (int i = 0; i < counts[m]; ++i)
      scene.nodes.push_back(placed(m, at(static_cast<float>(i), static_cast<float>(m))));
  }
  return scene;
}

std::vector<DrawId> all_draws(const Scene& scene) {
  std::vector<DrawId> draws;
  for (DrawId id = 0; id < scene.draws.size(); ++id) draws.push_back(id);
  return draws;
}

InstancedNodes instanced(Scene& scene, int least = 2) {
  return gpu_instances(scene, all_draws(scene), {.least = least});
}

std::string told(const InstancedNodes& nodes) {
  std::string text;
  for (const LeftPlaced& left : nodes.left) {
    text += std::to_string(left.mesh) + " x " + std::to_string(left.nodes) + ": " + left.why + '\n';
  }
  return text;
}

/// Each placed mesh: its number, and the places in the world, sorted.
using Places = std::vector<std::pair<MeshId, std::array<float, 16>>>;
Places places_of(const Scene& scene) {
  Places places;
  const std::vector<glm::mat4> world = world_transforms(scene);
  const auto add = [&](MeshId mesh, const glm::mat4& m) {
    std::array<float, 16> numbers{};
    std::copy_n(&m[0][0], 16, numbers.begin());
    places.emplace_back(mesh, numbers);
  };
  for (NodeId n = 0; n < scene.nodes.size(); ++n) {
    const Node& node = scene.nodes[n];
    if (!node.mesh) continue;
    if (node.instances.empty()) add(*node.mesh, world[n]);
    for (const Transform& instance : node.instances.view()) add(*node.mesh, world[n] * instance.matrix());
  }
  std::ranges::sort(places);
  return places;
}

TEST(GpuInstances, NodesThatPlaceAMeshBecomeOne) {
  Scene scene = rows({6, 1, 5});
  const Scene before = scene;
  const InstancedNodes made = instanced(scene, 5);
  ASSERT_EQ(made.meshes.size(), 2u);
  EXPECT_EQ(made.meshes[0].node, 12u);
  EXPECT_EQ(made.meshes[0].instances, 6u);
  EXPECT_EQ(made.meshes[1].mesh, 2u);
  EXPECT_EQ(made.meshes[1].node, 13u);
  EXPECT_TRUE(made.left.empty()) << told(made);
  ASSERT_EQ(scene.nodes.size(), 14u);
  EXPECT_EQ(scene.nodes[12].name, scene.meshes[0].name);
  EXPECT_EQ(scene.nodes[12].mesh, 0u);
  EXPECT_TRUE(scene.nodes[12].children.empty());
  ASSERT_EQ(scene.nodes[12].instances.size(), 6u);
  for (NodeId n = 0; n < 12; ++n) {
    EXPECT_EQ(scene.nodes[n].name, before.nodes[n].name);
    EXPECT_EQ(scene.nodes[n].local(), before.nodes[n].local());
    EXPECT_EQ(scene.nodes[n].mesh.has_value(), n == 6);
  }
  EXPECT_EQ(places_of(scene), places_of(before)) << "roots keep their numbers";
  EXPECT_TRUE(instanced(scene).meshes.empty()) << "twice is once";
}

TEST(GpuInstances, TooFewStay) {
  Scene scene = rows({4, 5});
  const InstancedNodes made = instanced(scene, 5);
  ASSERT_EQ(made.meshes.size(), 1u);
  EXPECT_EQ(told(made), "0 x 4: fewer than 5 are not replaced (option least)\n");
}

TEST(GpuInstances, MeshesStayThatMayNotBeChangedWhole) {
  Scene scene = rows({3, 3});
  scene.meshes[0].draws = {0, 1};
  scene.meshes[1].draws = {1};
  const std::vector<DrawId> first{0};
  const InstancedNodes made = gpu_instances(scene, first, {.least = 2});
  EXPECT_TRUE(made.meshes.empty());
  EXPECT_EQ(told(made), "0 x 3: a primitive of the mesh must stay as it is\n")
      << "who gave no draw of a mesh knows that";
}

TEST(GpuInstances, DrawsStayWhoseNodesAreNotAlike) {
  const auto why = [](auto&& change) {
    Scene scene = rows({3});
    change(scene, scene.draws[0]);
    const InstancedNodes made = instanced(scene);
    return made.meshes.empty() ? told(made) : "taken";
  };
  EXPECT_EQ(why([](Scene&, Draw& draw) { draw.topology = Topology::lines; }), "taken");
  EXPECT_EQ(why([](Scene& scene, Draw& draw) {
              scene.materials.push_back({.alpha_mode = AlphaMode::mask});
              draw.material = 0;
            }),
            "taken");
  EXPECT_EQ(why([](Scene& scene, Draw& draw) {
              scene.materials.push_back({.alpha_mode = AlphaMode::blend});
              draw.material = 0;
            }),
            "0 x 3: they are blended, so the order of draws is visible\n");
  EXPECT_EQ(why([](Scene&, Draw& draw) { draw.traits.add(traits::skinned); }), "0 x 3: they are skinned\n");
  EXPECT_EQ(why([](Scene&, Draw& draw) {
              VertexStreams streams = *draw.levels[0].vertices;
              streams.morph_targets.emplace_back();
              draw.levels[0].vertices = std::make_shared<const VertexStreams>(streams);
            }),
            "0 x 3: they have morph targets\n");
  EXPECT_EQ(why([](Scene&, Draw& draw) { draw.levels[0].orders.push_back(draw.levels[0].orders[0]); }),
            "0 x 3: they have several orders, of which each node picks its own\n");
}

TEST(GpuInstances, NodesStayThatAreMoreThanAPlace) {
  Scene scene = rows({16});
  scene.nodes[2].weights = {1};
  scene.nodes[3].instances = Shared<Transform>(std::vector<Transform>(2));
  scene.nodes[4].keeps_mesh = true;
  scene.skins.push_back({.name = "skin", .joints = {5}, .inverse_bind_matrices = {glm::mat4(1)}});
  scene.nodes[6].skin = 0;
  scene.nodes[7].children = {8};  // below one that is moved
  scene.animations.push_back({.name = "move", .channels = {{.node = 7}}});
  scene.nodes[9].transform.scale = {1, -1, 1};
  scene.nodes[10].transform.scale = {1, 0, 1};
  scene.nodes[11].transform.translation.x = std::numeric_limits<float>::infinity();
  scene.nodes[12].matrix = glm::mat4(1, 0, 0, 0, 0.5f, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
  scene.nodes[13].transform.scale = {-1, -1, 1};
  MergedInstances merged;
  merged.places = Shared<MergedPlace>({{14, 0, 0}});
  testing::edit<MergedDraws>(scene)->sets.push_back(merged);
  const Scene before = scene;
  const InstancedNodes made = instanced(scene);
  ASSERT_EQ(made.meshes.size(), 1u);
  EXPECT_EQ(told(made),
            "0 x 3: an animation or a joint moves them\n"
            "0 x 1: an extension or another scene refers to them, or no scene shows them\n"
            "0 x 1: merged draws draw them\n"
            "0 x 1: their transforms are not finite\n"
            "0 x 1: their transforms flatten them\n"
            "0 x 1: their transforms mirror them\n"
            "0 x 1: their transforms shear them\n"
            "0 x 1: they are instanced already\n"
            "0 x 1: they are skinned\n"
            "0 x 1: they have morph weights\n");
  std::vector<NodeId> emptied;
  for (NodeId n = 0; n < 16; ++n) {
    if (!scene.nodes[n].mesh) emptied.push_back(n);
  }
  EXPECT_EQ(emptied, (std::vector<NodeId>{0, 1, 13, 15}));
  EXPECT_EQ(scene.nodes[16].instances.view()[2].scale, glm::vec3(-1, -1, 1)) << "turned, not mirrored";
}

Transform random_transform(Random& random) {
  const auto unit = [&] { return static_cast<float>(random.unit()); };
  Transform transform;
  transform.translation = {100 * unit(), 10 * unit(), 100 * unit()};
  transform.rotation =
      glm::angleAxis(6 * unit(), glm::normalize(glm::vec3(unit() + 0.1f, unit() - 0.5f, unit() - 0.5f)));
  transform.scale = glm::vec3(0.5f + unit());
  return transform;
}

/// Below turned and scaled parents, three deep.
TEST(GpuInstances, PlacesBelowOthersAreDecomposed) {
  Scene scene = rows({0});
  Random random(5);
  for (NodeId row = 0; row < 500; ++row) {
    Node root, middle;
    root.transform = random_transform(random);
    middle.matrix = random_transform(random).matrix();
    root.children = {3 * row + 1};
    middle.children = {3 * row + 2};
    Transform last = random_transform(random);
    last.scale *= glm::vec3(1, 2, 0.01f);
    scene.nodes.insert(scene.nodes.end(), {root, middle, placed(0, last)});
  }
  const Scene before = scene;
  const InstancedNodes made = instanced(scene);
  ASSERT_EQ(made.meshes.size(), 1u);
  EXPECT_EQ(made.meshes[0].instances, 500u) << told(made);
  const std::vector<glm::mat4> world = world_transforms(before);
  for (std::size_t i = 0; i < 500; ++i) {
    const glm::mat4 is = scene.nodes.back().instances.view()[i].matrix(), was = world[3 * i + 2];
    float greatest = 0, difference = 0;
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 4; ++row) {
        if (column < 3) greatest = std::max(greatest, std::abs(was[column][row]));
        difference = std::max(difference, std::abs(was[column][row] - is[column][row]));
      }
    }
    EXPECT_LE(difference, 1e-6f * greatest) << i;
    EXPECT_EQ(is[3], was[3]);
  }
}

/// A turned mesh below a parent that stretches unevenly.
TEST(GpuInstances, WhatParentsShearStays) {
  Node node = placed(0, {.rotation = glm::angleAxis(0.5f, glm::vec3(0, 0, 1))});
  const glm::mat4 stretched = glm::scale(glm::mat4(1), glm::vec3(1, 2, 1)) * node.local();
  EXPECT_EQ(instance_transform(node, false, stretched).why_not, "their transforms shear them");
  const glm::mat4 hardly = glm::scale(glm::mat4(1), glm::vec3(1, 1.00001f, 1)) * node.local();
  EXPECT_EQ(instance_transform(node, false, hardly).why_not, "their transforms shear them");
  const glm::mat4 evenly = glm::scale(glm::mat4(1), glm::vec3(2)) * node.local();
  EXPECT_EQ(instance_transform(node, false, evenly).why_not, "");
}

TEST(GpuInstances, OfNothingIsNothing) {
  Scene scene;
  EXPECT_TRUE(instanced(scene).meshes.empty());
  scene = rows({0});
  EXPECT_TRUE(instanced(scene).left.empty());
}

}  // namespace
}  // namespace foredraw::gpu_instances_test

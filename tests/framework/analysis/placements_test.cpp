#include <foredraw/analysis/placements.h>

#include "support/meshes.h"

#include <gtest/gtest.h>

namespace foredraw::placements_test {
namespace {

/// A mesh placed by three nodes, two of which stand at one place, turned each its own way.
Scene placed() {
  Scene scene = testing::scene_of({testing::draw_of(testing::grid(1, 1), "tile")});
  scene.nodes.clear();
  for (int i = 0; i < 3; ++i) {
    Node node;
    node.mesh = 0;
    node.transform.translation = {i / 2, 0, 0};
    node.transform.rotation =
        glm::quat(1, 0, static_cast<float>(i), 0) / glm::length(glm::quat(1, 0, static_cast<float>(i), 0));
    scene.nodes.push_back(node);
  }
  return scene;
}

/// The same by instances of one node, in another sequence.
Scene instanced() {
  Scene scene = placed();
  std::vector<Transform> instances;
  for (const std::size_t i : {2, 0, 1}) {
    instances.push_back(scene.nodes[i].transform);
    scene.nodes[i].mesh.reset();
  }
  scene.nodes.push_back({.mesh = 0, .instances = Shared<Transform>(std::move(instances))});
  return scene;
}

TEST(Placements, AreTheSameWhateverNodesShowThem) {
  EXPECT_EQ(placement_difference(placed(), placed()), "");
  EXPECT_EQ(placement_difference(placed(), instanced()), "");
  EXPECT_EQ(placement_difference(instanced(), placed()), "");
}

TEST(Placements, DifferWhereOneIsMovedTurnedLostOrThereTwice) {
  for (const int change : {0, 1, 2, 3, 4}) {
    Scene after = instanced();
    std::vector<Transform> all(after.nodes.back().instances.view().begin(), after.nodes.back().instances.view().end());
    if (change == 0) all[1].translation.x += 0.01f;
    if (change == 1) all[1].scale.y = -1;
    if (change == 2) all.pop_back();
    if (change == 3) all.push_back(all[0]);
    if (change == 4) after.nodes.back().is_shown = false;
    after.nodes.back().instances = Shared<Transform>(std::move(all));
    EXPECT_NE(placement_difference(placed(), after), "") << change;
  }
}

TEST(Placements, MayBeRoundedOtherwise) {
  Scene after = placed();
  after.nodes[1].transform.rotation.y *= 1 + 1e-7f;
  EXPECT_EQ(placement_difference(placed(), after), "");
}

}  // namespace
}  // namespace foredraw::placements_test

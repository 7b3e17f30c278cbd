#include <foredraw/analysis/moved_nodes.h>

#include <gtest/gtest.h>

namespace foredraw::moved_nodes_test {
namespace {

TEST(MovedNodes, AreThoseThatAnimationsMoveAndJointsWithAllBelow) {
  Scene scene;
  scene.nodes.resize(7);
  scene.nodes[0].children = {1, 2};
  scene.nodes[2].children = {3};
  scene.nodes[4].children = {5};
  EXPECT_EQ(moved_nodes(scene), std::vector<bool>(7, false));
  Animation turning;
  turning.channels = {{.node = 2}, {.node = 6, .path = AnimatedPath::weights}};
  scene.animations = {turning};
  Skin skin;
  skin.joints = {4};
  scene.skins = {skin};
  EXPECT_EQ(moved_nodes(scene), (std::vector<bool>{false, false, true, true, true, true, false}));
}

TEST(MovedNodes, NodesThatAreNotThereDoNotMove) {
  Scene scene;
  Skin skin;
  skin.joints = {0, 1};
  scene.skins = {skin};
  EXPECT_EQ(moved_nodes(scene), std::vector<bool>{});
}

}  // namespace
}  // namespace foredraw::moved_nodes_test

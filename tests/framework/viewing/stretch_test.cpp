#include <foredraw/viewing/stretch.h>

#include "support/meshes.h"

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

namespace foredraw::stretch_test {
namespace {

double stretch(const Scene& scene, std::optional<NodeId> node) {
  return most_stretch(scene, {0, node}, posed_nodes(scene));
}

TEST(MostStretch, is_one_without_a_node) {
  Scene scene = testing::scene_of(testing::grid(1, 1));
  scene.nodes[0].transform.scale = {3, 3, 3};
  EXPECT_EQ(stretch(scene, {}), 1);
}

TEST(MostStretch, is_that_along_the_longest_axis_however_it_is_turned) {
  Scene scene = testing::scene_of(testing::grid(1, 1));
  scene.nodes[0].transform.scale = {-3, 0.5f, 2};
  scene.nodes[0].transform.rotation = glm::angleAxis(0.7f, glm::vec3(0.6f, 0, 0.8f));
  EXPECT_NEAR(stretch(scene, 0), 3, 1e-5);
}

TEST(MostStretch, is_never_less_than_what_a_sheared_line_becomes) {
  Scene scene = testing::scene_of(testing::grid(1, 1));
  scene.nodes[0].matrix = glm::mat4({1, 0, 0, 0}, {1.5f, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1});
  EXPECT_GE(stretch(scene, 0), 2);  // (0.5, 0.87) becomes 2 long
  EXPECT_LT(stretch(scene, 0), 2.2);
}

TEST(MostStretch, of_a_skin_is_that_of_the_joint_that_stretches_most) {
  Scene scene = testing::scene_of(testing::grid(1, 1));
  Node joint;
  joint.transform.scale = {4, 4, 4};
  scene.nodes.push_back(joint);
  scene.nodes.push_back({});
  scene.nodes[0].skin = 0;
  scene.nodes[0].transform.scale = {100, 100, 100};  // which does not matter
  scene.skins.push_back({"", {1, 2}, {glm::scale(glm::mat4(1), glm::vec3(0.5f)), glm::mat4(1)}});
  EXPECT_NEAR(stretch(scene, 0), 2, 1e-6);
}

}  // namespace
}  // namespace foredraw::stretch_test

#include <foredraw/scene/scene.h>

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

namespace foredraw::scene_test {
namespace {

glm::vec3 at(const glm::mat4& transform, glm::vec3 point) { return glm::vec3(transform * glm::vec4(point, 1)); }

void expect_near(const glm::vec3& a, const glm::vec3& b) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], 1e-5f) << "component " << c;
}

Node translated(glm::vec3 by, std::vector<NodeId> children = {}) {
  Node node;
  node.transform.translation = by;
  node.children = std::move(children);
  return node;
}

TEST(WorldTransforms, ScaleThenRotationThenTranslation) {
  Node node;
  node.transform.translation = {10, 20, 30};
  node.transform.rotation = glm::quat(std::sqrt(0.5f), 0, 0, std::sqrt(0.5f));  // a quarter turn about z: x becomes y
  node.transform.scale = {2, 3, 4};
  Scene scene;
  scene.nodes = {node};
  expect_near(at(world_transforms(scene)[0], {1, 0, 0}), {10, 22, 30});
  expect_near(at(world_transforms(scene)[0], {0, 1, 0}), {7, 20, 30});
  expect_near(at(world_transforms(scene)[0], {0, 0, 1}), {10, 20, 34});
}

TEST(WorldTransforms, MatrixStandsForTheTransform) {
  Node node = translated({5, 5, 5});
  node.matrix = glm::translate(glm::mat4(1), glm::vec3(1, 2, 3));
  Scene scene;
  scene.nodes = {node};
  expect_near(at(world_transforms(scene)[0], {0, 0, 0}), {1, 2, 3});
}

TEST(WorldTransforms, ParentsActAfterTheirChildren) {
  Node turned = translated({1, 0, 0}, {0});
  turned.transform.rotation = glm::quat(std::sqrt(0.5f), 0, 0, std::sqrt(0.5f));
  Scene scene;
  scene.nodes = {translated({3, 0, 0}), turned};  // the child comes first in the file
  expect_near(at(world_transforms(scene)[0], {0, 0, 0}), {1, 3, 0});
  expect_near(at(world_transforms(scene)[1], {0, 0, 0}), {1, 0, 0});
}

TEST(WorldTransforms, BranchesAndSeveralRoots) {
  Scene scene;
  scene.nodes = {translated({1, 0, 0}, {2, 3}), translated({100, 0, 0}), translated({0, 1, 0}), translated({0, 0, 1})};
  const std::vector<glm::mat4> world = world_transforms(scene);
  expect_near(at(world[0], {}), {1, 0, 0});
  expect_near(at(world[1], {}), {100, 0, 0});
  expect_near(at(world[2], {}), {1, 1, 0});
  expect_near(at(world[3], {}), {1, 0, 1});
}

TEST(WorldTransforms, DeepChainsTakeNoStack) {
  constexpr NodeId depth = 200000;
  Scene scene;
  for (NodeId i = 0; i < depth; ++i) scene.nodes.push_back(translated({1, 0, 0}));
  for (NodeId i = 0; i + 1 < depth; ++i) scene.nodes[i].children = {i + 1};
  EXPECT_EQ(at(world_transforms(scene).back(), {}).x, static_cast<float>(depth));
}

TEST(WorldTransforms, NoNodesHaveNone) { EXPECT_TRUE(world_transforms({}).empty()); }

TEST(Scene, MaterialOfDraw) {
  Scene scene;
  scene.materials.resize(2);
  Draw draw;
  EXPECT_EQ(scene.material_of(draw), nullptr);
  draw.material = 1;
  EXPECT_EQ(scene.material_of(draw), &scene.materials[1]);
  draw.material = 2;
  EXPECT_EQ(scene.material_of(draw), nullptr) << "beyond what there is";
}

}  // namespace
}  // namespace foredraw::scene_test

#include "plugins/processors/merge_instances/merge_scene.h"

#include "support/placements.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

namespace foredraw::merge_instances_skinned_test {
namespace {

template <class T>
VertexStream stream(const char* semantic, Component component, const std::vector<std::array<T, 4>>& values) {
  const auto bytes = std::as_bytes(std::span(values));
  return {semantic, {component, 4, false, sizeof(values[0])}, Shared<std::byte>({bytes.begin(), bytes.end()})};
}

/// Every vertex hangs on the skin's one joint.
Draw skinned_draw(const char* name) {
  Draw draw = testing::draw_of(testing::grid(2, 1), name);
  auto vertices = std::make_shared<VertexStreams>(*draw.levels[0].vertices);
  vertices->base.push_back(
      stream<std::uint8_t>("JOINTS_0", Component::uint8, std::vector(vertices->count, std::array<std::uint8_t, 4>{})));
  vertices->base.push_back(
      stream<float>("WEIGHTS_0", Component::float32, std::vector(vertices->count, std::array<float, 4>{1, 0, 0, 0})));
  draw.levels[0].vertices = std::move(vertices);
  draw.traits.add(traits::skinned);
  draw.traits.add(traits::animated);
  return draw;
}

/// Two meshes of a skin, whose joint stands at z = 5 and rises to 9 in a second. The meshes' nodes stand elsewhere,
/// which does not count.
Scene two_skinned() {
  Scene scene = testing::scene_of({skinned_draw("coat"), skinned_draw("hat")});
  for (Node& node : scene.nodes) {
    node.skin = 0;
    node.transform.translation = {100, 0, 0};
  }
  const auto joint = static_cast<NodeId>(scene.nodes.size());
  scene.nodes.emplace_back().transform.translation = {0, 0, 5};
  scene.skins = {{"bones", {joint}, {glm::mat4(1)}}};
  AnimationChannel rising{.node = joint, .path = AnimatedPath::translation};
  rising.times = Shared<float>({0, 1});
  rising.values = Shared<float>({0, 0, 5, 0, 0, 9});
  scene.animations = {{"Rise", {rising}}};
  return scene;
}

TEST(MergeInstancesOfSkins, AreLeftAloneUnlessAsked) {
  const Scene scene = two_skinned();
  const MergedScene merged = merge_scene(scene, testing::all_draws(scene), {}, Executor(1));
  EXPECT_TRUE(merged.merged.empty());
  ASSERT_EQ(merged.left_alone.size(), 2u);
  EXPECT_EQ(merged.left_alone[0].why, "it is skinned");
}

TEST(MergeInstancesOfSkins, StandWhereTheirJointsPutThemInAllPoses) {
  const Scene scene = two_skinned();
  MergeSceneOptions options;
  options.skinned = true;
  options.poses.poses = {Pose{}, Pose{.clip = 0, .time = 1}};
  const MergedScene found = merge_scene(scene, testing::all_draws(scene), options, Executor(2));
  ASSERT_EQ(found.merged.size(), 1u);
  const MergedInstances merged = merged_instances(scene, found.merged[0]);
  EXPECT_EQ(mistake_in(merged), std::nullopt);
  EXPECT_EQ(merged.places.size(), 2u);
  EXPECT_NE(merged.vertices->find("JOINTS_0"), nullptr);
  for (const MergedTransform& transform : merged.transforms.view()) {
    EXPECT_EQ(transform, (MergedTransform{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}));
  }
  ASSERT_EQ(merged.groups.size(), 1u);
  EXPECT_EQ(merged.groups[0].least.z, 5);
  EXPECT_EQ(merged.groups[0].most.z, 9);
  EXPECT_LT(merged.groups[0].most.x, 50);
}

TEST(MergeInstancesOfSkins, StayWhereTheNodeHasNoSkinOrTurnsThemInsideOut) {
  Scene scene = two_skinned();
  scene.nodes[0].skin.reset();
  scene.nodes[1].transform.scale = {-1, 1, 1};
  MergeSceneOptions options;
  options.skinned = true;
  const MergedScene found = merge_scene(scene, testing::all_draws(scene), options, Executor(1));
  EXPECT_TRUE(found.merged.empty());
  std::vector<std::string> reasons;
  for (const processors::merge_instances::LeftAlone& left : found.left_alone) reasons.push_back(left.why);
  std::ranges::sort(reasons);
  EXPECT_EQ(reasons, (std::vector<std::string>{"it has joints, but its node has no skin",
                                               "its node mirrors what its joints place"}));
}

}  // namespace
}  // namespace foredraw::merge_instances_skinned_test

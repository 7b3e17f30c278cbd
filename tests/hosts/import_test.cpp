// FBX files: the shapes and the poses that come of them are what the files say.

#include "support/importing.h"

#include <gmock/gmock.h>

#include <cmath>

namespace foredraw::import_test {
namespace {

using testing::FbxBuilder;
using ::testing::HasSubstr;
using testing::Imported;
using ::testing::Not;

TEST_F(Imported, FbxStandsInMetresWithYUp) {
  const Scene as_it_is = read("y.fbx", testing::leaf().text());
  EXPECT_LT(distance(shown(as_it_is), {1, 0, 0}), 1e-5f);
  EXPECT_LT(distance(shown(as_it_is), {0, 0, 2}), 1e-5f);
  const Scene stood_up = read("z.fbx", testing::leaf({.axes = {.up = 2, .front = 1, .front_sign = -1}}).text());
  EXPECT_LT(distance(shown(stood_up), {0, 2, 0}), 1e-5f);
  const Scene in_inches = read("inches.fbx", testing::leaf({.centimetres = 2.54}).text());
  EXPECT_LT(distance(shown(in_inches), {2.54f, 0, 0}), 1e-5f);
}

TEST_F(Imported, ASkinBendsAsTheClipSays) {
  const Scene scene = read("bar.fbx", testing::bending_bar().text());
  ASSERT_EQ(scene.draws.size(), 1u);
  EXPECT_EQ(scene.draws[0].full().stream().triangle_count(), 16u);
  ASSERT_EQ(scene.animations.size(), 1u);
  EXPECT_EQ(scene.animations[0].name, "Bend");
  EXPECT_LT(distance(shown(scene), {0.1f, 2, 0.1f}), 1e-5f);
  EXPECT_LT(distance(shown(scene, {.clip = 0, .time = 0}), {0.1f, 2, 0.1f}), 1e-5f) << "a clip begins at 0";
  const std::vector<glm::vec3> bent = shown(scene, {.clip = 0, .time = 1});
  for (const glm::vec3 corner : {glm::vec3(0.1f, 1.1f, 1), {-0.1f, 0.9f, 1}, {0.1f, 1, 0.1f}, {0.1f, 0, 0.1f}}) {
    EXPECT_LT(distance(bent, corner), 1e-4f);
  }
  const float half = std::sqrt(0.5f);
  EXPECT_LT(distance(shown(scene, {.clip = 0, .time = 0.5}), {0.1f, 1 + half - 0.1f * half, half + 0.1f * half}),
            1e-4f);
}

TEST_F(Imported, VerticesThatNoBoneMovesStayWithTheirNode) {
  FbxBuilder file = testing::leaf();
  file.node(300, "stem", "LimbNode");
  file.connect(300, 0);
  file.skin(400, 100);
  file.cluster(401, 400, 300, {1}, {1}, 0);
  file.clip(500, "Lift", 0, 1);
  file.curve(510, 501, 300, "Lcl Translation", "d|Y", {{0, 0}, {1, 100}});
  const std::vector<glm::vec3> lifted = shown(read("stem.fbx", file.text()), {.clip = 0, .time = 1});
  EXPECT_LT(distance(lifted, {1, 1, 0}), 1e-4f);
  EXPECT_LT(distance(lifted, {0, 0, 2}), 1e-4f);
}

TEST_F(Imported, ABoneMayBeCalledAsItsMesh) {
  const Scene scene = read("tip.fbx", testing::bending_bar("tip").text());
  EXPECT_LT(distance(shown(scene, {.clip = 0, .time = 1}), {0.1f, 1.1f, 1}), 1e-4f);
}

TEST_F(Imported, ASkinKeepsWhereItsGeometryWasMoved) {
  const Scene scene =
      read("moved.fbx", testing::bending_bar("bar", FbxBuilder::vector("GeometricTranslation", 0, 0, 50)).text());
  EXPECT_LT(distance(shown(scene), {0.1f, 2.5f, 0.1f}), 1e-4f);
  EXPECT_LT(distance(shown(scene, {.clip = 0, .time = 1}), {0.1f, 1.1f, 1.5f}), 1e-4f);
}

TEST_F(Imported, PivotsThatStandStillAreNodesNoMore) {
  const std::string turned =
      FbxBuilder::vector("PreRotation", 0, 90, 0) + "P: \"RotationActive\", \"bool\", \"\", \"\",1\n" +
      FbxBuilder::vector("RotationPivot", 50, 0, 0) + FbxBuilder::vector("GeometricTranslation", 0, 300, 0);
  const Scene scene = read("pivot.fbx", testing::leaf({.properties = turned}).text());
  // (x, y, z) + (0, 300, 0), then turned by 90 degrees about y around (50, 0, 0).
  EXPECT_LT(distance(shown(scene), {0.5f, 3, 0.5f}), 1e-5f);
  EXPECT_LT(distance(shown(scene), {0.5f, 3, -0.5f}), 1e-5f);
  for (const Node& node : scene.nodes) EXPECT_THAT(node.name, Not(HasSubstr("AssimpFbx")));
}

TEST_F(Imported, AnAnimatedNodeKeepsItsPreRotation) {
  FbxBuilder file = testing::leaf(
      {.properties = FbxBuilder::vector("PreRotation", 0, 90, 0) + "P: \"RotationActive\", \"bool\", \"\", \"\",1\n"});
  file.clip(500, "Lift", 1, 3);
  file.curve(510, 501, 200, "Lcl Translation", "d|Y", {{1.5, 50}, {2.5, 150}});
  file.curve(520, 501, 200, "Lcl Rotation", "d|X", {{0, 0}, {4, 0}});  // outside the clip
  const Scene scene = read("lift.fbx", file.text());
  ASSERT_EQ(scene.animations.size(), 1u);
  EXPECT_LT(distance(shown(scene, {.clip = 0, .time = 0}), {0, 0.5f, -1}), 1e-4f);
  EXPECT_LT(distance(shown(scene, {.clip = 0, .time = 1}), {0, 1, -1}), 1e-4f);
  EXPECT_LT(distance(shown(scene, {.clip = 0, .time = 9}), {2, 1.5f, 0}), 1e-4f);
  float begins = 1, ends = 0;
  for (const AnimationChannel& channel : scene.animations[0].channels) {
    begins = std::min(begins, channel.times.view().front());
    ends = std::max(ends, channel.times.view().back());
  }
  EXPECT_GE(begins, 0) << "what Assimp adds before the clip is cut off";
  EXPECT_NEAR(ends, 2, 1e-4) << "a clip lasts for as long as it says, and not until its last key";
}

TEST_F(Imported, MorphTargetsMoveByTheirWeights) {
  FbxBuilder file = testing::leaf();
  file.target(600, 100, "smile", {1}, {0, 80, 0});
  file.clip(500, "Smile", 0, 1);
  file.curve(510, 501, 601, "DeformPercent", "d|DeformPercent", {{0, 0}, {1, 100}});
  const Scene scene = read("smile.fbx", file.text());
  EXPECT_LT(distance(shown(scene), {1, 0, 0}), 1e-5f);
  ASSERT_EQ(scene.animations.size(), 1u);
  EXPECT_LT(distance(shown(scene, {.clip = 0, .time = 0.5}), {1, 0.4f, 0}), 1e-4f);
  EXPECT_LT(distance(shown(scene, {.clip = 0, .time = 1}), {1, 0.8f, 0}), 1e-4f);
}

TEST_F(Imported, OneMeshOnManyNodesIsInstances) {
  FbxBuilder file = testing::leaf();
  file.node(201, "there", "Mesh",
            FbxBuilder::vector("Lcl Translation", 500, 0, 0) + FbxBuilder::vector("Lcl Scaling", -1, 1, 1));
  file.connect(100, 201);
  file.connect(201, 0);
  const Scene scene = read("leaves.fbx", file.text());
  EXPECT_EQ(scene.draws.size(), 1u);
  EXPECT_LT(distance(shown(scene), {1, 0, 0}), 1e-5f);
  EXPECT_LT(distance(shown(scene), {4, 0, 0}), 1e-5f) << "mirrored";
}

}  // namespace
}  // namespace foredraw::import_test

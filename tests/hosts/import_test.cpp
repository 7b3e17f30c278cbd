// Scenes of other formats: what comes of them is what their files say.

#include "support/image_builder.h"
#include "support/importing.h"

#include <gmock/gmock.h>

#include <cmath>

namespace foredraw {
namespace {

namespace fs = std::filesystem;
using testing::content;
using testing::Ended;
using testing::FbxBuilder;
using ::testing::HasSubstr;
using testing::Imported;
using ::testing::Not;
using testing::quick;

std::vector<std::byte> small_png() {
  return testing::png_of({.width = 2, .height = 2, .channels = 3, .bits = 8}, std::vector<std::uint16_t>(12, 99));
}

std::string triangle(const std::string& properties = {}, testing::FbxAxes axes = {}, double unit = 1) {
  FbxBuilder file(axes, unit);
  file.mesh(100, "leaf", {0, 0, 0, 100, 0, 0, 0, 0, 200}, {0, 1, -3});
  file.node(200, "leaf", "Mesh", properties);
  file.connect(100, 200);
  file.connect(200, 0);
  return file.text();
}

TEST_F(Imported, FbxStandsInMetresWithYUp) {
  const Scene as_it_is = read("y.fbx", triangle());
  EXPECT_LT(distance(shown(as_it_is), {1, 0, 0}), 1e-5f);
  EXPECT_LT(distance(shown(as_it_is), {0, 0, 2}), 1e-5f);
  const Scene stood_up = read("z.fbx", triangle({}, {.up = 2, .front = 1, .front_sign = -1}));
  EXPECT_LT(distance(shown(stood_up), {0, 2, 0}), 1e-5f);
  const Scene in_inches = read("inches.fbx", triangle({}, {}, 2.54));
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
  FbxBuilder file;
  file.mesh(100, "leaf", {0, 0, 0, 100, 0, 0, 0, 0, 200}, {0, 1, -3});
  file.node(200, "leaf", "Mesh");
  file.node(300, "stem", "LimbNode");
  file.connect(100, 200);
  file.connect(200, 0);
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
  const Scene scene = read("pivot.fbx", triangle(turned));
  // (x, y, z) + (0, 300, 0), then turned by 90 degrees about y around (50, 0, 0).
  EXPECT_LT(distance(shown(scene), {0.5f, 3, 0.5f}), 1e-5f);
  EXPECT_LT(distance(shown(scene), {0.5f, 3, -0.5f}), 1e-5f);
  for (const Node& node : scene.nodes) EXPECT_THAT(node.name, Not(HasSubstr("AssimpFbx")));
}

TEST_F(Imported, AnAnimatedNodeKeepsItsPreRotation) {
  FbxBuilder file;
  file.mesh(100, "leaf", {0, 0, 0, 100, 0, 0, 0, 0, 200}, {0, 1, -3});
  file.node(200, "leaf", "Mesh",
            FbxBuilder::vector("PreRotation", 0, 90, 0) + "P: \"RotationActive\", \"bool\", \"\", \"\",1\n");
  file.connect(100, 200);
  file.connect(200, 0);
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
  FbxBuilder file;
  file.mesh(100, "leaf", {0, 0, 0, 100, 0, 0, 0, 0, 200}, {0, 1, -3});
  file.node(200, "leaf", "Mesh");
  file.connect(100, 200);
  file.connect(200, 0);
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
  FbxBuilder file;
  file.mesh(100, "leaf", {0, 0, 0, 100, 0, 0, 0, 0, 200}, {0, 1, -3});
  file.node(200, "here", "Mesh");
  file.node(201, "there", "Mesh",
            FbxBuilder::vector("Lcl Translation", 500, 0, 0) + FbxBuilder::vector("Lcl Scaling", -1, 1, 1));
  for (const int node : {200, 201}) {
    file.connect(100, node);
    file.connect(node, 0);
  }
  const Scene scene = read("leaves.fbx", file.text());
  EXPECT_EQ(scene.draws.size(), 1u);
  EXPECT_LT(distance(shown(scene), {1, 0, 0}), 1e-5f);
  EXPECT_LT(distance(shown(scene), {4, 0, 0}), 1e-5f) << "mirrored";
}

TEST_F(Imported, PicturesComeAlongAndAreNamedWhereTheyDoNot) {
  FbxBuilder file;
  file.mesh(100, "leaf", {0, 0, 0, 100, 0, 0, 0, 0, 200}, {0, 1, -3}, {0, 0, 1, 0, 0, 1});
  file.node(200, "leaf", "Mesh");
  file.connect(100, 200);
  file.connect(200, 0);
  file.material(250, "green", 200);
  file.texture(260, 250, "C:\\\\art\\\\leaf.png");
  testing::put(folder_ / "leaf.fbx", file.text());
  Ended ended = run("optimize leaf.fbx -o leaf.glb" + std::string(quick));
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("leaf.png' is left out"));

  const std::vector<std::byte> png = small_png();
  testing::put(folder_ / "leaf.png", {reinterpret_cast<const char*>(png.data()), png.size()});
  ended = run("optimize leaf.fbx -o leaf.glb --depfile leaf.d" + std::string(quick));
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.err, Not(HasSubstr("left out")));
  EXPECT_THAT(content(folder_ / "leaf.d"), HasSubstr("leaf.png"));
  Diagnostics diagnostics;
  const auto made = read_scene((folder_ / "leaf.glb").string(), diagnostics, {});
  ASSERT_TRUE(made);
  EXPECT_EQ(made->scene.images.size(), 1u);
  ASSERT_EQ(made->scene.materials.size(), 1u);
  EXPECT_EQ(made->scene.materials[0].name, "green");
  EXPECT_EQ(made->scene.materials[0].colour, glm::vec3(1)) << "a picture of an FBX file takes the colour's place";
  testing::put(folder_ / "leaf.png", "no picture");
  EXPECT_EQ(read("leaf.fbx", file.text()).materials[0].colour, glm::vec3(0.5f, 0.25f, 1));
}

TEST_F(Imported, NothingIsReadOutsideTheFolder) {
  fs::create_directories(folder_ / "in");
  const std::vector<std::byte> png = small_png();
  testing::put(folder_ / "secret.png", {reinterpret_cast<const char*>(png.data()), png.size()});
  FbxBuilder file;
  file.mesh(100, "leaf", {0, 0, 0, 100, 0, 0, 0, 0, 200}, {0, 1, -3}, {0, 0, 1, 0, 0, 1});
  file.node(200, "leaf", "Mesh");
  file.connect(100, 200);
  file.connect(200, 0);
  file.material(250, "green", 200);
  file.texture(260, 250, "../secret.png");
  testing::put(folder_ / "in/leaf.fbx", file.text());
  EXPECT_THAT(run("optimize in/leaf.fbx -o leaf.glb" + std::string(quick)).err, HasSubstr("left out"));
  EXPECT_THAT(run("optimize in/leaf.fbx -o leaf.glb --root ." + std::string(quick)).err, Not(HasSubstr("left out")));
}

TEST_F(Imported, Collada) {
  const Scene scene = read("leaf.dae", R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter="0.01" name="centimeter"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g" name="leaf"><mesh>
<source id="p"><float_array id="pa" count="9">0 0 0 100 0 0 0 0 200</float_array><technique_common>
<accessor source="#pa" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh></geometry>
</library_geometries><library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node>
</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)");
  EXPECT_LT(distance(shown(scene), {1, 0, 0}), 1e-5f);
  EXPECT_LT(distance(shown(scene), {0, 2, 0}), 1e-5f);
}

/// A chunk of a 3DS file: a number, its length, and what it holds.
std::string chunk(unsigned number, const std::string& holds) {
  std::string bytes{static_cast<char>(number), static_cast<char>(number >> 8)};
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>((holds.size() + 6) >> shift);
  return bytes + holds;
}

TEST_F(Imported, ThreeDs) {
  const auto bytes_of = [](const auto& values) {
    return std::string(reinterpret_cast<const char*>(values.data()), sizeof(values[0]) * values.size());
  };
  const std::string points = std::string("\3\0", 2) + bytes_of(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 0, 2});
  const std::string faces = std::string("\1\0", 2) + bytes_of(std::vector<std::uint16_t>{0, 1, 2, 0});
  const std::string mesh = chunk(0x4100, chunk(0x4110, points) + chunk(0x4120, faces));
  const Scene scene = read("leaf.3ds", chunk(0x4d4d, chunk(0x3d3d, chunk(0x4000, std::string("leaf\0", 5) + mesh))));
  ASSERT_EQ(scene.draws.size(), 1u);
  EXPECT_EQ(scene.draws[0].full().stream().triangle_count(), 1u);
}

}  // namespace
}  // namespace foredraw

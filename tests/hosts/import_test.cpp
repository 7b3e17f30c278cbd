// Scenes of other formats: what comes of them is what their files say, and no file and no importer ends the program.

#include "support/fbx_builder.h"
#include "support/image_builder.h"
#include "support/meshes.h"
#include "support/program.h"

#include <foredraw/io/scene_file.h>
#include <foredraw/scene/subject.h>
#include <foredraw/viewing/animation.h>
#include <foredraw/viewing/posed_positions.h>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include <chrono>
#include <random>

namespace foredraw {
namespace {

namespace fs = std::filesystem;
using testing::content;
using testing::Ended;
using testing::FbxBuilder;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* quick = " -p 'tipsify, vertex-fetch' --with vertex-cache";

class Imported : public testing::InFolder {
 protected:
  Imported() {
    ::setenv("FOREDRAW_IMPORTER", FOREDRAW_IMPORT_PROGRAM, 1);
    for (const char* name : {"FOREDRAW_IMPORT_SECONDS", "FOREDRAW_IMPORT_MEMORY", "FOREDRAW_STAND_IN"})
      ::unsetenv(name);
  }

  Ended run(const std::string& arguments, const std::string& before = {}) {
    return testing::run_program(folder_, arguments, before);
  }
  /// With the stand-in for the importer.
  Ended run_with(const std::string& stand_in, const std::string& more = {}) {
    testing::put(folder_ / "bar.fbx", testing::bending_bar().text());
    return run(
        "optimize bar.fbx -o bar.glb" + std::string(quick),
        "export FOREDRAW_STAND_IN='" + stand_in + "' FOREDRAW_IMPORTER='" FOREDRAW_STAND_IN_PROGRAM "' " + more + ";");
  }

  Scene read(const std::string& name, const std::string& text) {
    testing::put(folder_ / name, text);
    Diagnostics diagnostics;
    auto file = read_scene((folder_ / name).string(), diagnostics, {});
    EXPECT_TRUE(file) << to_text(diagnostics);
    told_ = to_text(diagnostics);
    return file ? std::move(file->scene) : Scene{};
  }

  /// Of all vertices that are shown, part by part.
  static std::vector<glm::vec3> shown(const Scene& scene, const Pose& pose = {}) {
    std::vector<glm::vec3> all;
    const PosedNodes nodes = posed_nodes(scene, pose);
    for (const Subject& subject : subjects_of(scene, SubjectUnit::scene)) {
      for (const SubjectPart& part : subject.parts) {
        for (const glm::vec3& place : posed_positions(scene, part, nodes)) all.push_back(place);
      }
    }
    return all;
  }
  static float distance(const std::vector<glm::vec3>& from, const glm::vec3& to) {
    float least = 1e30f;
    for (const glm::vec3& one : from) least = std::min(least, glm::length(one - to));
    return least;
  }

  std::string told_;
};

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

TEST_F(Imported, TheProgramOptimizesAnFbx) {
  testing::put(folder_ / "bar.fbx", testing::bending_bar().text());
  const Ended ended = run("optimize bar.fbx -o bar.glb -p @default");
  EXPECT_EQ(ended.code, 0) << ended.err;
  Diagnostics diagnostics;
  const auto made = read_scene((folder_ / "bar.glb").string(), diagnostics, {});
  ASSERT_TRUE(made) << to_text(diagnostics);
  EXPECT_LT(distance(shown(made->scene, {.clip = 0, .time = 1}), {0.1f, 1.1f, 1}), 1e-4f);
  EXPECT_EQ(run("inspect bar.fbx").code, 0);
  const Ended as_fbx = run("optimize bar.fbx -o other.fbx");
  EXPECT_EQ(as_fbx.code, 1);
  EXPECT_THAT(as_fbx.err, HasSubstr(".glb"));
}

TEST_F(Imported, WithoutAnImporterTheMessageSaysWhatToInstall) {
  testing::put(folder_ / "bar.fbx", testing::bending_bar().text());
  const Ended ended = run("optimize bar.fbx -o bar.glb", "export FOREDRAW_IMPORTER=/nowhere/foredraw-import;");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("foredraw-import"));
  EXPECT_THAT(ended.err, HasSubstr("libassimp-dev"));
}

TEST_F(Imported, WhateverTheImporterDoesIsOneError) {
  using namespace std::chrono_literals;
  for (const auto& [stand_in, told] :
       std::vector<std::pair<std::string, std::string>>{{"leaves", "bar.fbx: error:"},
                                                        {"is ended", "bar.fbx: error:"},
                                                        {"rubbish", "bar.fbx: error:"},
                                                        {"nothing", "bar.fbx: error:"},
                                                        {"half", "bar.fbx: error:"},
                                                        {"no end", "bar.fbx: error:"},
                                                        {"words", "its words are ?[31mred?"}}) {
    SCOPED_TRACE(stand_in);
    const Ended ended = run_with(stand_in);
    EXPECT_EQ(ended.code, 2) << ended.err;
    EXPECT_THAT(ended.err, HasSubstr("bar.fbx: error:"));
    EXPECT_THAT(ended.err, HasSubstr(stand_in == "words" ? "its words are" : told));
    EXPECT_THAT(ended.err, Not(HasSubstr("\x1b")));
    EXPECT_FALSE(fs::exists(folder_ / "bar.glb"));
  }
  const auto begin = std::chrono::steady_clock::now();
  const Ended ended = run_with("hangs", "FOREDRAW_IMPORT_SECONDS=1");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("was not done within 1 seconds"));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 20s);
}

TEST_F(Imported, MemoryHasALimit) {
  if (testing::is_sanitized) GTEST_SKIP() << "sanitizers keep terabytes mapped";
  testing::put(folder_ / "bar.fbx", testing::bending_bar().text());
  const Ended ended = run("optimize bar.fbx -o bar.glb", "export FOREDRAW_IMPORT_MEMORY=300000;");
  EXPECT_EQ(ended.code, 2) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("bar.fbx: error:"));
}

TEST_F(Imported, AFolderHoldsThemBesideOthers) {
  fs::create_directories(folder_ / "in");
  testing::put(folder_ / "in/bar.fbx", testing::bending_bar().text());
  testing::put(folder_ / "in/broken.fbx", testing::bending_bar().text().substr(0, 900));
  testing::put(folder_ / "in/quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
  fs::copy_file(testing::project_file("benchmarks/corpus/static/spot.glb"), folder_ / "in/spot.glb");
  testing::put(folder_ / "in/spot.fbx", testing::bending_bar().text());
  const Ended ended = run("optimize in -o out" + std::string(quick));
  EXPECT_EQ(ended.code, 2) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("broken.fbx: error:"));
  for (const char* name : {"bar.glb", "quad.glb", "spot.glb"}) EXPECT_TRUE(fs::exists(folder_ / "out" / name)) << name;
  EXPECT_GT(fs::file_size(folder_ / "out/spot.glb"), 50000u) << "of the .glb, and not of the .fbx beside it";

  const Ended without =
      run("optimize in -o others" + std::string(quick), "export FOREDRAW_IMPORTER=/nowhere/foredraw-import;");
  EXPECT_EQ(without.code, 0) << without.err;
  EXPECT_THAT(without.err, HasSubstr("is passed by"));
  EXPECT_TRUE(fs::exists(folder_ / "others/spot.glb"));
}

TEST_F(Imported, ACacheKnowsTheImportersBuild) {
  fs::create_directories(folder_ / "in");
  testing::put(folder_ / "in/bar.fbx", testing::bending_bar().text());
  fs::copy_file(FOREDRAW_IMPORT_PROGRAM, folder_ / "other-import");
  const std::string optimize = "optimize in -o out --cache cache --report r.json" + std::string(quick);
  const auto is_kept = [&] { return content(folder_ / "r.json").find("\"cached\": true") != std::string::npos; };
  ASSERT_EQ(run(optimize).code, 0);
  EXPECT_FALSE(is_kept());
  ASSERT_EQ(run(optimize).code, 0);
  EXPECT_TRUE(is_kept());
  std::ofstream(folder_ / "other-import", std::ios::app) << "another build";
  ASSERT_EQ(run(optimize, "export FOREDRAW_IMPORTER=./other-import;").code, 0);
  EXPECT_FALSE(is_kept());
}

/// What is left of a file after damage: cut short, bytes changed, pieces moved.
std::string damaged(const std::string& text, std::mt19937& random) {
  std::string made = text;
  const auto below = [&](std::size_t end) { return random() % std::max<std::size_t>(end, 1); };
  switch (random() % 4) {
    case 0: made.resize(below(made.size())); break;
    case 1:
      for (std::size_t k = 0, count = 1 + below(30); k < count; ++k) {
        made[below(made.size())] = static_cast<char>(random());
      }
      break;
    case 2: made.insert(below(made.size()), made.substr(below(made.size()), below(3000))); break;
    default: {
      const std::size_t at = made.find_first_of("0123456789", below(made.size()));
      constexpr std::array numbers{"-1", "4294967295", "1e308", "nan", "99999999999999999999", "2147483648"};
      if (at != std::string::npos) made.replace(at, 1, numbers[below(numbers.size())]);
    }
  }
  return made;
}

void expect_no_end(const fs::path& folder, const std::string& text, std::mt19937& random) {
  testing::put(folder / "damaged.fbx", damaged(text, random));
  const Ended ended = testing::run_program(folder, "optimize damaged.fbx -o made.glb -p 'tipsify' --with vertex-cache",
                                           "export FOREDRAW_IMPORT_SECONDS=20 FOREDRAW_IMPORT_MEMORY=1000000000;");
  EXPECT_THAT(ended.code, ::testing::AnyOf(0, 2)) << ended.err;
  if (ended.code != 2) return;
  EXPECT_THAT(ended.err, HasSubstr("damaged.fbx: error:"));
}

TEST_F(Imported, DamagedFilesNeverEndTheProgram) {
  std::mt19937 random(1);
  const std::string text = testing::bending_bar().text();
  for (int i = 0; i < 60; ++i) expect_no_end(folder_, text, random);
}

/// FOREDRAW_FUZZ_SECONDS and FOREDRAW_FUZZ_FILE: for how long (600), and of which file.
TEST_F(Imported, DamagedFilesNeverEndTheProgramLong) {
  using Clock = std::chrono::steady_clock;
  const char* asked = std::getenv("FOREDRAW_FUZZ_SECONDS");
  const char* named = std::getenv("FOREDRAW_FUZZ_FILE");
  const auto end = Clock::now() + std::chrono::seconds(asked == nullptr ? 600 : std::atoi(asked));
  std::mt19937 random(2);
  const std::string text = named == nullptr ? testing::bending_bar().text() : content(named);
  std::size_t runs = 0;
  for (; Clock::now() < end && !HasFailure(); ++runs) expect_no_end(folder_, text, random);
  std::fprintf(stderr, "%zu damaged files\n", runs);
}

}  // namespace
}  // namespace foredraw

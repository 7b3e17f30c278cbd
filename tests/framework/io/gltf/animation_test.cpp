// Animations of glTF files, from their bytes to positions.

#include "support/gltf_builder.h"
#include "support/meshes.h"
#include "support/naive_animation.h"

#include <foredraw/io/gltf/gltf.h>
#include <foredraw/viewing/pose_set.h>
#include <foredraw/viewing/posed_positions.h>

#include <gtest/gtest.h>

#include <filesystem>

namespace foredraw::gltf_animation_test {
namespace {

namespace fs = std::filesystem;
using testing::GltfBuilder;
using testing::GltfJson;

Scene read_built(const fs::path& path) {
  Diagnostics diagnostics;
  auto scene = read_gltf(path, diagnostics);
  EXPECT_TRUE(scene) << to_text(diagnostics);
  return scene ? std::move(*scene) : Scene();
}

Scene read_built(const GltfBuilder& builder) {
  Diagnostics diagnostics;
  auto scene = read_gltf(builder.glb(), "built.glb", {}, diagnostics);
  EXPECT_TRUE(scene) << to_text(diagnostics);
  return scene ? std::move(*scene) : Scene();
}

/// Of all parts that some node shows, in all poses.
double largest_difference(const Scene& scene, const Poses& poses) {
  double largest = 0;
  for (const Pose& pose : poses.poses) {
    const PosedNodes nodes = posed_nodes(scene, pose);
    const testing::NaiveAnimation naive(scene, pose);
    for (const Subject& subject : subjects_of(scene)) {
      for (const SubjectPart& part : subject.parts) {
        if (!part.node) continue;
        largest = std::max(largest, testing::difference(posed_positions(scene, part, nodes), naive.positions(part)));
      }
    }
  }
  return largest;
}

/// From rest.
double largest_movement(const Scene& scene, const Poses& poses) {
  const std::vector<Subject> subjects = subjects_of(scene);
  double largest = 0;
  for (const Pose& pose : poses.poses) {
    for (const SubjectPart& part : subjects[0].parts) {
      largest = std::max(largest, testing::difference(posed_positions(scene, part, posed_nodes(scene, pose)),
                                                      testing::NaiveAnimation(scene, {}).positions(part)));
    }
  }
  return largest;
}

TEST(GltfAnimation, characters_of_the_corpus_stand_as_an_independent_evaluation_has_them) {
  std::size_t characters = 0;
  for (const auto& entry : fs::directory_iterator(testing::project_file("benchmarks/corpus/animated"))) {
    const Scene scene = read_built(entry.path());
    const Poses poses = make_poses(scene, {.poses = "3"});
    EXPECT_EQ(poses.poses.size(), 3u) << entry.path();
    EXPECT_LT(largest_difference(scene, poses), 1e-5) << entry.path();
    EXPECT_LT(largest_difference(scene, rest_pose), 1e-5) << entry.path();
    EXPECT_GT(largest_movement(scene, poses), 1e-2) << entry.path();
    ++characters;
  }
  EXPECT_EQ(characters, 6u);
}

/// An arm of two joints below a turned and scaled node, bound to two meshes by skins that share a joint; the first mesh
/// is morphed too, and shown twice. Everything moves, in each way of interpolating.
GltfBuilder contraption() {
  GltfBuilder b;
  const auto positions = b.add_values<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 2, 0, 0, 3, 1, 1, 3, 0}, "VEC3");
  const auto indices = b.add_values<std::uint16_t>({0, 1, 2, 3, 4, 5}, "SCALAR");
  const auto joints =
      b.add_values<std::uint8_t>({0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0}, "VEC4");
  const auto weights =
      b.add_values<float>({1, 0, 0, 0, 0.5f, 0.5f, 0, 0, 0.3f, 0, 0, 0, 3, 1, 0, 0, 0.1f, 0, 0, 0, 0, 0, 0, 0}, "VEC4");
  const auto joints_1 = b.add_values<std::uint16_t>(std::vector<std::uint16_t>(24, 1), "VEC4");
  const auto weights_1 = b.add_values<std::uint8_t>(
      {255, 0, 0, 0, 0, 0, 0, 0, 128, 128, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC4");
  b.json["accessors"][weights_1]["normalized"] = true;
  const auto bulge = b.add_values<float>({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1, 0, 0, 1, 0}, "VEC3");
  const auto lean = b.add_values<float>({1, 0, 0, 2, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 5}, "VEC3");
  const GltfJson skinned = {{"POSITION", positions},
                            {"JOINTS_0", joints},
                            {"WEIGHTS_0", weights},
                            {"JOINTS_1", joints_1},
                            {"WEIGHTS_1", weights_1}};
  b.add(
      "meshes",
      {{"primitives",
        {{{"attributes", skinned}, {"indices", indices}, {"targets", {{{"POSITION", bulge}}, {{"POSITION", lean}}}}}}},
       {"weights", {0.25, 0}}});
  b.add("meshes", {{"primitives", {{{"attributes", skinned}, {"indices", indices}}}}});

  // 0 root: 1 shoulder: 2 elbow; 3 and 4 show mesh 0, 5 mesh 1; 6 hangs from the elbow without a skin.
  b.add("nodes", {{"rotation", {0, 0.6, 0, 0.8}}, {"scale", {2, 1, 0.5}}, {"children", {1}}});
  b.add("nodes", {{"translation", {0, 1, 0}}, {"children", {2}}});
  b.add("nodes", {{"translation", {0, 1.5, 0}}, {"rotation", {0.6, 0, 0, 0.8}}, {"children", {6}}});
  b.add("nodes", {{"mesh", 0}, {"skin", 0}});
  b.add("nodes", {{"mesh", 0}, {"skin", 1}, {"weights", {0, 1}}, {"translation", {9, 9, 9}}});
  b.add("nodes", {{"mesh", 1}, {"skin", 1}});
  b.add("nodes", {{"mesh", 1}, {"matrix", {1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 5, 6, 7, 1}}});
  const auto bind = b.add_values<float>(
      {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -2, 0, 1}, "MAT4");
  b.add("skins", {{"joints", {1, 2}}, {"inverseBindMatrices", bind}});
  b.add("skins", {{"joints", {2, 0}}});

  GltfJson samplers = GltfJson::array();
  GltfJson channels = GltfJson::array();
  const auto add = [&](std::size_t node, const char* path, const char* how, std::size_t input, std::size_t output) {
    channels.push_back({{"sampler", samplers.size()}, {"target", {{"node", node}, {"path", path}}}});
    samplers.push_back({{"input", input}, {"output", output}, {"interpolation", how}});
  };
  const auto three = b.add_values<float>({0.5f, 1, 2.5f}, "SCALAR");
  const auto two = b.add_values<float>({0, 3}, "SCALAR");
  const auto turns = b.add_values<std::int16_t>({0, 0, 0, 32767, 0, 0, 23170, -23170, 23170, 0, 0, -23170}, "VEC4");
  b.json["accessors"][turns]["normalized"] = true;
  add(1, "rotation", "LINEAR", three, turns);
  const auto coarse = b.add_values<std::int8_t>({0, 0, 0, 127, 90, 0, 0, 90, 0, 127, 0, 0}, "VEC4");
  b.json["accessors"][coarse]["normalized"] = true;
  add(2, "rotation", "STEP", three, coarse);
  add(0, "translation", "CUBICSPLINE", two,
      b.add_values<float>({9, 9, 9, 0, 0, 0, 1, 2, 3, -3, 0, 3, 5, 5, 5, 9, 9, 9}, "VEC3"));
  add(0, "rotation", "CUBICSPLINE", two,
      b.add_values<float>({0, 0, 0, 0, 0, 0.6f, 0, 0.8f, 0.1f, 0, 0.1f, 0, 0, 0.2f, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0},
                          "VEC4"));
  add(2, "scale", "LINEAR", three, b.add_values<float>({1, 1, 1, 2, 0.5f, 1, 1, 1, 0}, "VEC3"));
  const auto swell = b.add_values<std::uint8_t>({0, 255, 255, 51, 128, 0}, "SCALAR");
  b.json["accessors"][swell]["normalized"] = true;
  add(3, "weights", "LINEAR", three, swell);
  b.add("animations", {{"name", "Move"}, {"samplers", samplers}, {"channels", channels}});
  return b;
}

TEST(GltfAnimation, a_contraption_moves_as_an_independent_evaluation_has_it) {
  const Scene scene = read_built(contraption());
  ASSERT_EQ(subjects_of(scene).size(), 1u);
  EXPECT_EQ(subjects_of(scene)[0].parts.size(), 4u);
  EXPECT_LT(largest_difference(scene, make_poses(scene, {.poses = "all"})), 1e-6);
  EXPECT_LT(largest_difference(scene, make_poses(scene, {.poses = "all", .rate = 60})), 1e-6);
  EXPECT_LT(largest_difference(scene, {{{}, {0, -1}, {0, 99}}}), 1e-6);
}

// By hand. The joint moves from (0, 0, 0) to (0, 4, 0) within two seconds and turns by 90 degrees around z at once
// at 1. The vertex (1, 0, 0), half of the joint and half of one that stands still, at 1.5 seconds: ((0, 1, 0) + (0, 3,
// 0) + (1, 0, 0)) / 2.
TEST(GltfAnimation, half_of_a_moved_joint_is_half_of_its_movement) {
  GltfBuilder b;
  const auto positions = b.add_values<float>({1, 0, 0, 0, 0, 0, 0, 0, 1}, "VEC3");
  const auto joints = b.add_values<std::uint8_t>({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, "VEC4");
  const auto weights = b.add_values<float>({0.5f, 0.5f, 0, 0, 0.5f, 0.5f, 0, 0, 0.5f, 0.5f, 0, 0}, "VEC4");
  b.add("meshes",
        {{"primitives", {{{"attributes", {{"POSITION", positions}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}}}}}}});
  b.add("nodes", GltfJson::object());
  b.add("nodes", GltfJson::object());
  b.add("nodes", {{"mesh", 0}, {"skin", 0}});
  b.add("skins", {{"joints", {0, 1}}});
  const auto slide = b.add_values<float>({0, 2}, "SCALAR");
  const auto turn = b.add_values<float>({0, 1}, "SCALAR");
  const auto places = b.add_values<float>({0, 0, 0, 0, 4, 0}, "VEC3");
  const auto turns = b.add_values<float>({0, 0, 0, 1, 0, 0, 0.70710678f, 0.70710678f}, "VEC4");
  b.add("animations",
        {{"samplers",
          {{{"input", slide}, {"output", places}}, {{"input", turn}, {"output", turns}, {"interpolation", "STEP"}}}},
         {"channels",
          {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}},
           {{"sampler", 1}, {"target", {{"node", 0}, {"path", "rotation"}}}}}}});
  const Scene scene = read_built(b);
  const auto positions_at = [&](double time) { return posed_positions(scene, {0, 2}, posed_nodes(scene, {0, time})); };
  const auto expect_near = [](glm::vec3 a, glm::vec3 b) { EXPECT_LT(glm::length(a - b), 1e-6f) << a.x << ' ' << a.y; };
  expect_near(positions_at(1.5)[0], {0.5f, 2, 0});
  expect_near(positions_at(0.5)[0], {1, 0.5f, 0});
  expect_near(positions_at(1.5)[1], {0, 1.5f, 0});
  expect_near(positions_at(7)[2], {0, 2, 1});
}

}  // namespace
}  // namespace foredraw::gltf_animation_test

// What packed models of the corpus reach.
#include "evaluators/vertex_precision/vertex_precision.h"

#include "support/packed_scenes.h"

#include <foredraw/viewing/pose_set.h>

#include <gtest/gtest.h>

namespace foredraw::vertex_precision_models_test {
namespace {

Scene model(const std::string& name) {
  Diagnostics diagnostics;
  auto scene = read_gltf(testing::project_file("benchmarks/corpus/" + name + ".glb"), diagnostics);
  if (!scene) throw std::runtime_error(to_text(diagnostics));
  return std::move(*scene);
}

/// Goals: 2.2e-6 of the diagonal, .040 and .065 degrees, .032 texels of 4096; and never more than promised.
TEST(VertexPrecision, OfModelsIsAsFineAsWanted) {
  for (const char* name : {"static/head", "static/flight_helmet_notex", "animated/cesium_man_notex", "animated/fox",
                           "animated/mannequiny", "animated/robot_expressive"}) {
    const Scene scene = testing::packed(model(name), "(poses=bind)");
    const auto all = vertex_precision(scene, SubjectUnit::character, rest_pose, Executor(2));
    EXPECT_EQ(all.size(), scene.draws.size()) << name;
    for (const DrawPrecision& of : all) {
      EXPECT_LE(of.errors.most.position, 2.2e-6 * of.diagonal) << name;
      EXPECT_LE(of.errors.most.normal, 0.040) << name;
      EXPECT_LE(of.errors.most.tangent, 0.065) << name;
      EXPECT_LE(of.errors.most.uv() * 4096, 0.032) << name;
      EXPECT_EQ(of.errors.handedness, 0u) << name;
      EXPECT_LE(of.errors.most.position, of.bounds.position) << name;
      EXPECT_LE(of.errors.most.normal, of.bounds.normal) << name;
      EXPECT_LE(of.errors.most.tangent, of.bounds.tangent) << name;
      EXPECT_LE(of.errors.most.u, of.bounds.u) << name;
      EXPECT_LE(of.errors.most.v, of.bounds.v) << name;
    }
  }
}

/// Boxes are made from the keys; here clips are looked at 50 times a second.
TEST(VertexPrecision, NoPoseBetweenKeysLeavesTheLattice) {
  for (const char* name : {"animated/cesium_man_notex", "animated/fox"}) {
    const Scene scene = testing::packed(model(name));
    const Poses between = make_poses(scene, {.rate = 50});
    for (const DrawPrecision& of : vertex_precision(scene, SubjectUnit::character, between, Executor(2))) {
      ASSERT_TRUE(of.posed);
      EXPECT_EQ(of.posed->outside, 0u) << name;
      EXPECT_LE(of.posed->position, 2.2e-6 * of.posed->diagonal) << name;
    }
  }
}

}  // namespace
}  // namespace foredraw::vertex_precision_models_test

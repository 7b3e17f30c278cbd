#include "evaluators/attribute_error/attribute_error.h"

#include "support/meshes.h"
#include "support/other_units.h"

#include <foredraw/technique/plugin.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace foredraw::attribute_error_test {
namespace {

struct Carrying {
  testing::TestMesh mesh;
  std::vector<glm::vec3> uvs, normals;

  AttributedSurface view() const { return {{mesh.positions, mesh.indices}, uvs, normals}; }
};

/// A square of side 1 with its own coordinates as those of its texture, and normals that lean by that slope along x.
Carrying square(float height = 0, float slope = 0) {
  Carrying square{{{{0, 0, height}, {1, 0, height}, {0, 1, height}, {1, 1, height}}, {0, 1, 2, 2, 1, 3}}, {}, {}};
  for (const glm::vec3& p : square.mesh.positions) {
    square.uvs.emplace_back(p.x, p.y, 0);
    square.normals.emplace_back(slope, 0, 1);
  }
  return square;
}

AttributeError between(const Carrying& changed, const Carrying& original, int threads = 2) {
  return *attribute_error(changed.view(), original.view(), {}, 1, Executor(threads));
}

TEST(AttributeError, OfWhatMovedAlongItsNormalIsNone) {
  const AttributeError error = between(square(0.1f), square());
  EXPECT_LT(error.uv()->value, 1e-6);
  EXPECT_LT(error.normal()->value, 1e-4);
}

TEST(AttributeError, IsInTextureWidthsAndDegrees) {
  Carrying changed = square(0, 1);
  for (glm::vec3& uv : changed.uvs) uv += glm::vec3(0.03f, 0.04f, 0);
  const AttributeError error = between(changed, square());
  EXPECT_NEAR(error.uv()->value, 0.05, 1e-6);
  EXPECT_NEAR(error.normal()->value, 45, 1e-4);
  EXPECT_NEAR(error.to_original.normal->value, 45, 1e-4);
}

/// A coordinate that runs to 2 instead of 1: differences are even from 0 to 1.
TEST(AttributeError, IsTakenBetweenCorners) {
  Carrying changed = square();
  for (glm::vec3& uv : changed.uvs) uv.x *= 2;
  const AttributeError error = between(changed, square());
  EXPECT_GT(error.uv()->error, 0);
  EXPECT_NEAR(error.uv()->value, std::sqrt(1.0 / 3), 3 * error.uv()->error);
}

/// Of no length, of any length, or no numbers.
TEST(AttributeError, LeavesOutWhatHasNoDirection) {
  Carrying changed = square(0, 1);
  for (glm::vec3& normal : changed.normals) normal *= 7.0f;
  EXPECT_NEAR(between(changed, square()).normal()->value, 45, 1e-4);
  for (glm::vec3& normal : changed.normals) normal = glm::vec3(0);
  EXPECT_FALSE(between(changed, square()).normal());
  changed = square(0, 1);
  changed.normals[3].x = std::numeric_limits<float>::quiet_NaN();  // of one triangle of two
  EXPECT_NEAR(between(changed, square()).normal()->value, 45, 1e-4);
}

TEST(AttributeError, OfWhatOneOfThemLacksIsNone) {
  Carrying bare = square();
  bare.uvs.clear();
  EXPECT_FALSE(between(bare, square()).uv());
  EXPECT_FALSE(between(square(), bare).uv());
  EXPECT_TRUE(between(square(), bare).normal());
  bare.mesh.indices.clear();
  EXPECT_FALSE(attribute_error(bare.view(), square().view(), {}, 1, Executor(1)));
}

TEST(AttributeError, IsTheSameAtAnyThreadCount) {
  const Carrying changed = square(0.2f, 0.5f);
  EXPECT_EQ(between(changed, square(), 1).normal()->value, between(changed, square(), 4).normal()->value);
}

Scene scene_of(const Carrying& square) {
  VertexStreams streams = *testing::vertex_streams(square.mesh.positions);
  streams.base.push_back({"NORMAL", Format{}, testing::vertex_streams(square.normals)->base[0].bytes});
  streams.base.push_back({"TEXCOORD_0", Format{}, testing::vertex_streams(square.uvs)->base[0].bytes});
  Draw draw = testing::draw_of(square.mesh);
  draw.full().vertices = std::make_shared<const VertexStreams>(std::move(streams));
  return testing::scene_of({std::move(draw)});
}

TEST(AttributeErrorPlugin, MeasuresAgainstTheSceneThatTheRunBeganWith) {
  Carrying moved = square(0, 1);
  for (glm::vec3& uv : moved.uvs) uv.x += 0.25f;
  const Scene original = scene_of(square()), changed = scene_of(moved);
  testing::RunFixture fixture;
  fixture.run.original = &original;
  const Technique technique = attribute_error_plugin().create({});
  std::get<std::unique_ptr<DrawEvaluator>>(technique)->evaluate({changed, 0}, fixture.run);
  const std::vector<Measured>& measured = fixture.findings.measured;
  ASSERT_EQ(measured.size(), 6u);
  EXPECT_EQ(measured[0].metric, "uv-rms");
  EXPECT_NEAR(measured[0].numerator, 0.25, 1e-6);
  EXPECT_EQ(measured[5].metric, "from-original.normal-rms");
  EXPECT_NEAR(measured[5].numerator, 45, 1e-4);
}

TEST(AttributeErrorPlugin, MeasuresTextureCoordinatesInTheUnitsOfTheFile) {
  Carrying moved = square(0, 1);
  for (glm::vec3& uv : moved.uvs) uv.x += 0.25f;
  const Scene original = scene_of(square());
  const Scene changed =
      testing::in_other_units(scene_of(moved), {.set = 0, .offset = {-3, 1}, .scale = glm::dvec2(0x1p-12)});
  testing::RunFixture fixture;
  fixture.run.original = &original;
  const Technique technique = attribute_error_plugin().create({});
  std::get<std::unique_ptr<DrawEvaluator>>(technique)->evaluate({changed, 0}, fixture.run);
  EXPECT_NEAR(fixture.findings.measured.at(0).numerator, 0.25, 1e-6);
}

}  // namespace
}  // namespace foredraw::attribute_error_test

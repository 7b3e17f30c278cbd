#include "evaluators/vertex_precision/vertex_precision.h"

#include "support/packed_scenes.h"

#include <foredraw/viewing/pose_set.h>

#include <gtest/gtest.h>

#include <cmath>

namespace foredraw::vertex_precision_test {
namespace {

using testing::packed_of;

std::vector<DrawPrecision> precision(const Scene& scene, int threads = 2) {
  return vertex_precision(scene, SubjectUnit::character, make_poses(scene, {.poses = "all"}), Executor(threads));
}

/// Beside errors that are computed here, in another way.
TEST(VertexPrecision, IsTheLargestErrorOfEach) {
  const Scene scene = testing::packed(testing::framed_scene());
  const std::vector<DrawPrecision> all = precision(scene);
  ASSERT_EQ(all.size(), 2u);
  for (const DrawPrecision& of : all) {
    const VertexStreams& vertices = *scene.draws[of.draw].full().vertices;
    const auto positions = decode_vec3(*vertices.find("POSITION")), normals = decode_vec3(*vertices.find("NORMAL"));
    const auto uvs = decode_vec3(*vertices.find("TEXCOORD_0"));
    double position = 0, normal = 0, u = 0;
    for (std::size_t v = 0; v < vertices.count; ++v) {
      const foredraw_packed_vertex is = testing::unpacked_vertex(packed_of(scene).draws[of.draw], v);
      const auto vector = [](const float* values) { return glm::dvec3(values[0], values[1], values[2]); };
      position = std::max(position, glm::distance(glm::dvec3(positions[v]), vector(is.position)));
      const glm::dvec3 apart = glm::normalize(glm::dvec3(normals[v])) - glm::normalize(vector(is.normal));
      normal = std::max(normal, 2 * std::asin(glm::length(apart) / 2) * 57.29577951308232);
      u = std::max(u, std::abs(static_cast<double>(uvs[v].x) - static_cast<double>(is.uv[0])));
    }
    EXPECT_DOUBLE_EQ(of.errors.most.position, position);
    EXPECT_NEAR(of.errors.most.normal, normal, 1e-9);
    EXPECT_DOUBLE_EQ(of.errors.most.u, u);
    EXPECT_LE(of.errors.most.position, of.bounds.position);
    EXPECT_LE(of.errors.most.normal, of.bounds.normal);
    EXPECT_LE(of.errors.most.tangent, of.bounds.tangent);
    EXPECT_EQ(of.packed_bytes, 16u * vertices.count);
    EXPECT_EQ(of.plain_bytes, 48u * vertices.count);
    EXPECT_FALSE(of.posed);
  }
  EXPECT_NEAR(all[0].diagonal, 2 * std::sqrt(3.0), 0.02);
}

TEST(VertexPrecision, CountsTangentsOfTheOtherHandedness) {
  Scene scene = testing::packed(testing::framed_scene());
  PackedVertices all = packed_of(scene);
  std::vector<std::uint32_t> rows(all.draws[0].rows[0].view().begin(), all.draws[0].rows[0].view().end());
  const foredraw_packed_field sign = all.draws[0].layout.field[FOREDRAW_PACKED_SIGN];
  for (const std::size_t v : {0u, 7u, 9u}) rows[4 * v + sign.word] ^= 1u << sign.shift;
  all.draws[0].rows[0] = Shared<std::uint32_t>(rows);
  scene.products.set(all);
  EXPECT_EQ(precision(scene)[0].errors.handedness, 3u);
}

TEST(VertexPrecision, LooksAtThePosedBoxInAllPoses) {
  const Scene scene = testing::packed(testing::BendingTube().scene(2));
  const DrawPrecision tube = precision(scene)[0];
  ASSERT_TRUE(tube.posed);
  EXPECT_EQ(tube.posed->outside, 0u);
  EXPECT_EQ(tube.posed->vertices, 2 * scene.draws[0].full().vertices->count) << "two keys";
  EXPECT_LE(tube.posed->position, tube.posed->bound);
  EXPECT_GT(tube.posed->position, 0.5 * tube.posed->bound);
  EXPECT_GT(tube.posed->diagonal, 2 * std::sqrt(4.0 + 4 + 100));
}

/// A layout that was made for one pose does not hold the others.
TEST(VertexPrecision, CountsWhatThePosedLatticeDoesNotReach) {
  const Scene scene = testing::packed(testing::BendingTube().scene(2), "(moments='0', margin=0)");
  EXPECT_GT(precision(scene)[0].posed->outside, 0u);
}

TEST(VertexPrecision, IsTheSameAtAnyNumberOfThreads) {
  const Scene scene = testing::packed(testing::BendingTube().scene(2));
  const DrawPrecision one = precision(scene, 1)[0], many = precision(scene, 5)[0];
  EXPECT_EQ(one.posed->position, many.posed->position);
  EXPECT_EQ(one.posed->diagonal, many.posed->diagonal);
}

TEST(VertexPrecision, OfWhatIsNotPackedIsNothing) { EXPECT_TRUE(precision(testing::framed_scene()).empty()); }

}  // namespace
}  // namespace foredraw::vertex_precision_test

// Embree asks what is left out: no ray from a hidden triangle gets out of a real model.

#include "plugins/processors/hidden/hidden.h"

#include "support/meshes.h"

#include <foredraw/base/random.h>
#include <foredraw/io/gltf/gltf.h>

#include <embree3/rtcore.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <cmath>
#include <memory>

namespace foredraw::embree_hidden_test {
namespace {

/// Every triangle blocks from both sides.
class Blockers {
 public:
  Blockers(const std::vector<glm::vec3>& positions, std::span<const std::uint32_t> indices)
      : device_(rtcNewDevice(nullptr), rtcReleaseDevice), scene_(rtcNewScene(device_.get()), rtcReleaseScene) {
    rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
    RTCGeometry mesh = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    void* corners = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3),
                                            positions.size());
    std::copy(positions.begin(), positions.end(), static_cast<glm::vec3*>(corners));
    void* triangles = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                              3 * sizeof(std::uint32_t), indices.size() / 3);
    std::copy(indices.begin(), indices.end(), static_cast<std::uint32_t*>(triangles));
    rtcCommitGeometry(mesh);
    rtcAttachGeometry(scene_.get(), mesh);
    rtcReleaseGeometry(mesh);
    rtcCommitScene(scene_.get());
  }

  bool lets_out(const glm::vec3& from, const glm::vec3& direction, float nearest) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay ray{};
    ray.org_x = from.x;
    ray.org_y = from.y;
    ray.org_z = from.z;
    ray.dir_x = direction.x;
    ray.dir_y = direction.y;
    ray.dir_z = direction.z;
    ray.tnear = nearest;
    ray.tfar = std::numeric_limits<float>::infinity();
    ray.mask = ~0u;
    rtcOccluded1(scene_.get(), &context, &ray);
    return ray.tfar > 0;  // of a ray that is blocked it is minus infinity
  }

 private:
  std::unique_ptr<std::remove_pointer_t<RTCDevice>, decltype(&rtcReleaseDevice)> device_;
  std::unique_ptr<std::remove_pointer_t<RTCScene>, decltype(&rtcReleaseScene)> scene_;
};

struct Asked {
  std::size_t hidden = 0, free = 0;
};

/// Sends 4096 rays from each triangle that is hidden.
Asked ask(const std::vector<glm::vec3>& positions, std::span<const std::uint32_t> indices) {
  const OpaqueOrNot draw[] = {{positions, indices, true}};
  HiddenOptions options;
  options.unit = processors::hidden::Unit::triangle;
  options.views = 162;
  options.size = 256;
  options.checks = 100;
  const HiddenTriangles found = hidden_triangles(draw, options, Executor(2));
  const Blockers blockers(positions, indices);
  Random random(99);
  Asked asked;
  for (std::size_t t = 0; t < indices.size() / 3; ++t) {
    if (found.is_hidden[0][t] == 0) continue;
    ++asked.hidden;
    const glm::dvec3 a(positions[indices[3 * t]]), b(positions[indices[3 * t + 1]]), c(positions[indices[3 * t + 2]]);
    const double size = std::sqrt(std::sqrt(glm::dot(glm::cross(b - a, c - a), glm::cross(b - a, c - a))));
    bool gets_out = false;
    for (int i = 0; i < 4096 && !gets_out; ++i) {
      const double u = std::sqrt(random.unit()), v = random.unit();
      const glm::dvec3 middle = (a + b + c) / 3.0;
      const glm::dvec3 from = middle + 0.98 * (a * (1 - u) + b * (u * (1 - v)) + c * (u * v) - middle);
      const double z = 2 * random.unit() - 1, turn = 6.283185307179586 * random.unit();
      const glm::dvec3 to(std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn), z);
      gets_out = blockers.lets_out(glm::vec3(from), glm::vec3(to), static_cast<float>(1e-3 * size));
    }
    asked.free += gets_out;
  }
  std::printf("%zu of %zu triangles hidden, of which %zu see out\n", asked.hidden, indices.size() / 3, asked.free);
  return asked;
}

TEST(HiddenByEmbree, NoRayGetsOutOfWhatIsHidden) {
  // Shells in one another, the outer one with a hole that shows a little of the inner ones.
  testing::TestMesh shells = testing::sphere(24, 13);
  shells.indices.erase(shells.indices.begin() + 900, shells.indices.begin() + 906);
  shells = testing::joined(shells, testing::sphere(24, 13, 0.9f));
  shells.indices.erase(shells.indices.end() - 900, shells.indices.end() - 894);
  shells = testing::joined(shells, testing::torus(24, 8, 0.4f, 0.2f));
  const Asked found = ask(shells.positions, shells.indices);
  EXPECT_GT(found.hidden, 300u);
  EXPECT_EQ(found.free, 0u);
}

/// A real one has triangles of which one ray in ten thousand gets out.
TEST(HiddenByEmbree, HardlyAnyRayGetsOutOfAHead) {
  Diagnostics diagnostics;
  const auto scene = read_gltf(testing::project_file("benchmarks/corpus/static/head.glb"), diagnostics);
  ASSERT_TRUE(scene) << to_text(diagnostics);
  const Level& level = scene->draws[0].full();
  const Asked found = ask(decode_vec3(*level.vertices->find("POSITION")), level.stream().indices.view());
  EXPECT_GT(found.hidden, 1000u);
  EXPECT_LE(found.free, found.hidden / 100);
}

}  // namespace
}  // namespace foredraw::embree_hidden_test

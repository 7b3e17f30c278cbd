#include <foredraw/gpu/clip_space.h>

#include <foredraw/base/random.h>
#include <foredraw/viewing/camera.h>

#include <gtest/gtest.h>

namespace foredraw::gpu::clip_space_test {
namespace {

TEST(GpuClipSpace, shows_what_the_camera_shows) {
  constexpr int size = 100;
  Random random(3);
  const auto signed_unit = [&] { return 2 * random.unit() - 1; };
  for (const double distance : {0.0, 1.5, 4.0}) {
    for (int i = 0; i < 100; ++i) {
      const View view{glm::normalize(glm::dvec3(signed_unit(), signed_unit(), signed_unit())), distance};
      const Camera camera(view, size);
      const glm::mat4 clip = clip_from_position(view);
      const glm::dvec3 position = glm::dvec3(signed_unit(), signed_unit(), signed_unit()) * 0.57;
      const glm::dvec4 at(clip * glm::vec4(position, 1));
      const Corner corner = camera.project(position);
      EXPECT_NEAR((at.x / at.w + 1) / 2 * size, static_cast<double>(corner.x) / subpixels, 0.01);
      EXPECT_NEAR((1 - at.y / at.w) / 2 * size, static_cast<double>(corner.y) / subpixels, 0.01);
      EXPECT_GT(at.z / at.w, 0);
      EXPECT_LT(at.z / at.w, 1);
      const glm::dvec4 nearer(clip * glm::vec4(position + 0.1 * camera.towards(), 1));
      EXPECT_LT(nearer.z / nearer.w, at.z / at.w);
    }
  }
}

}  // namespace
}  // namespace foredraw::gpu::clip_space_test

#include <foredraw/frames/rendering_accuracy.h>

#include <foredraw/frames/picture_error.h>

#include <algorithm>
#include <cmath>

namespace foredraw {

std::array<double, all_renderings.size()> rendering_accuracies(const FrameScene& scene, const FrameMoment& moment,
                                                               std::uint32_t object) {
  const BoundingSphere& sphere = moment.bounds[object].sphere;
  std::array<double, all_renderings.size()> squares{};
  double empty = 0;
  ReferenceRenderer renderer({64, 64}, 2);
  for (int side = 0; side < 8; ++side) {
    const glm::dvec3 direction(side & 1 ? 1 : -1, side & 2 ? 0.5 : -0.5, side & 4 ? 1 : -1);
    // At two radii the sphere just fits into a picture that is 60 degrees high.
    FrameCamera camera = looking_at(sphere.centre + glm::normalize(direction) * (2 * sphere.radius), sphere.centre);
    camera.near = sphere.radius * 0.1;
    const auto drawn = [&](std::span<const DrawnObject> objects) {
      renderer.draw(scene, moment, camera, objects);
      return renderer.picture();
    };
    const DrawnObject in_full{object};
    const FramePicture full = drawn({&in_full, 1});
    const double without = picture_error(drawn({}), full);
    empty += without * without;
    for (std::size_t i = 1; i < all_renderings.size(); ++i) {
      const DrawnObject cheaper{object, 0, all_renderings[i]};
      const double error = picture_error(drawn({&cheaper, 1}), full);
      squares[i] += error * error;
    }
  }
  std::array<double, all_renderings.size()> accuracies{};
  for (std::size_t i = 0; i < accuracies.size(); ++i) {
    accuracies[i] = empty > 0 ? std::max(0.0, 1 - std::sqrt(squares[i] / empty)) : 1;
  }
  return accuracies;
}

}  // namespace foredraw

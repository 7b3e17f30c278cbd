#pragma once
// From where a frame is seen: a pinhole camera that may stand anywhere in the scene.

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace foredraw {

struct FrameSize {
  int width = 640;
  int height = 360;
  friend bool operator==(const FrameSize&, const FrameSize&) = default;
};

/// Axes have length 1 and are at right angles. In world space.
struct FrameCamera {
  glm::dvec3 eye{0};
  glm::dvec3 right{1, 0, 0};
  glm::dvec3 up{0, 1, 0};
  glm::dvec3 ahead{0, 0, -1};
  double half_height = 0.5773502691896258;  ///< of the picture at distance 1: the tangent of half the angle
  double near = 0.05;                       ///< nothing is drawn that is not so far ahead

  /// Pixels across a unit that lies so far ahead.
  double pixels_a_unit(double distance, FrameSize size) const {
    return size.height / (2 * half_height * std::max(distance, near));
  }
};

/// Upright, as far as it can be: +Y is up, but where the camera looks along it.
inline FrameCamera looking_at(const glm::dvec3& eye, const glm::dvec3& target) {
  FrameCamera camera;
  camera.eye = eye;
  const glm::dvec3 ahead = target - eye;
  const double length = std::sqrt(glm::dot(ahead, ahead));
  if (!(length > 0) || !std::isfinite(length)) return camera;
  camera.ahead = ahead / length;
  const glm::dvec3 up = std::abs(camera.ahead.y) < 0.999 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
  const glm::dvec3 right = glm::cross(camera.ahead, up);
  camera.right = right / std::sqrt(glm::dot(right, right));
  camera.up = glm::cross(camera.right, camera.ahead);
  return camera;
}

}  // namespace foredraw

#include <foredraw/gpu/clip_space.h>

#include <foredraw/viewing/camera.h>

#include <algorithm>

namespace foredraw::gpu {

glm::mat4 clip_from_position(const View& view) {
  const Camera camera(view, 1);
  constexpr double hair = 0x1p-16;
  // One row for each of x, y, z and w: the direction that it grows along, and what is added.
  glm::dvec4 x(camera.right() * camera.focal(), 0);
  glm::dvec4 y(-camera.up() * camera.focal(), 0);
  glm::dvec4 z;
  glm::dvec4 w(0, 0, 0, 1);
  if (camera.is_perspective()) {
    const double margin = std::min(hair, (view.distance - 1) / 2);
    const double scale = (view.distance + 1 + margin) / (2 * (1 + margin));  // far / (far - near)
    z = glm::dvec4(-camera.towards() * scale, (1 + margin) * scale);
    w = glm::dvec4(-camera.towards(), view.distance);
  } else {
    z = glm::dvec4(-camera.towards() / (2 * (1 + hair)), 0.5);
  }
  return glm::mat4(glm::transpose(glm::dmat4(x, y, z, w)));
}

}  // namespace foredraw::gpu

#include "frame_camera.h"

#include "placed_draws.h"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <array>
#include <limits>

namespace foredraw::bench {

namespace {

using Corners = std::array<glm::vec3, 8>;

constexpr float farthest_number = std::numeric_limits<float>::max();
constexpr SceneBounds none{glm::vec3(farthest_number), glm::vec3(-farthest_number)};

void add(SceneBounds& bounds, const glm::vec3& point) {
  bounds.least = glm::min(bounds.least, point);
  bounds.most = glm::max(bounds.most, point);
}

Corners corners_of(const SceneBounds& bounds) {
  Corners corners;
  for (std::size_t i = 0; i < 8; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      corners[i][axis] = (i >> axis & 1) != 0 ? bounds.most[axis] : bounds.least[axis];
    }
  }
  return corners;
}

SceneBounds bounds_of(const Draw& draw) {
  SceneBounds bounds = none;
  if (const VertexStream* positions = draw.levels[0].vertices->find("POSITION")) {
    for (const glm::vec3& position : decode_vec3(*positions)) add(bounds, position);
  }
  return bounds;
}

}  // namespace

glm::mat4 seen_from(const glm::vec3& eye, const glm::vec3& target, float nearest, float farthest) {
  glm::mat4 clip = glm::perspectiveRH_ZO(glm::radians(60.0f), 1.0f, nearest, farthest);
  clip[1][1] = -clip[1][1];  // Vulkan's y grows downwards; so the picture is upright, and front faces wind as glTF says
  return clip * glm::lookAtRH(eye, target, glm::vec3(0, 1, 0));
}

SceneBounds bounds_of(const Scene& scene) {
  std::vector<Corners> of_draw;
  for (const Draw& draw : scene.draws) of_draw.push_back(corners_of(bounds_of(draw)));
  SceneBounds bounds = none;
  for (const PlacedDraw& placed : placed_draws(scene)) {
    for (const glm::vec3& corner : of_draw[placed.draw]) add(bounds, glm::vec3(placed.world * glm::vec4(corner, 1)));
  }
  return bounds;
}

glm::mat4 overview(const SceneBounds& bounds, const glm::vec2& side) {
  const glm::vec3 middle = (bounds.least + bounds.most) * 0.5f;
  const float size = glm::length(bounds.most - bounds.least);
  const glm::vec3 eye = middle + size * glm::vec3(side.x, 1.2f, side.y);
  const glm::mat4 clip = seen_from(eye, middle, size * 0.1f, size * 4);
  // Stretched until the box touches the edges of the picture, but for a hair.
  SceneBounds shown = none;
  for (const glm::vec3& corner : corners_of(bounds)) {
    const glm::vec4 at = clip * glm::vec4(corner, 1);
    add(shown, glm::vec3(at) / at.w);
  }
  const glm::vec3 scale = 1.98f / (shown.most - shown.least), centre = (shown.most + shown.least) * 0.5f;
  return glm::scale(glm::mat4(1), glm::vec3(scale.x, scale.y, 1)) *
         glm::translate(glm::mat4(1), glm::vec3(-centre.x, -centre.y, 0)) * clip;
}

}  // namespace foredraw::bench

#include <foredraw/frames/surface_shading.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>

namespace foredraw {

namespace {

/// A vector of length 0 stays as it is.
glm::vec3 unit(const glm::vec3& v) {
  const float squared = glm::dot(v, v);
  return squared > 0 ? v / std::sqrt(squared) : v;
}

glm::vec3 bent_normal(const FrameSurface& surface, const ShadedPoint& point, const glm::vec3& normal) {
  const glm::vec3 texel = glm::vec3(
      sampled(*surface.normal_map, surface.normal_map_sampling, point.normal_map_mip, point.normal_map_place));
  const glm::vec3 bent = texel * 2.0f - 1.0f;
  const glm::vec3 u = unit(point.along_u - normal * glm::dot(normal, point.along_u));
  const glm::vec3 v = unit(point.along_v - normal * glm::dot(normal, point.along_v));
  return unit(u * (bent.x * surface.normal_scale) + v * (bent.y * surface.normal_scale) + normal * bent.z);
}

/// Blinn's highlight; the 32nd power by squaring.
float highlight(const glm::vec3& normal, const glm::vec3& to_eye) {
  float part = std::max(0.0f, glm::dot(normal, unit(frame_light.to_sun + to_eye)));
  for (int i = 0; i < 5; ++i) part *= part;
  return frame_light.highlight * part;
}

}  // namespace

glm::vec4 base_colour(const FrameSurface& surface, const ShadedPoint& point) {
  if (!surface.base) return surface.colour;
  const glm::vec4 texel = sampled(*surface.base, surface.base_sampling, point.base_mip, point.base_place);
  return surface.colour * glm::vec4(texel.x * texel.x, texel.y * texel.y, texel.z * texel.z, texel.w);
}

glm::vec3 shaded(const FrameSurface& surface, Rendering rendering, const ShadedPoint& point, const glm::vec3& base) {
  if (rendering == Rendering::unlit) return base * frame_light.unlit;
  glm::vec3 normal = unit(point.normal);
  if (rendering == Rendering::full && surface.normal_map) normal = bent_normal(surface, point, normal);
  const float upwards = 0.5f + 0.5f * normal.y;
  const glm::vec3 ambient = frame_light.from_ground * (1 - upwards) + frame_light.from_sky * upwards;
  const float lit = std::max(0.0f, glm::dot(normal, frame_light.to_sun));
  return base * (ambient + frame_light.sun * lit) +
         frame_light.sun * (lit > 0 ? highlight(normal, unit(point.to_eye)) : 0);
}

std::size_t mip_level(double texels_a_sample) {
  std::size_t level = 0;
  for (; texels_a_sample > 2 && level < 16; ++level) texels_a_sample /= 4;
  return level;
}

}  // namespace foredraw

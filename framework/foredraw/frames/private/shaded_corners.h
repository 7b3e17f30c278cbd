#pragma once
// A triangle's corners as they are shaded, made for the first of its samples that is seen.

#include <foredraw/frames/frame_scene.h>
#include <foredraw/frames/surface_shading.h>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include <array>
#include <cmath>
#include <span>

namespace foredraw {

struct ShadedCorners {
  std::array<glm::vec3, 3> normals, to_eye;
  std::array<glm::vec2, 3> base_places, normal_map_places;
  ShadedPoint point;  ///< what all samples have in common
};

/// Whose corners they are.
struct ShadedDraw {
  const FrameLevel& level;
  const FrameSurface& surface;
  std::span<const glm::vec3> positions, normals;  ///< in the space that `world` is from
};

/// Where it is, and how the eye sees it.
struct ShadedPlace {
  const glm::mat4& world;
  const glm::mat3& of_normals;
  const glm::dvec3& eye;
  bool is_mirrored, is_back;
};

/// Twice the area that the corners span in the plane, whichever way they turn.
inline double doubled_span(const std::array<glm::vec2, 3>& p) {
  const glm::dvec2 a(p[1] - p[0]), b(p[2] - p[0]);
  return std::abs(a.x * b.y - a.y * b.x);
}

inline double texels_of(const std::shared_ptr<const MippedImage>& image) {
  return image ? static_cast<double>(image->levels.front().width) * image->levels.front().height : 0;
}

/// `area`: twice the triangle's, in samples.
inline ShadedCorners shaded_corners(const ShadedDraw& draw, const std::array<std::uint32_t, 3>& vertices,
                                    const ShadedPlace& place, double area) {
  ShadedCorners made;
  std::array<glm::vec3, 3> places;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t v = vertices[i];
    places[i] = glm::vec3(place.world * glm::vec4(draw.positions[v], 1));
    made.to_eye[i] = glm::vec3(place.eye - glm::dvec3(places[i]));
    if (!draw.normals.empty()) made.normals[i] = place.of_normals * draw.normals[v];
    made.base_places[i] = draw.level.base_places.empty() ? glm::vec2(0) : draw.level.base_places[v];
    made.normal_map_places[i] = draw.level.normal_map_places.empty() ? glm::vec2(0) : draw.level.normal_map_places[v];
  }
  const glm::vec3 a = places[1] - places[0], b = places[2] - places[0];
  if (draw.normals.empty()) {
    const glm::vec3 flat = place.is_mirrored ? glm::cross(b, a) : glm::cross(a, b);
    made.normals = {flat, flat, flat};
  }
  if (place.is_back) {
    for (glm::vec3& normal : made.normals) normal = -normal;
  }
  ShadedPoint& point = made.point;
  point.base_mip = mip_level(doubled_span(made.base_places) * texels_of(draw.surface.base) / area);
  if (!draw.surface.normal_map) return made;
  point.normal_map_mip = mip_level(doubled_span(made.normal_map_places) * texels_of(draw.surface.normal_map) / area);
  // Where u and v grow over the triangle. glTF's v runs down the image, and green upwards.
  const auto& uv = made.normal_map_places;
  const glm::vec2 s = uv[1] - uv[0], t = uv[2] - uv[0];
  const float turn = s.x * t.y - s.y * t.x;
  point.along_u = (a * t.y - b * s.y) * (turn < 0 ? -1.0f : 1.0f);
  point.along_v = (a * t.x - b * s.x) * (turn < 0 ? -1.0f : 1.0f);
  return made;
}

}  // namespace foredraw

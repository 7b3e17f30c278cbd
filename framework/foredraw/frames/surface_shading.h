#pragma once
// The colour of a point on a surface, by each rendering.

#include <foredraw/frames/frame_scene.h>
#include <foredraw/frames/rendering.h>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace foredraw {

/// In world space; vectors need not have length 1.
struct ShadedPoint {
  glm::vec3 normal{0, 0, 1};         ///< towards the side that is seen
  glm::vec3 along_u{0}, along_v{0};  ///< of the normal map; 0 where it has none
  glm::vec3 to_eye{0, 0, 1};
  glm::vec2 base_place{0}, normal_map_place{0};
  std::size_t base_mip = 0, normal_map_mip = 0;
};

/// What shines on everything. Linear colours; whoever draws frames has this light.
struct FrameLight {
  glm::vec3 to_sun;  ///< of length 1
  glm::vec3 sun, from_sky, from_ground;
  float highlight;  ///< how much of the sun it gives back
  float unlit;      ///< what is taken for all of it
};
inline constexpr FrameLight frame_light{{0.3713907f, 0.7427814f, 0.5570860f},
                                        {1.0f, 0.95f, 0.85f},
                                        {0.34f, 0.38f, 0.44f},
                                        {0.22f, 0.2f, 0.17f},
                                        0.25f,
                                        0.6f};

/// The base colour: the image's, times the surface's. Linear, alpha last. Images are taken to be stored by their square
/// root, which is nearly sRGB and needs no power.
glm::vec4 base_colour(const FrameSurface& surface, const ShadedPoint& point);

/// As the eye sees it: one sun, light from the sky and from the ground, and a highlight; or, unlit, the base colour.
glm::vec3 shaded(const FrameSurface& surface, Rendering rendering, const ShadedPoint& point, const glm::vec3& base);

/// What is where no surface is.
inline constexpr glm::vec3 sky_colour{0.42f, 0.52f, 0.66f};

/// The mip level of an image by how many of its texels one sample covers: a power of four for each level.
std::size_t mip_level(double texels_a_sample);

}  // namespace foredraw

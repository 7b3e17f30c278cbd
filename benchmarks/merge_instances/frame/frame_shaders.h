#pragma once
// The text of the shaders that frames are drawn with.

#include "frame_content.h"

#include <string>

namespace foredraw::bench {

/// What the vertex shader is told for each call: `first` alone changes.
struct FrameConstants {
  glm::mat4 clip_from_world{1};
  std::uint32_t first = 0;
};

/// Storage buffers of descriptor set 0. The first five are where merged_shader_text() puts them.
namespace binding {
inline constexpr std::uint32_t slots = 0, indices = 1, transforms = 2, vertices = 3, materials = 4, places = 5,
                               looks = 6, count = 7;
}

/// Vertex inputs of draws that have any.
namespace location {
inline constexpr std::uint32_t position = 0, normal = 1, texture_place = 2, instance = 3;
}

/// `frequency`: of merged draws. Merged draws fetch by the very text that `foredraw optimize -o x.glsl` writes; the
/// others have the same arithmetic written out once more, so that a mistake in either shows.
std::string vertex_shader_text(const Scene& scene, const FramePart& part, std::uint32_t frequency);

/// Writes 32 bits hashed of the place, the look, the triangle's first corner (all bits of its normal in the world and
/// its place in textures), and, rounded, of what is interpolated between all three.
std::string fragment_shader_text();

}  // namespace foredraw::bench

#pragma once
// A displaced surface as its shaders are handed it.

#include <foredraw/displaced/cage_buffers.h>
#include <foredraw/displaced/displaced_mesh.h>
#include <foredraw/displaced/displaced_shader.h>

#include <vulkan/vulkan_core.h>
#include <glm/mat4x4.hpp>

#include <array>
#include <vector>

namespace foredraw::testing {

/// What the push constant of the shaders holds.
struct DisplacedFrame {
  glm::mat4 clip_from_posed{1};
  glm::vec3 eye{0};
  float pixels_per_unit = 1;
};

struct DisplacedSurface {
  DisplacedShader shader;
  HeightMap heights;
  VkFormat format = VK_FORMAT_R16_UNORM;  ///< or R8_UNORM, where heights are multiples of 257, or R16_UINT
  std::vector<std::uint32_t> indices;
  std::vector<glm::vec3> positions, directions;
  std::vector<std::array<std::int32_t, 2>> places;
  std::vector<foredraw_cage_skin> skin;
  std::vector<foredraw_cage_map> maps = {{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}}};
  std::vector<TessellationLevels> levels;  ///< where they are stored
  std::vector<std::uint32_t> seams;        ///< words, where they are read
};

}  // namespace foredraw::testing

#pragma once
// How triangles are drawn into pictures.

#include <foredraw/gpu/device.h>

#include <cstdint>
#include <span>

namespace foredraw::gpu {

/// SPIR-V, as words.
OwnedShader make_shader(const Device& device, std::span<const std::uint32_t> code);

/// `constants`: bytes of push constants, which the shaders of `stages` read.
OwnedPipelineLayout pipeline_layout(const Device& device, std::span<const VkDescriptorSetLayout> sets,
                                    VkShaderStageFlags stages, std::uint32_t constants);

/// An attribute, one behind the other in a vertex buffer of its own.
struct VertexInput {
  std::uint32_t location = 0;  ///< in the vertex shader
  std::uint32_t buffer = 0;
  std::uint32_t stride = 0;  ///< bytes
  VkFormat format = VK_FORMAT_UNDEFINED;
};

/// What pipelines differ in.
struct PipelineState {
  VkPipelineLayout layout = VK_NULL_HANDLE;
  VkRenderPass render_pass = VK_NULL_HANDLE;  ///< as make_render_pass() makes it
  VkShaderModule vertex_shader = VK_NULL_HANDLE;
  VkShaderModule fragment_shader = VK_NULL_HANDLE;  ///< none: nothing is rasterised
  /// Both, on devices that tessellate: then what is drawn is a list of patches of three vertices each.
  VkShaderModule control_shader = VK_NULL_HANDLE, evaluation_shader = VK_NULL_HANDLE;
  const VkSpecializationInfo* fragment_constants = nullptr;
  std::span<const VertexInput> inputs;
  VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;  ///< of what is no patch
  VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
  bool has_pixels = true;  ///< no: the render pass has no attachments, fragment shaders write into buffers alone
  VkCullModeFlags culled = VK_CULL_MODE_BACK_BIT;
  VkFrontFace front_face = VK_FRONT_FACE_COUNTER_CLOCKWISE;
  VkCompareOp passing = VK_COMPARE_OP_LESS;
  bool writes_depth = true;
  float depth_bias_by_slope = 0;  ///< away, times the depth's slope per pixel
  VkColorComponentFlags written = VK_COLOR_COMPONENT_R_BIT;
  bool blends = false;  ///< by the alpha that the fragment shader gives
};

/// For lists of triangles or patches with a depth test, where what passes writes its number or colour, and its depth.
/// Viewport and scissor are set by whoever draws (Pictures::begin does), so that a pipeline serves every size of
/// picture.
OwnedPipeline graphics_pipeline(const Device& device, const PipelineState& state);

}  // namespace foredraw::gpu

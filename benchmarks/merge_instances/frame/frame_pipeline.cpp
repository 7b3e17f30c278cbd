#include "frame_pipeline.h"

#include "frame_shaders.h"

#include <array>
#include <stdexcept>

namespace foredraw::bench {

namespace {

/// Vertex buffers and attributes of what a part's shader reads. Buffer i holds stream i; one more, the instances.
struct VertexInputs {
  std::vector<VkVertexInputBindingDescription> bindings;
  std::vector<VkVertexInputAttributeDescription> attributes;
};

VkFormat float_format(const VertexStream& stream, std::uint8_t components) {
  if (stream.format.component != Component::float32 || stream.format.components != components) {
    throw std::runtime_error("frames are drawn of attributes of floats, and " + stream.semantic + " is not made of " +
                             std::to_string(components) + "; decode it before");
  }
  return components == 3 ? VK_FORMAT_R32G32B32_SFLOAT : VK_FORMAT_R32G32_SFLOAT;
}

VertexInputs vertex_inputs(const FramePart& part) {
  VertexInputs inputs;
  if (part.fetch == VertexFetch::merged) return inputs;
  const auto add = [&](std::uint32_t buffer, std::uint32_t stride, std::uint32_t location, VkFormat format) {
    inputs.bindings.push_back({buffer, stride, VK_VERTEX_INPUT_RATE_VERTEX});
    inputs.attributes.push_back({location, buffer, format, 0});
  };
  std::uint32_t buffer = 0;
  for (const VertexStream& stream : part.vertices->base) {
    if (stream.semantic == "POSITION") add(buffer, stream.format.bytes, location::position, float_format(stream, 3));
    if (stream.semantic == "NORMAL") add(buffer, stream.format.bytes, location::normal, float_format(stream, 3));
    if (stream.semantic == "TEXCOORD_0") add(buffer, stream.format.bytes, location::texture_place, float_format(stream, 2));
    ++buffer;
  }
  if (part.fetch == VertexFetch::in_world) add(buffer, sizeof(std::uint32_t), location::instance, VK_FORMAT_R32_UINT);
  return inputs;
}

VkPipelineShaderStageCreateInfo stage(VkShaderStageFlagBits stage, VkShaderModule shader) {
  VkPipelineShaderStageCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
  info.stage = stage;
  info.module = shader;
  info.pName = "main";
  return info;
}

}  // namespace

OwnedPipeline frame_pipeline(FrameDevice& device, const Scene& scene, const FramePart& part, std::uint32_t frequency,
                             bool is_mirrored) {
  const std::array stages = {
      stage(VK_SHADER_STAGE_VERTEX_BIT, device.vertex_shader(vertex_shader_text(scene, part, frequency))),
      stage(VK_SHADER_STAGE_FRAGMENT_BIT, device.fragment_shader())};
  const VertexInputs inputs = vertex_inputs(part);
  VkPipelineVertexInputStateCreateInfo vertices{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
  vertices.vertexBindingDescriptionCount = static_cast<std::uint32_t>(inputs.bindings.size());
  vertices.pVertexBindingDescriptions = inputs.bindings.data();
  vertices.vertexAttributeDescriptionCount = static_cast<std::uint32_t>(inputs.attributes.size());
  vertices.pVertexAttributeDescriptions = inputs.attributes.data();
  VkPipelineInputAssemblyStateCreateInfo assembly{VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
  assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  VkPipelineViewportStateCreateInfo viewport{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
  viewport.viewportCount = 1;
  viewport.scissorCount = 1;
  constexpr std::array set_later = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
  VkPipelineDynamicStateCreateInfo dynamic{VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
  dynamic.dynamicStateCount = set_later.size();
  dynamic.pDynamicStates = set_later.data();
  VkPipelineRasterizationStateCreateInfo rasterised{VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
  rasterised.cullMode = VK_CULL_MODE_BACK_BIT;
  rasterised.frontFace = is_mirrored ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE;
  rasterised.lineWidth = 1;
  VkPipelineMultisampleStateCreateInfo samples{VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
  samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
  VkPipelineDepthStencilStateCreateInfo depth{VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
  depth.depthTestEnable = VK_TRUE;
  depth.depthWriteEnable = VK_TRUE;
  depth.depthCompareOp = VK_COMPARE_OP_LESS;
  VkPipelineColorBlendAttachmentState shown{};
  shown.colorWriteMask = VK_COLOR_COMPONENT_R_BIT;
  VkPipelineColorBlendStateCreateInfo colours{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
  colours.attachmentCount = 1;
  colours.pAttachments = &shown;

  VkGraphicsPipelineCreateInfo info{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
  info.stageCount = stages.size();
  info.pStages = stages.data();
  info.pVertexInputState = &vertices;
  info.pInputAssemblyState = &assembly;
  info.pViewportState = &viewport;
  info.pRasterizationState = &rasterised;
  info.pMultisampleState = &samples;
  info.pDepthStencilState = &depth;
  info.pColorBlendState = &colours;
  info.pDynamicState = &dynamic;
  info.layout = device.layout();
  info.renderPass = device.render_pass();
  return OwnedPipeline(device.device().get(), info, "vkCreateGraphicsPipelines");
}

}  // namespace foredraw::bench

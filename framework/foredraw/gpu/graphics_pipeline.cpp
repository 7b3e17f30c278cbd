#include <foredraw/gpu/graphics_pipeline.h>

#include <array>
#include <vector>

namespace foredraw::gpu {

namespace {

VkPipelineShaderStageCreateInfo stage(VkShaderStageFlagBits stage, VkShaderModule shader,
                                      const VkSpecializationInfo* constants = nullptr) {
  VkPipelineShaderStageCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
  info.stage = stage;
  info.module = shader;
  info.pName = "main";
  info.pSpecializationInfo = constants;
  return info;
}

}  // namespace

OwnedShader make_shader(const Device& device, std::span<const std::uint32_t> code) {
  VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
  info.codeSize = code.size_bytes();
  info.pCode = code.data();
  return OwnedShader(device.get(), info, "vkCreateShaderModule");
}

OwnedPipelineLayout pipeline_layout(const Device& device, std::span<const VkDescriptorSetLayout> sets,
                                    VkShaderStageFlags stages, std::uint32_t constants) {
  const VkPushConstantRange range{stages, 0, constants};
  VkPipelineLayoutCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  info.setLayoutCount = static_cast<std::uint32_t>(sets.size());
  info.pSetLayouts = sets.data();
  info.pushConstantRangeCount = constants > 0 ? 1 : 0;
  info.pPushConstantRanges = &range;
  return OwnedPipelineLayout(device.get(), info, "vkCreatePipelineLayout");
}

OwnedPipeline graphics_pipeline(const Device& device, const PipelineState& state) {
  const std::array stages = {stage(VK_SHADER_STAGE_VERTEX_BIT, state.vertex_shader),
                             stage(VK_SHADER_STAGE_FRAGMENT_BIT, state.fragment_shader, state.fragment_constants)};
  std::vector<VkVertexInputBindingDescription> bindings;
  std::vector<VkVertexInputAttributeDescription> attributes;
  for (const VertexInput& input : state.inputs) {
    bindings.push_back({input.buffer, input.stride, VK_VERTEX_INPUT_RATE_VERTEX});
    attributes.push_back({input.location, input.buffer, input.format, 0});
  }
  VkPipelineVertexInputStateCreateInfo vertices{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
  vertices.vertexBindingDescriptionCount = static_cast<std::uint32_t>(bindings.size());
  vertices.pVertexBindingDescriptions = bindings.data();
  vertices.vertexAttributeDescriptionCount = static_cast<std::uint32_t>(attributes.size());
  vertices.pVertexAttributeDescriptions = attributes.data();
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
  rasterised.cullMode = state.culled;
  rasterised.frontFace = state.front_face;
  rasterised.lineWidth = 1;
  VkPipelineMultisampleStateCreateInfo samples{VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
  samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
  VkPipelineDepthStencilStateCreateInfo depth{VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
  depth.depthTestEnable = VK_TRUE;
  depth.depthWriteEnable = VK_TRUE;
  depth.depthCompareOp = state.passing;
  VkPipelineColorBlendAttachmentState number{};
  number.colorWriteMask = VK_COLOR_COMPONENT_R_BIT;
  VkPipelineColorBlendStateCreateInfo colours{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
  colours.attachmentCount = 1;
  colours.pAttachments = &number;

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
  info.layout = state.layout;
  info.renderPass = state.render_pass;
  return OwnedPipeline(device.get(), info, "vkCreateGraphicsPipelines");
}

}  // namespace foredraw::gpu

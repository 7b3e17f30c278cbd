#include <foredraw/gpu/graphics_pipeline.h>

#include <array>
#include <vector>

namespace foredraw::gpu {

namespace {

VkPipelineShaderStageCreateInfo stage(VkShaderStageFlagBits stage, VkShaderModule shader,
                                      const VkSpecializationInfo* constants = nullptr) {
  return {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
          .stage = stage,
          .module = shader,
          .pName = "main",
          .pSpecializationInfo = constants};
}

}  // namespace

OwnedShader make_shader(const Device& device, std::span<const std::uint32_t> code) {
  const VkShaderModuleCreateInfo info{
      .sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO, .codeSize = code.size_bytes(), .pCode = code.data()};
  return OwnedShader(device.get(), info, "vkCreateShaderModule");
}

OwnedPipelineLayout pipeline_layout(const Device& device, std::span<const VkDescriptorSetLayout> sets,
                                    VkShaderStageFlags stages, std::uint32_t constants) {
  const VkPushConstantRange range{stages, 0, constants};
  const VkPipelineLayoutCreateInfo info{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                        .setLayoutCount = static_cast<std::uint32_t>(sets.size()),
                                        .pSetLayouts = sets.data(),
                                        .pushConstantRangeCount = constants > 0 ? 1u : 0u,
                                        .pPushConstantRanges = &range};
  return OwnedPipelineLayout(device.get(), info, "vkCreatePipelineLayout");
}

OwnedPipeline graphics_pipeline(const Device& device, const PipelineState& state) {
  const bool has_patches = state.control_shader != VK_NULL_HANDLE,
             has_fragments = state.fragment_shader != VK_NULL_HANDLE;
  std::vector stages = {stage(VK_SHADER_STAGE_VERTEX_BIT, state.vertex_shader)};
  if (has_patches) {
    stages.push_back(stage(VK_SHADER_STAGE_TESSELLATION_CONTROL_BIT, state.control_shader));
    stages.push_back(stage(VK_SHADER_STAGE_TESSELLATION_EVALUATION_BIT, state.evaluation_shader));
  }
  if (has_fragments) {
    stages.push_back(stage(VK_SHADER_STAGE_FRAGMENT_BIT, state.fragment_shader, state.fragment_constants));
  }
  std::vector<VkVertexInputBindingDescription> bindings;
  std::vector<VkVertexInputAttributeDescription> attributes;
  for (const VertexInput& input : state.inputs) {
    bindings.push_back({input.buffer, input.stride, VK_VERTEX_INPUT_RATE_VERTEX});
    attributes.push_back({input.location, input.buffer, input.format, 0});
  }
  const VkPipelineVertexInputStateCreateInfo vertices{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO,
      .vertexBindingDescriptionCount = static_cast<std::uint32_t>(bindings.size()),
      .pVertexBindingDescriptions = bindings.data(),
      .vertexAttributeDescriptionCount = static_cast<std::uint32_t>(attributes.size()),
      .pVertexAttributeDescriptions = attributes.data()};
  const VkPipelineInputAssemblyStateCreateInfo assembly{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO,
      .topology = has_patches ? VK_PRIMITIVE_TOPOLOGY_PATCH_LIST : state.topology};
  const VkPipelineTessellationStateCreateInfo patches{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_TESSELLATION_STATE_CREATE_INFO, .patchControlPoints = 3};
  const VkPipelineViewportStateCreateInfo viewport{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO, .viewportCount = 1, .scissorCount = 1};
  constexpr std::array set_later = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
  const VkPipelineDynamicStateCreateInfo dynamic{.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO,
                                                 .dynamicStateCount = set_later.size(),
                                                 .pDynamicStates = set_later.data()};
  const VkPipelineRasterizationStateCreateInfo rasterised{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO,
      .rasterizerDiscardEnable = has_fragments ? VK_FALSE : VK_TRUE,
      .cullMode = state.culled,
      .frontFace = state.front_face,
      .depthBiasEnable = state.depth_bias_by_slope != 0,
      .depthBiasSlopeFactor = state.depth_bias_by_slope,
      .lineWidth = 1};
  const VkPipelineMultisampleStateCreateInfo samples{.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
                                                     .rasterizationSamples = state.samples};
  const VkPipelineDepthStencilStateCreateInfo depth{.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO,
                                                    .depthTestEnable = VK_TRUE,
                                                    .depthWriteEnable = state.writes_depth ? VK_TRUE : VK_FALSE,
                                                    .depthCompareOp = state.passing};
  const VkPipelineColorBlendAttachmentState pixels{.blendEnable = state.blends ? VK_TRUE : VK_FALSE,
                                                   .srcColorBlendFactor = VK_BLEND_FACTOR_SRC_ALPHA,
                                                   .dstColorBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA,
                                                   .colorBlendOp = VK_BLEND_OP_ADD,
                                                   .colorWriteMask = state.written};
  const VkPipelineColorBlendStateCreateInfo colours{.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
                                                    .attachmentCount = state.has_pixels ? 1u : 0u,
                                                    .pAttachments = &pixels};
  const VkGraphicsPipelineCreateInfo info{.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
                                          .stageCount = static_cast<std::uint32_t>(stages.size()),
                                          .pStages = stages.data(),
                                          .pVertexInputState = &vertices,
                                          .pInputAssemblyState = &assembly,
                                          .pTessellationState = has_patches ? &patches : nullptr,
                                          .pViewportState = &viewport,
                                          .pRasterizationState = &rasterised,
                                          .pMultisampleState = &samples,
                                          .pDepthStencilState = &depth,
                                          .pColorBlendState = &colours,
                                          .pDynamicState = &dynamic,
                                          .layout = state.layout,
                                          .renderPass = state.render_pass};
  return OwnedPipeline(device.get(), info, "vkCreateGraphicsPipelines");
}

}  // namespace foredraw::gpu

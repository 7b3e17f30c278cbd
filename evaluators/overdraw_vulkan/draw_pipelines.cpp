#include "draw_pipelines.h"

#include "render_pass.h"

#include "shaders/counted_frag.h"
#include "shaders/draw_vert.h"
#include "shaders/heavy_frag.h"
#include "shaders/masked_frag.h"
#include "shaders/masked_vert.h"
#include "shaders/owner_frag.h"

#include <glm/vec3.hpp>

#include <array>
#include <span>

namespace foredraw {

namespace {

OwnedShader make_shader(const VulkanDevice& device, std::span<const std::uint32_t> code) {
  VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
  info.codeSize = code.size_bytes();
  info.pCode = code.data();
  return OwnedShader(device.get(), info, "vkCreateShaderModule");
}

/// One buffer for the fragment shader.
OwnedSetLayout make_set_layout(const VulkanDevice& device) {
  VkDescriptorSetLayoutBinding buffer{};
  buffer.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
  buffer.descriptorCount = 1;
  buffer.stageFlags = VK_SHADER_STAGE_FRAGMENT_BIT;
  VkDescriptorSetLayoutCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  info.bindingCount = 1;
  info.pBindings = &buffer;
  return OwnedSetLayout(device.get(), info, "vkCreateDescriptorSetLayout");
}

OwnedDescriptorPool make_set_pool(const VulkanDevice& device) {
  const VkDescriptorPoolSize two{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 2};
  VkDescriptorPoolCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  info.maxSets = 2;
  info.poolSizeCount = 1;
  info.pPoolSizes = &two;
  return OwnedDescriptorPool(device.get(), info, "vkCreateDescriptorPool");
}

OwnedPipelineLayout make_layout(const VulkanDevice& device, VkDescriptorSetLayout set) {
  const VkPushConstantRange constants{VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0,
                                      sizeof(DrawConstants)};
  VkPipelineLayoutCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  const std::array sets = {set, set};  // counters, texels
  info.setLayoutCount = sets.size();
  info.pSetLayouts = sets.data();
  info.pushConstantRangeCount = 1;
  info.pPushConstantRanges = &constants;
  return OwnedPipelineLayout(device.get(), info, "vkCreatePipelineLayout");
}

VkPipelineShaderStageCreateInfo stage(VkShaderStageFlagBits stage, VkShaderModule shader) {
  VkPipelineShaderStageCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
  info.stage = stage;
  info.module = shader;
  info.pName = "main";
  return info;
}

VkPipelineRasterizationStateCreateInfo rasterisation(Culled culled) {
  VkPipelineRasterizationStateCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
  info.cullMode = culled == Culled::none ? VK_CULL_MODE_NONE : VK_CULL_MODE_BACK_BIT;
  info.frontFace = culled == Culled::counter_clockwise ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE;
  info.lineWidth = 1;
  return info;
}

}  // namespace

DrawPipelines::DrawPipelines(const VulkanDevice& device)
    : device_(device),
      render_pass_(make_render_pass(device)),
      set_layout_(make_set_layout(device)),
      set_pool_(make_set_pool(device)),
      layout_(make_layout(device, set_layout_.get())),
      vertex_shader_(make_shader(device, draw_vert)),
      masked_vertex_shader_(make_shader(device, masked_vert)),
      masked_fragment_shader_(make_shader(device, masked_frag)) {
  fragment_shaders_.emplace(Shading::owner, make_shader(device, owner_frag));
  fragment_shaders_.emplace(Shading::counted, make_shader(device, counted_frag));
  fragment_shaders_.emplace(Shading::heavy, make_shader(device, heavy_frag));
  counters_ = allocated();
  texels_ = allocated();
}

VkDescriptorSet DrawPipelines::allocated() const {
  const VkDescriptorSetLayout layout = set_layout_.get();
  VkDescriptorSetAllocateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  info.descriptorPool = set_pool_.get();
  info.descriptorSetCount = 1;
  info.pSetLayouts = &layout;
  VkDescriptorSet set = VK_NULL_HANDLE;
  check(vkAllocateDescriptorSets(device_.get(), &info, &set), "vkAllocateDescriptorSets");
  return set;
}

VkPipeline DrawPipelines::get(Shading shading, Passing passing, Culled culled, bool has_holes) {
  OwnedPipeline& pipeline = pipelines_[{shading, passing, culled, has_holes}];
  if (pipeline.get() == VK_NULL_HANDLE) pipeline = make(shading, passing, culled, has_holes);
  return pipeline.get();
}

VkDescriptorSet DrawPipelines::counters_at(VkBuffer counters) {
  write(counters_, counters);
  return counters_;
}

void DrawPipelines::write(VkDescriptorSet set, VkBuffer buffer) const {
  const VkDescriptorBufferInfo whole{buffer, 0, VK_WHOLE_SIZE};
  VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
  write.dstSet = set;
  write.descriptorCount = 1;
  write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
  write.pBufferInfo = &whole;
  vkUpdateDescriptorSets(device_.get(), 1, &write, 0, nullptr);
}

OwnedPipeline DrawPipelines::make(Shading shading, Passing passing, Culled culled, bool has_holes) const {
  std::array stages = {
      stage(VK_SHADER_STAGE_VERTEX_BIT, has_holes ? masked_vertex_shader_.get() : vertex_shader_.get()),
      stage(VK_SHADER_STAGE_FRAGMENT_BIT,
            has_holes ? masked_fragment_shader_.get() : fragment_shaders_.at(shading).get())};
  const VkBool32 is_heavy = shading == Shading::heavy ? VK_TRUE : VK_FALSE;
  const VkSpecializationMapEntry entry{0, 0, sizeof(is_heavy)};
  const VkSpecializationInfo special{1, &entry, sizeof(is_heavy), &is_heavy};
  if (has_holes) stages[1].pSpecializationInfo = &special;
  // Positions, and of parts with holes the places in their images.
  constexpr std::array bindings = {VkVertexInputBindingDescription{0, sizeof(glm::vec3), VK_VERTEX_INPUT_RATE_VERTEX},
                                   VkVertexInputBindingDescription{1, sizeof(glm::vec3), VK_VERTEX_INPUT_RATE_VERTEX}};
  constexpr std::array attributes = {VkVertexInputAttributeDescription{0, 0, VK_FORMAT_R32G32B32_SFLOAT, 0},
                                     VkVertexInputAttributeDescription{1, 1, VK_FORMAT_R32G32B32_SFLOAT, 0}};
  VkPipelineVertexInputStateCreateInfo vertices{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
  vertices.vertexBindingDescriptionCount = has_holes ? 2 : 1;
  vertices.pVertexBindingDescriptions = bindings.data();
  vertices.vertexAttributeDescriptionCount = has_holes ? 2 : 1;
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
  const VkPipelineRasterizationStateCreateInfo rasterised = rasterisation(culled);
  VkPipelineMultisampleStateCreateInfo samples{VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
  samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
  VkPipelineDepthStencilStateCreateInfo depth{VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
  depth.depthTestEnable = VK_TRUE;
  depth.depthWriteEnable = VK_TRUE;
  depth.depthCompareOp = passing == Passing::nearer ? VK_COMPARE_OP_LESS : VK_COMPARE_OP_LESS_OR_EQUAL;
  VkPipelineColorBlendAttachmentState owner{};
  owner.colorWriteMask = VK_COLOR_COMPONENT_R_BIT;
  VkPipelineColorBlendStateCreateInfo colours{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
  colours.attachmentCount = 1;
  colours.pAttachments = &owner;

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
  info.layout = layout();
  info.renderPass = render_pass();
  return OwnedPipeline(device_.get(), info, "vkCreateGraphicsPipelines");
}

}  // namespace foredraw

#include "frame_device.h"

#include "frame_shaders.h"
#include "shader_compiler.h"

#include <evaluators/overdraw_vulkan/render_pass.h>

#include <array>

namespace foredraw::bench {

namespace {

OwnedSetLayout make_set_layout(const VulkanDevice& device) {
  std::array<VkDescriptorSetLayoutBinding, binding::count> buffers{};
  for (std::uint32_t i = 0; i < binding::count; ++i) {
    buffers[i] = {i, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_VERTEX_BIT, nullptr};
  }
  VkDescriptorSetLayoutCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  info.bindingCount = buffers.size();
  info.pBindings = buffers.data();
  return OwnedSetLayout(device.get(), info, "vkCreateDescriptorSetLayout");
}

OwnedPipelineLayout make_layout(const VulkanDevice& device, VkDescriptorSetLayout set) {
  const VkPushConstantRange constants{VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof(FrameConstants)};
  VkPipelineLayoutCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  info.setLayoutCount = 1;
  info.pSetLayouts = &set;
  info.pushConstantRangeCount = 1;
  info.pPushConstantRanges = &constants;
  return OwnedPipelineLayout(device.get(), info, "vkCreatePipelineLayout");
}

OwnedShader make_shader(const VulkanDevice& device, const std::string& text, const char* stage) {
  const std::vector<std::uint32_t> code = compiled_shader(text, stage);
  VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
  info.codeSize = code.size() * sizeof(std::uint32_t);
  info.pCode = code.data();
  return OwnedShader(device.get(), info, "vkCreateShaderModule");
}

}  // namespace

FrameDevice::FrameDevice(int size, const VulkanChoice& choice)
    : device_(choice),
      render_pass_(make_render_pass(device_)),
      pictures_(device_, render_pass_.get(), size),
      set_layout_(make_set_layout(device_)),
      layout_(make_layout(device_, set_layout_.get())),
      fragment_shader_(make_shader(device_, fragment_shader_text(), "frag")) {}

VkShaderModule FrameDevice::vertex_shader(const std::string& text) {
  OwnedShader& shader = vertex_shaders_[text];
  if (shader.get() == VK_NULL_HANDLE) shader = make_shader(device_, text, "vert");
  return shader.get();
}

}  // namespace foredraw::bench

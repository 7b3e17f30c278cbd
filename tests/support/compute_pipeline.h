#pragma once
// Compute shaders, for tests of what they compute.

#include <foredraw/gpu/graphics_pipeline.h>

namespace foredraw::testing {

inline VkResult create_compute_pipeline(VkDevice device, const VkComputePipelineCreateInfo* info,
                                        const VkAllocationCallbacks* allocator, VkPipeline* pipeline) {
  return vkCreateComputePipelines(device, VK_NULL_HANDLE, 1, info, allocator, pipeline);
}
using ComputePipeline = gpu::Owned<VkPipeline, create_compute_pipeline, vkDestroyPipeline>;

/// The shader's main().
inline ComputePipeline compute_pipeline(const gpu::Device& device, VkShaderModule shader, VkPipelineLayout layout) {
  const VkComputePipelineCreateInfo info{.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
                                         .stage = {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                                                   .stage = VK_SHADER_STAGE_COMPUTE_BIT,
                                                   .module = shader,
                                                   .pName = "main"},
                                         .layout = layout};
  return ComputePipeline(device.get(), info, "vkCreateComputePipelines");
}

}  // namespace foredraw::testing

#include <foredraw/gpu/handle.h>

#include <stdexcept>
#include <string>

namespace foredraw::gpu {

namespace {

std::string explained(VkResult result) {
  switch (result) {
    case VK_ERROR_OUT_OF_HOST_MEMORY: return "out of memory; ask for smaller pictures";
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
      return "the device is out of memory; ask for smaller pictures or another device";
    case VK_ERROR_DEVICE_LOST:
      return "the device was lost: its driver failed, or one draw took too long; ask for smaller pictures or another "
             "device";
    case VK_ERROR_INITIALIZATION_FAILED: return "the driver could not start; check that vulkaninfo works";
    case VK_ERROR_INCOMPATIBLE_DRIVER: return "no Vulkan driver; install one, such as mesa-vulkan-drivers";
    case VK_ERROR_LAYER_NOT_PRESENT: return "the validation layer is missing; install vulkan-validationlayers";
    default: return "VkResult " + std::to_string(result);
  }
}

}  // namespace

void check(VkResult result, const char* call) {
  if (result == VK_SUCCESS) return;
  throw std::runtime_error(std::string(call) + " failed: " + explained(result));
}

VkResult create_pipeline(VkDevice device, const VkGraphicsPipelineCreateInfo* info,
                         const VkAllocationCallbacks* allocator, VkPipeline* pipeline) {
  return vkCreateGraphicsPipelines(device, VK_NULL_HANDLE, 1, info, allocator, pipeline);
}

}  // namespace foredraw::gpu

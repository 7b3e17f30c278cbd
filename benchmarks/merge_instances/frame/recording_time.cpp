#include "recording_time.h"

#include <chrono>

namespace foredraw::bench {

RecordingTime::RecordingTime(FrameDevice& device) : device_(device) {
  VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
  pool.queueFamilyIndex = device.device().queue_family();
  pool_ = gpu::OwnedCommandPool(device.device().get(), pool, "vkCreateCommandPool");
  VkCommandBufferAllocateInfo one{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
  one.commandPool = pool_.get();
  one.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  one.commandBufferCount = 1;
  gpu::check(vkAllocateCommandBuffers(device.device().get(), &one, &commands_), "vkAllocateCommandBuffers");
}

double RecordingTime::milliseconds(const Frame& frame) {
  gpu::check(vkResetCommandPool(device_.device().get(), pool_.get(), 0), "vkResetCommandPool");
  const auto begin = std::chrono::steady_clock::now();
  const VkCommandBufferBeginInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  gpu::check(vkBeginCommandBuffer(commands_, &info), "vkBeginCommandBuffer");
  device_.pictures().begin(commands_, 0);
  frame.record(commands_, glm::mat4(1));
  vkCmdEndRenderPass(commands_);
  gpu::check(vkEndCommandBuffer(commands_), "vkEndCommandBuffer");
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace foredraw::bench

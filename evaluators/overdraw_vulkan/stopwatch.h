#pragma once
#include "vulkan_device.h"

namespace foredraw {

/// The device's own clock. Only for devices that have one: those with a timestamp_mask().
class Stopwatch {
 public:
  explicit Stopwatch(VulkanDevice& device);

  /// Runs what is recorded, and gives the nanoseconds from its first command to the end of its last.
  double time(const std::function<void(VkCommandBuffer)>& record);

 private:
  VulkanDevice& device_;
  OwnedQueryPool stamps_;
};

}  // namespace foredraw

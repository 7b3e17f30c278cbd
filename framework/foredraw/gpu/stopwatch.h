#pragma once
#include <foredraw/gpu/queries.h>

namespace foredraw::gpu {

/// The device's own clock. Only for devices that have one: those with a timestamp_mask().
class Stopwatch {
 public:
  explicit Stopwatch(Device& device) : device_(device), stamps_(device, VK_QUERY_TYPE_TIMESTAMP, 2) {}

  /// Runs what is recorded, and gives the nanoseconds from its first command to the end of its last.
  double time(const std::function<void(VkCommandBuffer)>& record);

 private:
  Device& device_;
  Queries stamps_;
};

}  // namespace foredraw::gpu

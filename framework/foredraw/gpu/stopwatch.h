#pragma once
#include <foredraw/gpu/device.h>

namespace foredraw::gpu {

/// Runs what is recorded, and gives the nanoseconds from its first command to the end of its last, by the device's own
/// clock. Only for devices that have one: those with a timestamp_mask().
double nanoseconds(Device& device, const std::function<void(VkCommandBuffer)>& record);

}  // namespace foredraw::gpu

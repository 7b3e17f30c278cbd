#pragma once
// Which of a machine's devices will do.

#include <foredraw/gpu/instance.h>

#include <cstdint>
#include <string>

namespace foredraw::gpu {

/// A device that can do all that is asked of it.
struct Candidate {
  VkPhysicalDevice device = VK_NULL_HANDLE;
  VkPhysicalDeviceProperties properties{};
  VkPhysicalDeviceFeatures features{};  ///< those that are needed, and of those that are used what it has
  std::uint32_t queue_family = 0;
  std::uint32_t timestamp_bits = 0;
  VkFormat depth_format = VK_FORMAT_UNDEFINED;
  bool has_transform_feedback = false;
};

/// The first of discrete, integrated, virtual and CPU devices whose name holds `name`, in any case. Throws
/// std::runtime_error where there is none: with the names of those that there are, and what each lacks.
Candidate chosen_device(VkInstance instance, const std::string& name);

}  // namespace foredraw::gpu

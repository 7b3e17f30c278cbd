#pragma once
// The way to the drivers, and the validation layer's way back.

#include "vulkan_handle.h"

#include <string>
#include <vector>

namespace foredraw {

inline constexpr const char* no_vulkan_device = "no Vulkan device: install a driver or mesa-vulkan-drivers";

class VulkanInstance {
 public:
  /// `complaints`: where the validation layer's messages are put, until this ends; null: without the layer. Throws
  /// std::runtime_error where there is no driver, or no layer.
  explicit VulkanInstance(std::vector<std::string>* complaints = nullptr);
  ~VulkanInstance();
  VulkanInstance(const VulkanInstance&) = delete;
  VulkanInstance& operator=(const VulkanInstance&) = delete;

  VkInstance get() const { return instance_; }

 private:
  VkInstance instance_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
};

}  // namespace foredraw

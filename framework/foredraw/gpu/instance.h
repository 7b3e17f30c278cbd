#pragma once
// The way to the drivers, and the validation layer's way back.

#include <foredraw/gpu/handle.h>

#include <string>
#include <vector>

namespace foredraw::gpu {

inline constexpr const char* no_device = "no Vulkan device: install a driver, such as mesa-vulkan-drivers";

class Instance {
 public:
  /// `complaints`: where the validation layer's messages are put, until this ends; null: without the layer. Throws
  /// std::runtime_error where there is no driver, or no layer.
  explicit Instance(std::vector<std::string>* complaints = nullptr);
  ~Instance();
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  VkInstance get() const { return instance_; }

 private:
  VkInstance instance_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
};

}  // namespace foredraw::gpu

#pragma once
// A device to draw with, chosen among those that there are.

#include <foredraw/gpu/choice.h>
#include <foredraw/gpu/instance.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace foredraw::gpu {

/// One device with one queue. Used by one thread at a time.
class Device {
 public:
  /// Throws std::runtime_error with what why_no_device() says.
  explicit Device(const DeviceChoice& choice = {});

  VkDevice get() const { return device_.get(); }
  const std::string& name() const { return name_; }  ///< "llvmpipe (LLVM 15.0.6, 256 bits)"
  bool is_processor() const { return properties_.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU; }
  const VkPhysicalDeviceLimits& limits() const { return properties_.limits; }
  VkFormat depth_format() const { return depth_format_; }           ///< D32_SFLOAT; X8_D24_UNORM where there is no such
  std::uint64_t timestamp_mask() const { return timestamp_mask_; }  ///< the bits of its clock; 0: it has none
  bool counts_vertices() const { return counts_vertices_; }
  bool draws_many_indirectly() const { return draws_many_indirectly_; }  ///< also with first instances other than 0
  std::uint32_t queue_family() const { return queue_family_; }

  /// The number of a memory type among `allowed` that has all of `wanted`, and `better` too if there is one.
  std::uint32_t memory_type(std::uint32_t allowed, VkMemoryPropertyFlags wanted,
                            VkMemoryPropertyFlags better = 0) const;

  /// Records commands, hands them in, and waits until they are done.
  void run(const std::function<void(VkCommandBuffer)>& record);

 private:
  struct DestroyDevice {
    using pointer = VkDevice;
    void operator()(VkDevice device) const { vkDestroyDevice(device, nullptr); }
  };

  // In this sequence they are made, and in the other destroyed.
  Instance instance_;
  std::unique_ptr<VkDevice, DestroyDevice> device_;
  OwnedCommandPool commands_;
  VkCommandBuffer buffer_ = VK_NULL_HANDLE;
  OwnedFence done_;
  VkQueue queue_ = VK_NULL_HANDLE;
  VkPhysicalDeviceProperties properties_{};
  VkPhysicalDeviceMemoryProperties memory_{};
  VkFormat depth_format_ = VK_FORMAT_UNDEFINED;
  std::uint64_t timestamp_mask_ = 0;
  std::uint32_t queue_family_ = 0;
  bool counts_vertices_ = false;
  bool draws_many_indirectly_ = false;
  std::string name_;
};

}  // namespace foredraw::gpu

#pragma once
// A device to draw with, chosen among those that there are.

#include <foredraw/gpu/candidate.h>
#include <foredraw/gpu/choice.h>

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
  bool is_processor() const { return candidate_.properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU; }
  const VkPhysicalDeviceLimits& limits() const { return candidate_.properties.limits; }
  VkFormat depth_format() const { return candidate_.depth_format; }  ///< D32_SFLOAT; X8_D24_UNORM where it is missing
  /// The bits of its clock; 0: it has none.
  std::uint64_t timestamp_mask() const {
    return candidate_.timestamp_bits == 0 ? 0 : ~std::uint64_t{0} >> (64 - candidate_.timestamp_bits);
  }
  bool counts_vertices() const { return candidate_.features.pipelineStatisticsQuery == VK_TRUE; }
  /// Also with first instances other than 0.
  bool draws_many_indirectly() const { return candidate_.features.multiDrawIndirect == VK_TRUE; }
  bool tessellates() const { return candidate_.features.tessellationShader == VK_TRUE; }
  bool captures() const { return candidate_.has_transform_feedback; }  ///< what shaders put out
  std::uint32_t queue_family() const { return candidate_.queue_family; }

  /// Memory of a type that has all of `wanted`, and `better` too if there is one.
  OwnedMemory allocated(const VkMemoryRequirements& wants, VkMemoryPropertyFlags wanted,
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
  Candidate candidate_;
  std::string name_;
  std::unique_ptr<VkDevice, DestroyDevice> device_;
  OwnedCommandPool commands_;
  OwnedFence done_;
  VkCommandBuffer buffer_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  VkPhysicalDeviceMemoryProperties memory_{};
};

}  // namespace foredraw::gpu

#pragma once
// Which buffers shaders read and write.

#include <foredraw/gpu/device.h>

#include <cstdint>
#include <span>

namespace foredraw::gpu {

/// That of sets of `buffers` storage buffers, buffer i at binding i, for the shaders of `stages`.
OwnedSetLayout storage_layout(const Device& device, std::uint32_t buffers, VkShaderStageFlags stages);

/// Descriptor sets of one such layout. Device and layout have to live longer.
class StorageSets {
 public:
  /// `most`: how many sets there may be at most; none is fine.
  StorageSets(const Device& device, VkDescriptorSetLayout layout, std::uint32_t buffers, std::size_t most);

  /// One more set, which lives as long as this.
  VkDescriptorSet add();
  /// Puts the buffers into the set, each as a whole: not while commands that use it wait.
  void write(VkDescriptorSet set, std::span<const VkBuffer> buffers) const;

 private:
  VkDevice device_;
  VkDescriptorSetLayout layout_;
  OwnedDescriptorPool pool_;
};

}  // namespace foredraw::gpu

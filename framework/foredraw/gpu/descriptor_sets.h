#pragma once
#include <foredraw/gpu/device.h>

#include <cstdint>

namespace foredraw::gpu {

/// That of sets of `count` descriptors of one type, descriptor i at binding i, for the shaders of `stages`.
OwnedSetLayout set_layout(const Device& device, VkDescriptorType type, std::uint32_t count, VkShaderStageFlags stages);

/// Descriptor sets of one such layout. Device and layout have to live longer.
class DescriptorSets {
 public:
  /// `most`: how many sets there may be at most; none is fine.
  DescriptorSets(const Device& device, VkDescriptorSetLayout layout, VkDescriptorType type, std::uint32_t count,
                 std::size_t most);

  /// One more set, which lives as long as this.
  VkDescriptorSet add();

 protected:
  VkDevice device() const { return device_; }

 private:
  VkDevice device_;
  VkDescriptorSetLayout layout_;
  OwnedDescriptorPool pool_;
};

}  // namespace foredraw::gpu

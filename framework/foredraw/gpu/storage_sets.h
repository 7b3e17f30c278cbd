#pragma once
// Which buffers shaders read and write.

#include <foredraw/gpu/descriptor_sets.h>

#include <span>

namespace foredraw::gpu {

/// That of sets of `buffers` storage buffers, buffer i at binding i, for the shaders of `stages`.
inline OwnedSetLayout storage_layout(const Device& device, std::uint32_t buffers, VkShaderStageFlags stages) {
  return set_layout(device, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, buffers, stages);
}

/// Descriptor sets of one such layout. Device and layout have to live longer.
class StorageSets : public DescriptorSets {
 public:
  /// `most`: how many sets there may be at most; none is fine.
  StorageSets(const Device& device, VkDescriptorSetLayout layout, std::uint32_t buffers, std::size_t most)
      : DescriptorSets(device, layout, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, buffers, most) {}

  /// Puts the buffers into the set, each as a whole: not while commands that use it wait.
  void write(VkDescriptorSet set, std::span<const VkBuffer> buffers) const;
};

}  // namespace foredraw::gpu

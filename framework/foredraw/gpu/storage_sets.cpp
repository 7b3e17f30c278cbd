#include <foredraw/gpu/storage_sets.h>

#include <vector>

namespace foredraw::gpu {

void StorageSets::write(VkDescriptorSet set, std::span<const VkBuffer> buffers) const {
  std::vector<VkDescriptorBufferInfo> wholes;
  for (const VkBuffer buffer : buffers) wholes.push_back({buffer, 0, VK_WHOLE_SIZE});
  // What is more than one binding holds goes to the next ones.
  const VkWriteDescriptorSet write{.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                   .dstSet = set,
                                   .descriptorCount = static_cast<std::uint32_t>(wholes.size()),
                                   .descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                   .pBufferInfo = wholes.data()};
  vkUpdateDescriptorSets(device(), 1, &write, 0, nullptr);
}

}  // namespace foredraw::gpu

#include <foredraw/gpu/storage_sets.h>

#include <algorithm>
#include <vector>

namespace foredraw::gpu {

OwnedSetLayout storage_layout(const Device& device, std::uint32_t buffers, VkShaderStageFlags stages) {
  std::vector<VkDescriptorSetLayoutBinding> bindings;
  for (std::uint32_t i = 0; i < buffers; ++i) {
    bindings.push_back({i, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, stages, nullptr});
  }
  const VkDescriptorSetLayoutCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO, nullptr, 0, buffers,
                                             bindings.data()};
  return OwnedSetLayout(device.get(), info, "vkCreateDescriptorSetLayout");
}

StorageSets::StorageSets(const Device& device, VkDescriptorSetLayout layout, std::uint32_t buffers, std::size_t most)
    : device_(device.get()), layout_(layout) {
  const auto sets = static_cast<std::uint32_t>(std::max<std::size_t>(1, most));
  const VkDescriptorPoolSize all{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, buffers * sets};
  const VkDescriptorPoolCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO, nullptr, 0, sets, 1, &all};
  pool_ = OwnedDescriptorPool(device_, info, "vkCreateDescriptorPool");
}

VkDescriptorSet StorageSets::add() {
  const VkDescriptorSetAllocateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO, nullptr, pool_.get(), 1,
                                         &layout_};
  VkDescriptorSet set = VK_NULL_HANDLE;
  check(vkAllocateDescriptorSets(device_, &info, &set), "vkAllocateDescriptorSets");
  return set;
}

void StorageSets::write(VkDescriptorSet set, std::span<const VkBuffer> buffers) const {
  std::vector<VkDescriptorBufferInfo> wholes;
  for (const VkBuffer buffer : buffers) wholes.push_back({buffer, 0, VK_WHOLE_SIZE});
  // What is more than one binding holds goes to the next ones.
  const VkWriteDescriptorSet write{.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                   .dstSet = set,
                                   .descriptorCount = static_cast<std::uint32_t>(wholes.size()),
                                   .descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                   .pBufferInfo = wholes.data()};
  vkUpdateDescriptorSets(device_, 1, &write, 0, nullptr);
}

}  // namespace foredraw::gpu

#include <foredraw/gpu/descriptor_sets.h>

#include <algorithm>
#include <vector>

namespace foredraw::gpu {

OwnedSetLayout set_layout(const Device& device, VkDescriptorType type, std::uint32_t count, VkShaderStageFlags stages) {
  std::vector<VkDescriptorSetLayoutBinding> bindings;
  for (std::uint32_t i = 0; i < count; ++i) bindings.push_back({i, type, 1, stages, nullptr});
  const VkDescriptorSetLayoutCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO, nullptr, 0, count,
                                             bindings.data()};
  return OwnedSetLayout(device.get(), info, "vkCreateDescriptorSetLayout");
}

DescriptorSets::DescriptorSets(const Device& device, VkDescriptorSetLayout layout, VkDescriptorType type,
                               std::uint32_t count, std::size_t most)
    : device_(device.get()), layout_(layout) {
  const auto sets = static_cast<std::uint32_t>(std::max<std::size_t>(1, most));
  const VkDescriptorPoolSize all{type, count * sets};
  const VkDescriptorPoolCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO, nullptr, 0, sets, 1, &all};
  pool_ = OwnedDescriptorPool(device_, info, "vkCreateDescriptorPool");
}

VkDescriptorSet DescriptorSets::add() {
  const VkDescriptorSetAllocateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO, nullptr, pool_.get(), 1,
                                         &layout_};
  VkDescriptorSet set = VK_NULL_HANDLE;
  check(vkAllocateDescriptorSets(device_, &info, &set), "vkAllocateDescriptorSets");
  return set;
}

}  // namespace foredraw::gpu

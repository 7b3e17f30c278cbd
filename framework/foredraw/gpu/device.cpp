#include <foredraw/gpu/device.h>

#include <foredraw/gpu/candidate.h>

#include <stdexcept>

namespace foredraw::gpu {

namespace {

VkDevice make_device(const Candidate& candidate, bool counts_vertices, bool draws_many_indirectly) {
  const float priority = 1;
  VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
  queue.queueFamilyIndex = candidate.queue_family;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  VkPhysicalDeviceFeatures features{};
  features.occlusionQueryPrecise = VK_TRUE;
  features.fragmentStoresAndAtomics = VK_TRUE;
  features.fullDrawIndexUint32 = VK_TRUE;
  features.pipelineStatisticsQuery = counts_vertices ? VK_TRUE : VK_FALSE;
  features.multiDrawIndirect = draws_many_indirectly ? VK_TRUE : VK_FALSE;
  features.drawIndirectFirstInstance = features.multiDrawIndirect;
  VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  info.pEnabledFeatures = &features;
  VkDevice device = VK_NULL_HANDLE;
  check(vkCreateDevice(candidate.device, &info, nullptr, &device), "vkCreateDevice");
  return device;
}

VkCommandBufferAllocateInfo one_buffer(VkCommandPool pool) {
  VkCommandBufferAllocateInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
  info.commandPool = pool;
  info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  info.commandBufferCount = 1;
  return info;
}

}  // namespace

std::optional<std::string> why_no_device(const DeviceChoice& choice) {
  try {
    const Instance instance(choice.complaints);
    static_cast<void>(chosen_device(instance.get(), choice.device));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return std::nullopt;
}

Device::Device(const DeviceChoice& choice) : instance_(choice.complaints) {
  const Candidate candidate = chosen_device(instance_.get(), choice.device);
  VkPhysicalDeviceFeatures features;
  vkGetPhysicalDeviceFeatures(candidate.device, &features);
  vkGetPhysicalDeviceProperties(candidate.device, &properties_);
  vkGetPhysicalDeviceMemoryProperties(candidate.device, &memory_);
  name_ = properties_.deviceName;
  depth_format_ = candidate.depth_format;
  timestamp_mask_ = candidate.timestamp_bits == 0 ? 0 : ~std::uint64_t{0} >> (64 - candidate.timestamp_bits);
  counts_vertices_ = features.pipelineStatisticsQuery == VK_TRUE;
  draws_many_indirectly_ = features.multiDrawIndirect == VK_TRUE && features.drawIndirectFirstInstance == VK_TRUE;
  queue_family_ = candidate.queue_family;
  device_.reset(make_device(candidate, counts_vertices_, draws_many_indirectly_));
  vkGetDeviceQueue(get(), candidate.queue_family, 0, &queue_);

  VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
  pool.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
  pool.queueFamilyIndex = candidate.queue_family;
  commands_ = OwnedCommandPool(get(), pool, "vkCreateCommandPool");
  const VkCommandBufferAllocateInfo one = one_buffer(commands_.get());
  check(vkAllocateCommandBuffers(get(), &one, &buffer_), "vkAllocateCommandBuffers");
  done_ = OwnedFence(get(), VkFenceCreateInfo{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO}, "vkCreateFence");
}

std::uint32_t Device::memory_type(std::uint32_t allowed, VkMemoryPropertyFlags wanted,
                                  VkMemoryPropertyFlags better) const {
  for (const VkMemoryPropertyFlags flags : {wanted | better, wanted}) {
    for (std::uint32_t i = 0; i < memory_.memoryTypeCount; ++i) {
      if ((allowed >> i & 1) != 0 && (memory_.memoryTypes[i].propertyFlags & flags) == flags) return i;
    }
  }
  throw std::runtime_error(name_ + " has no memory of the kind that is needed; choose another device");
}

void Device::run(const std::function<void(VkCommandBuffer)>& record) {
  check(vkResetCommandPool(get(), commands_.get(), 0), "vkResetCommandPool");
  VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  check(vkBeginCommandBuffer(buffer_, &begin), "vkBeginCommandBuffer");
  record(buffer_);
  check(vkEndCommandBuffer(buffer_), "vkEndCommandBuffer");

  VkSubmitInfo submit{VK_STRUCTURE_TYPE_SUBMIT_INFO};
  submit.commandBufferCount = 1;
  submit.pCommandBuffers = &buffer_;
  const VkFence done = done_.get();
  check(vkQueueSubmit(queue_, 1, &submit, done), "vkQueueSubmit");
  check(vkWaitForFences(get(), 1, &done, VK_TRUE, ~std::uint64_t{0}), "vkWaitForFences");
  check(vkResetFences(get(), 1, &done), "vkResetFences");
}

}  // namespace foredraw::gpu

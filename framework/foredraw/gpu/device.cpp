#include <foredraw/gpu/device.h>

#include <stdexcept>

namespace foredraw::gpu {

namespace {

VkDevice make_device(const Candidate& candidate) {
  const float priority = 1;
  const VkDeviceQueueCreateInfo queue{.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
                                      .queueFamilyIndex = candidate.queue_family,
                                      .queueCount = 1,
                                      .pQueuePriorities = &priority};
  VkDeviceCreateInfo info{.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                          .queueCreateInfoCount = 1,
                          .pQueueCreateInfos = &queue,
                          .pEnabledFeatures = &candidate.features};
  const VkPhysicalDeviceTransformFeedbackFeaturesEXT feedback{
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_TRANSFORM_FEEDBACK_FEATURES_EXT, .transformFeedback = VK_TRUE};
  const char* extension = VK_EXT_TRANSFORM_FEEDBACK_EXTENSION_NAME;
  if (candidate.has_transform_feedback) {
    info.pNext = &feedback;
    info.enabledExtensionCount = 1;
    info.ppEnabledExtensionNames = &extension;
  }
  VkDevice device = VK_NULL_HANDLE;
  check(vkCreateDevice(candidate.device, &info, nullptr, &device), "vkCreateDevice");
  return device;
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

std::string device_text(const DeviceChoice& choice) {
  try {
    const Instance instance(choice.complaints);
    const VkPhysicalDeviceProperties properties = chosen_device(instance.get(), choice.device).properties;
    return std::string(properties.deviceName) + ", driver " + std::to_string(properties.driverVersion);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

Device::Device(const DeviceChoice& choice)
    : instance_(choice.complaints),
      candidate_(chosen_device(instance_.get(), choice.device)),
      name_(candidate_.properties.deviceName),
      device_(make_device(candidate_)),
      commands_(get(),
                VkCommandPoolCreateInfo{.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                        .flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT,
                                        .queueFamilyIndex = queue_family()},
                "vkCreateCommandPool"),
      done_(get(), VkFenceCreateInfo{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO}, "vkCreateFence") {
  vkGetPhysicalDeviceMemoryProperties(candidate_.device, &memory_);
  vkGetDeviceQueue(get(), queue_family(), 0, &queue_);
  const VkCommandBufferAllocateInfo one{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                        .commandPool = commands_.get(),
                                        .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                        .commandBufferCount = 1};
  check(vkAllocateCommandBuffers(get(), &one, &buffer_), "vkAllocateCommandBuffers");
}

OwnedMemory Device::allocated(const VkMemoryRequirements& wants, VkMemoryPropertyFlags wanted,
                              VkMemoryPropertyFlags better) const {
  for (const VkMemoryPropertyFlags flags : {wanted | better, wanted}) {
    for (std::uint32_t i = 0; i < memory_.memoryTypeCount; ++i) {
      if ((wants.memoryTypeBits >> i & 1) == 0 || (memory_.memoryTypes[i].propertyFlags & flags) != flags) continue;
      const VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, nullptr, wants.size, i};
      return OwnedMemory(get(), info, "vkAllocateMemory");
    }
  }
  throw std::runtime_error(name_ + " has no suitable type of memory; choose another device");
}

void Device::run(const std::function<void(VkCommandBuffer)>& record) {
  check(vkResetCommandPool(get(), commands_.get(), 0), "vkResetCommandPool");
  const VkCommandBufferBeginInfo begin{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                       .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
  check(vkBeginCommandBuffer(buffer_, &begin), "vkBeginCommandBuffer");
  record(buffer_);
  check(vkEndCommandBuffer(buffer_), "vkEndCommandBuffer");

  const VkSubmitInfo submit{
      .sType = VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1, .pCommandBuffers = &buffer_};
  const VkFence done = done_.get();
  check(vkQueueSubmit(queue_, 1, &submit, done), "vkQueueSubmit");
  check(vkWaitForFences(get(), 1, &done, VK_TRUE, ~std::uint64_t{0}), "vkWaitForFences");
  check(vkResetFences(get(), 1, &done), "vkResetFences");
}

}  // namespace foredraw::gpu

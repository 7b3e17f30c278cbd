#pragma once
// What Vulkan lends is given back.

#include <vulkan/vulkan.h>

#include <utility>

namespace foredraw::gpu {

/// Throws std::runtime_error where the call failed: what was called, what came back, and what may help.
void check(VkResult result, const char* call);

/// A handle that a device made and that is destroyed in the end. The device has to live longer.
template <class T, auto create, auto destroy>
class Owned {
 public:
  Owned() = default;
  template <class Info>
  Owned(VkDevice device, const Info& info, const char* call) : device_(device) {
    check(create(device, &info, nullptr, &handle_), call);
  }
  Owned(Owned&& other) noexcept { swap(other); }
  Owned& operator=(Owned&& other) noexcept {
    swap(other);
    return *this;
  }
  ~Owned() {
    if (handle_ != VK_NULL_HANDLE) destroy(device_, handle_, nullptr);
  }

  T get() const { return handle_; }

 private:
  void swap(Owned& other) {
    std::swap(device_, other.device_);
    std::swap(handle_, other.handle_);
  }

  VkDevice device_ = VK_NULL_HANDLE;
  T handle_ = VK_NULL_HANDLE;
};

/// vkCreateGraphicsPipelines for one, in the shape of the others.
VkResult create_pipeline(VkDevice, const VkGraphicsPipelineCreateInfo*, const VkAllocationCallbacks*, VkPipeline*);

using OwnedBuffer = Owned<VkBuffer, vkCreateBuffer, vkDestroyBuffer>;
using OwnedCommandPool = Owned<VkCommandPool, vkCreateCommandPool, vkDestroyCommandPool>;
using OwnedDescriptorPool = Owned<VkDescriptorPool, vkCreateDescriptorPool, vkDestroyDescriptorPool>;
using OwnedFence = Owned<VkFence, vkCreateFence, vkDestroyFence>;
using OwnedFramebuffer = Owned<VkFramebuffer, vkCreateFramebuffer, vkDestroyFramebuffer>;
using OwnedImage = Owned<VkImage, vkCreateImage, vkDestroyImage>;
using OwnedImageView = Owned<VkImageView, vkCreateImageView, vkDestroyImageView>;
using OwnedMemory = Owned<VkDeviceMemory, vkAllocateMemory, vkFreeMemory>;
using OwnedPipeline = Owned<VkPipeline, create_pipeline, vkDestroyPipeline>;
using OwnedPipelineLayout = Owned<VkPipelineLayout, vkCreatePipelineLayout, vkDestroyPipelineLayout>;
using OwnedQueryPool = Owned<VkQueryPool, vkCreateQueryPool, vkDestroyQueryPool>;
using OwnedRenderPass = Owned<VkRenderPass, vkCreateRenderPass, vkDestroyRenderPass>;
using OwnedSampler = Owned<VkSampler, vkCreateSampler, vkDestroySampler>;
using OwnedSetLayout = Owned<VkDescriptorSetLayout, vkCreateDescriptorSetLayout, vkDestroyDescriptorSetLayout>;
using OwnedShader = Owned<VkShaderModule, vkCreateShaderModule, vkDestroyShaderModule>;

}  // namespace foredraw::gpu

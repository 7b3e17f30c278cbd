#pragma once
#include "vulkan_device.h"

namespace foredraw {

inline constexpr VkFormat owner_format = VK_FORMAT_R32_UINT;

/// Clears an owner attachment and a depth attachment, is drawn into, and leaves the owners ready to be copied.
OwnedRenderPass make_render_pass(const VulkanDevice& device);

}  // namespace foredraw

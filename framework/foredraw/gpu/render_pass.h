#pragma once
#include <foredraw/gpu/device.h>

namespace foredraw::gpu {

inline constexpr VkFormat pixel_format = VK_FORMAT_R32_UINT;

/// Clears an attachment of pixels and one of depths, is drawn into, and leaves the pixels ready to be copied.
OwnedRenderPass make_render_pass(const Device& device);

}  // namespace foredraw::gpu

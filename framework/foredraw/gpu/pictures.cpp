#include <foredraw/gpu/pictures.h>

#include <foredraw/gpu/render_pass.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace foredraw::gpu {

namespace {

/// In all pictures, unless one alone has more. 12 bytes a pixel are taken.
constexpr std::uint64_t most_pixels = 1u << 22;

std::array<VkClearValue, 2> emptiness() {
  std::array<VkClearValue, 2> values{};
  values[0].color.uint32[0] = empty_pixel;
  values[1].depthStencil.depth = 1;
  return values;
}

}  // namespace

Pictures::Pictures(const Device& device, VkRenderPass render_pass, int size)
    : render_pass_(render_pass), size_(static_cast<std::uint32_t>(size)) {
  const VkPhysicalDeviceLimits& limits = device.limits();
  const std::uint32_t most = std::min({limits.maxImageDimension2D, limits.maxFramebufferWidth,
                                       limits.maxFramebufferHeight, limits.maxViewportDimensions[0]});
  if (size_ > most) {
    throw std::runtime_error(device.name() + " draws pictures of " + std::to_string(most) + " pixels at most, not " +
                             std::to_string(size_) + "; ask for a smaller size");
  }
  const std::uint64_t pixels = std::uint64_t{size_} * size_;
  count_ = static_cast<std::uint32_t>(std::clamp<std::uint64_t>(most_pixels / pixels, 1, limits.maxImageArrayLayers));
  pixel_image_ = LayeredImage(device, size_, count_, pixel_format,
                              VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT);
  depth_image_ =
      LayeredImage(device, size_, count_, device.depth_format(), VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT);
  pixels_ = VisibleBuffer(device, count_ * pixels * sizeof(std::uint32_t), VK_BUFFER_USAGE_TRANSFER_DST_BIT);
  for (std::uint32_t layer = 0; layer < count_; ++layer) {
    OwnedImageView colour = pixel_image_.view(device, layer, VK_IMAGE_ASPECT_COLOR_BIT);
    OwnedImageView depth = depth_image_.view(device, layer, VK_IMAGE_ASPECT_DEPTH_BIT);
    const std::array attachments = {colour.get(), depth.get()};
    VkFramebufferCreateInfo info{VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO};
    info.renderPass = render_pass;
    info.attachmentCount = attachments.size();
    info.pAttachments = attachments.data();
    info.width = size_;
    info.height = size_;
    info.layers = 1;
    framebuffers_.emplace_back(device.get(), info, "vkCreateFramebuffer");
    views_.push_back(std::move(colour));
    views_.push_back(std::move(depth));
  }
}

void Pictures::begin(VkCommandBuffer commands, std::uint32_t picture) const {
  const std::array values = emptiness();
  VkRenderPassBeginInfo info{VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO};
  info.renderPass = render_pass_;
  info.framebuffer = framebuffers_[picture].get();
  info.renderArea.extent = {size_, size_};
  info.clearValueCount = values.size();
  info.pClearValues = values.data();
  vkCmdBeginRenderPass(commands, &info, VK_SUBPASS_CONTENTS_INLINE);
  const auto edge = static_cast<float>(size_);
  const VkViewport viewport{0, 0, edge, edge, 0, 1};
  vkCmdSetViewport(commands, 0, 1, &viewport);
  vkCmdSetScissor(commands, 0, 1, &info.renderArea);
}

void Pictures::clear(VkCommandBuffer commands) const {
  const std::array values = emptiness();
  const std::array attachments = {VkClearAttachment{VK_IMAGE_ASPECT_COLOR_BIT, 0, values[0]},
                                  VkClearAttachment{VK_IMAGE_ASPECT_DEPTH_BIT, 0, values[1]}};
  const VkClearRect whole{{{0, 0}, {size_, size_}}, 0, 1};
  vkCmdClearAttachments(commands, attachments.size(), attachments.data(), 1, &whole);
}

void Pictures::copy_out(VkCommandBuffer commands, std::uint32_t pictures) const {
  VkBufferImageCopy region{};
  region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, pictures};
  region.imageExtent = {size_, size_, 1};
  vkCmdCopyImageToBuffer(commands, pixel_image_.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, pixels_.get(), 1, &region);
  let_see(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_HOST_BIT,
          VK_ACCESS_HOST_READ_BIT);
}

std::span<const std::uint32_t> Pictures::pixels(std::uint32_t picture) const {
  const std::size_t count = std::size_t{size_} * size_;
  return pixels_.as<const std::uint32_t>().subspan(picture * count, count);
}

}  // namespace foredraw::gpu

#include <foredraw/gpu/pictures.h>

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

OwnedRenderPass make_render_pass(const Device& device, VkFormat pixel_format) {
  const std::array attachments = {
      VkAttachmentDescription{.format = pixel_format,
                              .samples = VK_SAMPLE_COUNT_1_BIT,
                              .loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR,
                              .storeOp = VK_ATTACHMENT_STORE_OP_STORE,
                              .finalLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL},
      VkAttachmentDescription{.format = device.depth_format(),
                              .samples = VK_SAMPLE_COUNT_1_BIT,
                              .loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR,
                              .storeOp = VK_ATTACHMENT_STORE_OP_DONT_CARE,
                              .finalLayout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL}};
  const VkAttachmentReference pixels{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
  const VkAttachmentReference depths{1, VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL};
  const VkSubpassDescription subpass{.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS,
                                     .colorAttachmentCount = 1,
                                     .pColorAttachments = &pixels,
                                     .pDepthStencilAttachment = &depths};

  // Passes that draw into the same layer one after the other, and the copy that follows the last of them.
  constexpr VkPipelineStageFlags drawing = VK_PIPELINE_STAGE_EARLY_FRAGMENT_TESTS_BIT |
                                           VK_PIPELINE_STAGE_LATE_FRAGMENT_TESTS_BIT |
                                           VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
  constexpr VkAccessFlags drawn = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT | VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT;
  constexpr VkAccessFlags tested = drawn | VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_READ_BIT;
  constexpr std::array dependencies = {
      VkSubpassDependency{VK_SUBPASS_EXTERNAL, 0, drawing, drawing, drawn, tested, 0},
      VkSubpassDependency{0, VK_SUBPASS_EXTERNAL, drawing, VK_PIPELINE_STAGE_TRANSFER_BIT, drawn,
                          VK_ACCESS_TRANSFER_READ_BIT, 0}};
  const VkRenderPassCreateInfo info{.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO,
                                    .attachmentCount = attachments.size(),
                                    .pAttachments = attachments.data(),
                                    .subpassCount = 1,
                                    .pSubpasses = &subpass,
                                    .dependencyCount = dependencies.size(),
                                    .pDependencies = dependencies.data()};
  return OwnedRenderPass(device.get(), info, "vkCreateRenderPass");
}

std::uint32_t longest_edge(const Device& device) {
  const VkPhysicalDeviceLimits& limits = device.limits();
  return std::min({limits.maxImageDimension2D, limits.maxFramebufferWidth, limits.maxFramebufferHeight,
                   limits.maxViewportDimensions[0], limits.maxViewportDimensions[1]});
}

Pictures::Pictures(const Device& device, VkRenderPass render_pass, int size)
    : render_pass_(render_pass), size_(static_cast<std::uint32_t>(size)) {
  const std::uint32_t most = longest_edge(device);
  if (size_ > most) {
    throw std::runtime_error(device.name() + " draws pictures of at most " + std::to_string(most) + " pixels, not " +
                             std::to_string(size_) + "; ask for a smaller size");
  }
  const std::uint64_t pixels = std::uint64_t{size_} * size_;
  count_ = static_cast<std::uint32_t>(
      std::clamp<std::uint64_t>(most_pixels / pixels, 1, device.limits().maxImageArrayLayers));
  const ImageShape shape{size_, size_, count_};
  pixel_image_ =
      LayeredImage(device, shape, number_format, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT);
  depth_image_ = LayeredImage(device, shape, device.depth_format(), VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT);
  pixels_ = VisibleBuffer(device, count_ * pixels * sizeof(std::uint32_t), VK_BUFFER_USAGE_TRANSFER_DST_BIT);
  for (std::uint32_t layer = 0; layer < count_; ++layer) {
    OwnedImageView colour = pixel_image_.view(device, layer, VK_IMAGE_ASPECT_COLOR_BIT);
    OwnedImageView depth = depth_image_.view(device, layer, VK_IMAGE_ASPECT_DEPTH_BIT);
    const std::array attachments = {colour.get(), depth.get()};
    const VkFramebufferCreateInfo info{.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO,
                                       .renderPass = render_pass,
                                       .attachmentCount = attachments.size(),
                                       .pAttachments = attachments.data(),
                                       .width = size_,
                                       .height = size_,
                                       .layers = 1};
    framebuffers_.emplace_back(device.get(), info, "vkCreateFramebuffer");
    views_.push_back(std::move(colour));
    views_.push_back(std::move(depth));
  }
}

void Pictures::begin(VkCommandBuffer commands, std::uint32_t picture) const {
  const std::array values = emptiness();
  const VkRect2D whole{{0, 0}, {size_, size_}};
  const VkRenderPassBeginInfo info{.sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO,
                                   .renderPass = render_pass_,
                                   .framebuffer = framebuffers_[picture].get(),
                                   .renderArea = whole,
                                   .clearValueCount = values.size(),
                                   .pClearValues = values.data()};
  vkCmdBeginRenderPass(commands, &info, VK_SUBPASS_CONTENTS_INLINE);
  const auto edge = static_cast<float>(size_);
  const VkViewport viewport{0, 0, edge, edge, 0, 1};
  vkCmdSetViewport(commands, 0, 1, &viewport);
  vkCmdSetScissor(commands, 0, 1, &whole);
}

void Pictures::clear(VkCommandBuffer commands) const {
  const std::array values = emptiness();
  const std::array attachments = {VkClearAttachment{VK_IMAGE_ASPECT_COLOR_BIT, 0, values[0]},
                                  VkClearAttachment{VK_IMAGE_ASPECT_DEPTH_BIT, 0, values[1]}};
  const VkClearRect whole{{{0, 0}, {size_, size_}}, 0, 1};
  vkCmdClearAttachments(commands, attachments.size(), attachments.data(), 1, &whole);
}

void Pictures::copy_out(VkCommandBuffer commands, std::uint32_t pictures) const {
  const VkBufferImageCopy region{0, 0, 0, {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, pictures}, {}, {size_, size_, 1}};
  vkCmdCopyImageToBuffer(commands, pixel_image_.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, pixels_.get(), 1, &region);
  let_see(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_HOST_BIT,
          VK_ACCESS_HOST_READ_BIT);
}

std::span<const std::uint32_t> Pictures::pixels(std::uint32_t picture) const {
  const std::size_t count = std::size_t{size_} * size_;
  return pixels_.as<const std::uint32_t>().subspan(picture * count, count);
}

}  // namespace foredraw::gpu

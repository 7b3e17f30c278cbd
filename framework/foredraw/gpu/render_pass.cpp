#include <foredraw/gpu/render_pass.h>

#include <array>

namespace foredraw::gpu {

OwnedRenderPass make_render_pass(const Device& device) {
  VkAttachmentDescription pixels{};
  pixels.format = pixel_format;
  pixels.samples = VK_SAMPLE_COUNT_1_BIT;
  pixels.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
  pixels.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  pixels.finalLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
  VkAttachmentDescription depth{};
  depth.format = device.depth_format();
  depth.samples = VK_SAMPLE_COUNT_1_BIT;
  depth.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
  depth.storeOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
  depth.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
  depth.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
  depth.finalLayout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL;
  const std::array attachments = {pixels, depth};

  const VkAttachmentReference pixels_at{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
  const VkAttachmentReference depth_at{1, VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL};
  VkSubpassDescription subpass{};
  subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
  subpass.colorAttachmentCount = 1;
  subpass.pColorAttachments = &pixels_at;
  subpass.pDepthStencilAttachment = &depth_at;

  // Passes that draw into the same layer one after the other, and the copy that follows the last of them.
  constexpr VkPipelineStageFlags drawing = VK_PIPELINE_STAGE_EARLY_FRAGMENT_TESTS_BIT |
                                           VK_PIPELINE_STAGE_LATE_FRAGMENT_TESTS_BIT |
                                           VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
  constexpr VkAccessFlags drawn = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT | VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT;
  VkSubpassDependency before{};
  before.srcSubpass = VK_SUBPASS_EXTERNAL;
  before.srcStageMask = drawing;
  before.dstStageMask = drawing;
  before.srcAccessMask = drawn;
  before.dstAccessMask = drawn | VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_READ_BIT;
  VkSubpassDependency behind{};
  behind.dstSubpass = VK_SUBPASS_EXTERNAL;
  behind.srcStageMask = drawing;
  behind.dstStageMask = VK_PIPELINE_STAGE_TRANSFER_BIT;
  behind.srcAccessMask = drawn;
  behind.dstAccessMask = VK_ACCESS_TRANSFER_READ_BIT;
  const std::array dependencies = {before, behind};

  VkRenderPassCreateInfo info{VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO};
  info.attachmentCount = attachments.size();
  info.pAttachments = attachments.data();
  info.subpassCount = 1;
  info.pSubpasses = &subpass;
  info.dependencyCount = dependencies.size();
  info.pDependencies = dependencies.data();
  return OwnedRenderPass(device.get(), info, "vkCreateRenderPass");
}

}  // namespace foredraw::gpu

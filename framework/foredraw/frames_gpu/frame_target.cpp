#include <foredraw/frames_gpu/private/frame_target.h>

#include <foredraw/frames/surface_shading.h>
#include <foredraw/gpu/pictures.h>

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace foredraw {

namespace {

constexpr VkFormat colour_format = VK_FORMAT_R16G16B16A16_SFLOAT;  // every device draws into it and blends in it

using HalfTexel = std::array<std::uint16_t, 4>;

glm::vec3 colour_of(const HalfTexel& texel) {
  return {glm::unpackHalf1x16(texel[0]), glm::unpackHalf1x16(texel[1]), glm::unpackHalf1x16(texel[2])};
}

}  // namespace

FrameTarget::FrameTarget(const gpu::Device& device, FrameSize size, int samples)
    : size_(size), samples_(static_cast<std::uint32_t>(std::clamp(samples, 1, 16))) {
  const std::int64_t width = std::int64_t{size.width} * samples_, height = std::int64_t{size.height} * samples_;
  const std::uint32_t most = gpu::longest_edge(device);
  if (width < 1 || height < 1 || std::max(width, height) > most) {
    throw std::runtime_error(device.name() + " draws pictures of 1 to " + std::to_string(most) + " samples, not " +
                             std::to_string(width) + " x " + std::to_string(height) +
                             "; ask for another size or fewer samples");
  }
  sampled_ = {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
  render_pass_ = gpu::make_render_pass(device, colour_format);
  const gpu::ImageShape shape{sampled_.width, sampled_.height};
  colours_ = gpu::LayeredImage(device, shape, colour_format,
                               VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT);
  depths_ = gpu::LayeredImage(device, shape, device.depth_format(), VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT);
  colour_view_ = colours_.view(device, 0, VK_IMAGE_ASPECT_COLOR_BIT);
  depth_view_ = depths_.view(device, 0, VK_IMAGE_ASPECT_DEPTH_BIT);
  const std::array attachments = {colour_view_.get(), depth_view_.get()};
  const VkFramebufferCreateInfo info{.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO,
                                     .renderPass = render_pass(),
                                     .attachmentCount = attachments.size(),
                                     .pAttachments = attachments.data(),
                                     .width = sampled_.width,
                                     .height = sampled_.height,
                                     .layers = 1};
  framebuffer_ = gpu::OwnedFramebuffer(device.get(), info, "vkCreateFramebuffer");
}

void FrameTarget::begin(VkCommandBuffer commands) const {
  std::array<VkClearValue, 2> emptiness{};
  emptiness[0].color = {{sky_colour.x, sky_colour.y, sky_colour.z, 1}};
  emptiness[1].depthStencil.depth = 0;
  const VkRect2D whole{{0, 0}, sampled_};
  const VkRenderPassBeginInfo info{.sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO,
                                   .renderPass = render_pass(),
                                   .framebuffer = framebuffer_.get(),
                                   .renderArea = whole,
                                   .clearValueCount = emptiness.size(),
                                   .pClearValues = emptiness.data()};
  vkCmdBeginRenderPass(commands, &info, VK_SUBPASS_CONTENTS_INLINE);
  const VkViewport viewport{0, 0, static_cast<float>(sampled_.width), static_cast<float>(sampled_.height), 0, 1};
  vkCmdSetViewport(commands, 0, 1, &viewport);
  vkCmdSetScissor(commands, 0, 1, &whole);
}

FramePicture FrameTarget::picture(gpu::Device& device) const {
  const std::size_t width = sampled_.width, height = sampled_.height;
  const gpu::VisibleBuffer copied(device, width * height * sizeof(HalfTexel), VK_BUFFER_USAGE_TRANSFER_DST_BIT);
  device.run([&](VkCommandBuffer commands) {
    const VkBufferImageCopy all{
        0, 0, 0, {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1}, {}, {sampled_.width, sampled_.height, 1}};
    vkCmdCopyImageToBuffer(commands, colours_.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, copied.get(), 1, &all);
    gpu::let_see(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_HOST_BIT,
                 VK_ACCESS_HOST_READ_BIT);
  });
  const std::span<const HalfTexel> texels = copied.as<const HalfTexel>();
  const auto columns = static_cast<std::size_t>(size_.width);
  FramePicture picture{size_, {}};
  picture.colours.assign(columns * static_cast<std::size_t>(size_.height), glm::vec3(0));
  const float share = 1 / static_cast<float>(samples_ * samples_);
  for (std::size_t y = 0; y < height; ++y) {
    glm::vec3* to = &picture.colours[y / samples_ * columns];
    for (std::size_t x = 0; x < width; ++x) to[x / samples_] += share * colour_of(texels[y * width + x]);
  }
  return picture;
}

}  // namespace foredraw

#include <foredraw/gpu/textures.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace foredraw::gpu {

namespace {

/// Of all mip levels.
void change_layout(VkCommandBuffer commands, VkImage image, VkImageLayout from, VkImageLayout to) {
  const bool is_filled = from != VK_IMAGE_LAYOUT_UNDEFINED;
  const VkImageMemoryBarrier barrier{
      .sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER,
      .srcAccessMask = is_filled ? VkAccessFlags{VK_ACCESS_TRANSFER_WRITE_BIT} : 0,
      .dstAccessMask = is_filled ? VK_ACCESS_SHADER_READ_BIT : VK_ACCESS_TRANSFER_WRITE_BIT,
      .oldLayout = from,
      .newLayout = to,
      .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
      .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
      .image = image,
      .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, VK_REMAINING_MIP_LEVELS, 0, VK_REMAINING_ARRAY_LAYERS}};
  vkCmdPipelineBarrier(commands, is_filled ? VK_PIPELINE_STAGE_TRANSFER_BIT : VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT,
                       is_filled ? VK_PIPELINE_STAGE_ALL_COMMANDS_BIT : VK_PIPELINE_STAGE_TRANSFER_BIT, 0, 0, nullptr,
                       0, nullptr, 1, &barrier);
}

}  // namespace

Texture::Texture(Device& device, std::span<const TextureLevel> levels, VkFormat format) {
  const std::uint32_t most = device.limits().maxImageDimension2D;
  while (levels.size() > 1 && std::max(levels.front().width, levels.front().height) > most) levels = levels.subspan(1);
  if (levels.empty()) throw std::runtime_error("a texture has one mip level at least");
  const ImageShape shape{levels.front().width, levels.front().height, 1, static_cast<std::uint32_t>(levels.size())};
  image_ = LayeredImage(device, shape, format, VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT);
  view_ = image_.view(device, 0, VK_IMAGE_ASPECT_COLOR_BIT);

  std::size_t bytes = 0;
  for (const TextureLevel& level : levels) bytes += level.texels.size();
  const VisibleBuffer staging(device, bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
  std::vector<VkBufferImageCopy> copies;
  std::size_t at = 0;
  for (std::uint32_t mip = 0; mip < levels.size(); ++mip) {
    const TextureLevel& level = levels[mip];
    std::memcpy(staging.as<std::byte>().data() + at, level.texels.data(), level.texels.size());
    copies.push_back({at, 0, 0, {VK_IMAGE_ASPECT_COLOR_BIT, mip, 0, 1}, {}, {level.width, level.height, 1}});
    at += level.texels.size();
  }
  device.run([&](VkCommandBuffer commands) {
    change_layout(commands, image_.get(), VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    vkCmdCopyBufferToImage(commands, staging.get(), image_.get(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                           static_cast<std::uint32_t>(copies.size()), copies.data());
    change_layout(commands, image_.get(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                  VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  });
}

OwnedSampler make_sampler(const Device& device, VkFilter filter, VkSamplerAddressMode u, VkSamplerAddressMode v) {
  const VkSamplerCreateInfo info{.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO,
                                 .magFilter = filter,
                                 .minFilter = filter,
                                 .mipmapMode = VK_SAMPLER_MIPMAP_MODE_NEAREST,
                                 .addressModeU = u,
                                 .addressModeV = v,
                                 .addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                                 .maxLod = VK_LOD_CLAMP_NONE};
  return OwnedSampler(device.get(), info, "vkCreateSampler");
}

void TextureSets::write(VkDescriptorSet set, std::span<const SampledTexture> textures) const {
  std::vector<VkDescriptorImageInfo> all;
  for (const SampledTexture& texture : textures) {
    all.push_back({texture.sampler, texture.view, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL});
  }
  const VkWriteDescriptorSet write{.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                   .dstSet = set,
                                   .descriptorCount = static_cast<std::uint32_t>(all.size()),
                                   .descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                                   .pImageInfo = all.data()};
  vkUpdateDescriptorSets(device(), 1, &write, 0, nullptr);
}

}  // namespace foredraw::gpu

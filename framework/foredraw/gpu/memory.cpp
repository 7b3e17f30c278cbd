#include <foredraw/gpu/memory.h>

#include <algorithm>
#include <cstring>

namespace foredraw::gpu {

void let_see(VkCommandBuffer commands, VkPipelineStageFlags writing, VkAccessFlags written,
             VkPipelineStageFlags reading, VkAccessFlags read) {
  const VkMemoryBarrier barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER, nullptr, written, read};
  vkCmdPipelineBarrier(commands, writing, reading, 0, 1, &barrier, 0, nullptr, 0, nullptr);
}

Buffer::Buffer(const Device& device, VkDeviceSize bytes, VkBufferUsageFlags usage, VkMemoryPropertyFlags wanted,
               VkMemoryPropertyFlags better) {
  VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
  info.size = std::max<VkDeviceSize>(bytes, 16);  // none may be empty
  info.usage = usage;
  buffer_ = OwnedBuffer(device.get(), info, "vkCreateBuffer");
  VkMemoryRequirements wants;
  vkGetBufferMemoryRequirements(device.get(), get(), &wants);
  memory_ = device.allocated(wants, wanted, better);
  check(vkBindBufferMemory(device.get(), get(), memory_.get(), 0), "vkBindBufferMemory");
}

VisibleBuffer::VisibleBuffer(const Device& device, VkDeviceSize bytes, VkBufferUsageFlags usage)
    : Buffer(device, bytes, usage, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT,
             VK_MEMORY_PROPERTY_HOST_CACHED_BIT),
      bytes_(bytes) {
  check(vkMapMemory(device.get(), memory(), 0, VK_WHOLE_SIZE, 0, &mapped_), "vkMapMemory");
}

DeviceBuffer::DeviceBuffer(Device& device, std::span<const std::byte> content, VkBufferUsageFlags usage)
    : Buffer(device, content.size(), usage | VK_BUFFER_USAGE_TRANSFER_DST_BIT, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT) {
  if (content.empty()) return;
  const VisibleBuffer staging(device, content.size(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
  std::memcpy(staging.as<std::byte>().data(), content.data(), content.size());
  device.run([&](VkCommandBuffer commands) {
    const VkBufferCopy all{0, 0, content.size()};
    vkCmdCopyBuffer(commands, staging.get(), get(), 1, &all);
    let_see(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT,
            VK_ACCESS_MEMORY_READ_BIT);
  });
}

LayeredImage::LayeredImage(const Device& device, const ImageShape& shape, VkFormat format, VkImageUsageFlags usage)
    : format_(format), mips_(shape.mips) {
  VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
  info.imageType = VK_IMAGE_TYPE_2D;
  info.format = format;
  info.extent = {shape.width, shape.height, 1};
  info.mipLevels = shape.mips;
  info.arrayLayers = shape.layers;
  info.samples = VK_SAMPLE_COUNT_1_BIT;
  info.tiling = VK_IMAGE_TILING_OPTIMAL;
  info.usage = usage;
  image_ = OwnedImage(device.get(), info, "vkCreateImage");
  VkMemoryRequirements wants;
  vkGetImageMemoryRequirements(device.get(), get(), &wants);
  memory_ = device.allocated(wants, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
  check(vkBindImageMemory(device.get(), get(), memory_.get(), 0), "vkBindImageMemory");
}

OwnedImageView LayeredImage::view(const Device& device, std::uint32_t layer, VkImageAspectFlags aspect) const {
  VkImageViewCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
  info.image = get();
  info.viewType = VK_IMAGE_VIEW_TYPE_2D;
  info.format = format_;
  info.subresourceRange = {aspect, 0, mips_, layer, 1};
  return OwnedImageView(device.get(), info, "vkCreateImageView");
}

}  // namespace foredraw::gpu

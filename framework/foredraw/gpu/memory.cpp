#include <foredraw/gpu/memory.h>

#include <algorithm>
#include <cstring>

namespace foredraw::gpu {

namespace {

OwnedBuffer make_buffer(const Device& device, VkDeviceSize bytes, VkBufferUsageFlags usage) {
  VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
  info.size = std::max<VkDeviceSize>(bytes, 16);  // none may be empty
  info.usage = usage;
  return OwnedBuffer(device.get(), info, "vkCreateBuffer");
}

OwnedMemory make_memory(const Device& device, const VkMemoryRequirements& wants, VkMemoryPropertyFlags wanted,
                        VkMemoryPropertyFlags better = 0) {
  VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
  info.allocationSize = wants.size;
  info.memoryTypeIndex = device.memory_type(wants.memoryTypeBits, wanted, better);
  return OwnedMemory(device.get(), info, "vkAllocateMemory");
}

OwnedMemory memory_of(const Device& device, VkBuffer buffer, VkMemoryPropertyFlags wanted,
                      VkMemoryPropertyFlags better = 0) {
  VkMemoryRequirements wants;
  vkGetBufferMemoryRequirements(device.get(), buffer, &wants);
  OwnedMemory memory = make_memory(device, wants, wanted, better);
  check(vkBindBufferMemory(device.get(), buffer, memory.get(), 0), "vkBindBufferMemory");
  return memory;
}

}  // namespace

void let_see(VkCommandBuffer commands, VkPipelineStageFlags writing, VkAccessFlags written,
             VkPipelineStageFlags reading, VkAccessFlags read) {
  VkMemoryBarrier barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER};
  barrier.srcAccessMask = written;
  barrier.dstAccessMask = read;
  vkCmdPipelineBarrier(commands, writing, reading, 0, 1, &barrier, 0, nullptr, 0, nullptr);
}

VisibleBuffer::VisibleBuffer(const Device& device, VkDeviceSize bytes, VkBufferUsageFlags usage) : bytes_(bytes) {
  buffer_ = make_buffer(device, bytes, usage);
  memory_ = memory_of(device, buffer_.get(), VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT,
                      VK_MEMORY_PROPERTY_HOST_CACHED_BIT);
  check(vkMapMemory(device.get(), memory_.get(), 0, VK_WHOLE_SIZE, 0, &mapped_), "vkMapMemory");
}

DeviceBuffer::DeviceBuffer(Device& device, std::span<const std::byte> content, VkBufferUsageFlags usage) {
  buffer_ = make_buffer(device, content.size(), usage | VK_BUFFER_USAGE_TRANSFER_DST_BIT);
  memory_ = memory_of(device, buffer_.get(), VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
  if (content.empty()) return;
  const VisibleBuffer staging(device, content.size(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
  std::memcpy(staging.as<std::byte>().data(), content.data(), content.size());
  device.run([&](VkCommandBuffer commands) {
    const VkBufferCopy all{0, 0, content.size()};
    vkCmdCopyBuffer(commands, staging.get(), get(), 1, &all);
    let_see(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT,
            VK_PIPELINE_STAGE_DRAW_INDIRECT_BIT | VK_PIPELINE_STAGE_VERTEX_INPUT_BIT |
                VK_PIPELINE_STAGE_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT,
            VK_ACCESS_INDIRECT_COMMAND_READ_BIT | VK_ACCESS_INDEX_READ_BIT | VK_ACCESS_VERTEX_ATTRIBUTE_READ_BIT |
                VK_ACCESS_SHADER_READ_BIT);
  });
}

LayeredImage::LayeredImage(const Device& device, std::uint32_t size, std::uint32_t layers, VkFormat format,
                           VkImageUsageFlags usage)
    : format_(format) {
  VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
  info.imageType = VK_IMAGE_TYPE_2D;
  info.format = format;
  info.extent = {size, size, 1};
  info.mipLevels = 1;
  info.arrayLayers = layers;
  info.samples = VK_SAMPLE_COUNT_1_BIT;
  info.tiling = VK_IMAGE_TILING_OPTIMAL;
  info.usage = usage;
  image_ = OwnedImage(device.get(), info, "vkCreateImage");
  VkMemoryRequirements wants;
  vkGetImageMemoryRequirements(device.get(), get(), &wants);
  memory_ = make_memory(device, wants, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
  check(vkBindImageMemory(device.get(), get(), memory_.get(), 0), "vkBindImageMemory");
}

OwnedImageView LayeredImage::view(const Device& device, std::uint32_t layer, VkImageAspectFlags aspect) const {
  VkImageViewCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
  info.image = get();
  info.viewType = VK_IMAGE_VIEW_TYPE_2D;
  info.format = format_;
  info.subresourceRange = {aspect, 0, 1, layer, 1};
  return OwnedImageView(device.get(), info, "vkCreateImageView");
}

}  // namespace foredraw::gpu

#pragma once
// Buffers and images with the memory that they lie in.

#include <foredraw/gpu/device.h>

#include <cstddef>
#include <span>

namespace foredraw::gpu {

/// What both kinds of buffers are: a handle, and the memory bound to it.
class Buffer {
 public:
  VkBuffer get() const { return buffer_.get(); }

 protected:
  Buffer() = default;
  Buffer(const Device& device, VkDeviceSize bytes, VkBufferUsageFlags usage, VkMemoryPropertyFlags wanted,
         VkMemoryPropertyFlags better = 0);
  VkDeviceMemory memory() const { return memory_.get(); }

 private:
  OwnedMemory memory_;
  OwnedBuffer buffer_;
};

/// A buffer that the processor sees, for as long as it lives. Nothing has to be flushed.
class VisibleBuffer : public Buffer {
 public:
  VisibleBuffer() = default;
  /// `bytes` may be 0, then it has a few.
  VisibleBuffer(const Device& device, VkDeviceSize bytes, VkBufferUsageFlags usage);

  template <class T>
  std::span<T> as() const {
    return {static_cast<T*>(mapped_), bytes_ / sizeof(T)};
  }

 private:
  void* mapped_ = nullptr;
  std::size_t bytes_ = 0;
};

/// A buffer in the device's own memory.
class DeviceBuffer : public Buffer {
 public:
  DeviceBuffer() = default;
  DeviceBuffer(Device& device, std::span<const std::byte> content, VkBufferUsageFlags usage);
};

/// Texels, and how often they are there.
struct ImageShape {
  std::uint32_t width = 1, height = 1;
  std::uint32_t layers = 1;
  std::uint32_t mips = 1;  ///< levels, each half as wide and high as the one before, rounded down but not to 0
};

/// Images of one size, one behind the other, in the device's own memory.
class LayeredImage {
 public:
  LayeredImage() = default;
  LayeredImage(const Device& device, const ImageShape& shape, VkFormat format, VkImageUsageFlags usage);

  VkImage get() const { return image_.get(); }
  /// One layer with all its mip levels. Only an image with a single one can be drawn into.
  OwnedImageView view(const Device& device, std::uint32_t layer, VkImageAspectFlags aspect) const;

 private:
  VkFormat format_ = VK_FORMAT_UNDEFINED;
  std::uint32_t mips_ = 1;
  OwnedMemory memory_;
  OwnedImage image_;
};

/// Whoever reads from here on sees what was written before.
void let_see(VkCommandBuffer commands, VkPipelineStageFlags writing, VkAccessFlags written,
             VkPipelineStageFlags reading, VkAccessFlags read);

}  // namespace foredraw::gpu

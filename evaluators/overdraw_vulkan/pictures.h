#pragma once
#include "vulkan_memory.h"

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// As many pictures of one size as fit into a bounded memory, each with an owner and a depth attachment: what one batch
/// of views is drawn into.
class Pictures {
 public:
  /// Throws std::runtime_error where the device does not make pictures that large.
  Pictures(VulkanDevice& device, VkRenderPass render_pass, int size);

  std::uint32_t size() const { return size_; }
  std::uint32_t count() const { return count_; }

  /// Begins to draw into the picture, which is empty then.
  void begin(VkCommandBuffer commands, VkRenderPass render_pass, std::uint32_t picture) const;
  /// Empties it again.
  void clear(VkCommandBuffer commands) const;
  /// Copies the first pictures' owners to where owners() reads them.
  void copy_out(VkCommandBuffer commands, std::uint32_t pictures) const;
  /// Who stayed in each pixel, row by row, or nobody.
  std::span<const std::uint32_t> owners(std::uint32_t picture) const;

 private:
  std::uint32_t size_;
  std::uint32_t count_;
  LayeredImage owner_image_;
  LayeredImage depth_image_;
  VisibleBuffer owners_;
  std::vector<OwnedImageView> views_;
  std::vector<OwnedFramebuffer> framebuffers_;
};

}  // namespace foredraw

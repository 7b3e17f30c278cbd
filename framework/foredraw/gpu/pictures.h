#pragma once
#include <foredraw/gpu/memory.h>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw::gpu {

/// What a pixel holds where nothing was drawn.
inline constexpr std::uint32_t empty_pixel = ~std::uint32_t{0};

/// Of pixels that hold numbers.
inline constexpr VkFormat number_format = VK_FORMAT_R32_UINT;

/// Clears pixels and depths, is drawn into, and leaves the pixels ready to be copied.
OwnedRenderPass make_render_pass(const Device& device, VkFormat pixel_format = number_format);

/// The longest edge of a picture that the device draws into.
std::uint32_t longest_edge(const Device& device);

/// As many square pictures of one size as fit into a bounded memory, each with 32 bits and a depth for each pixel: what
/// a batch of views is drawn into.
class Pictures {
 public:
  /// `render_pass`: as make_render_pass() makes it; has to live longer. Throws std::runtime_error where the device does
  /// not make pictures that large.
  Pictures(const Device& device, VkRenderPass render_pass, int size);

  std::uint32_t size() const { return size_; }
  std::uint32_t count() const { return count_; }

  /// Begins the render pass in the picture, which is empty then.
  void begin(VkCommandBuffer commands, std::uint32_t picture) const;
  /// Empties it again.
  void clear(VkCommandBuffer commands) const;
  /// Copies the first pictures to where pixels() reads them.
  void copy_out(VkCommandBuffer commands, std::uint32_t pictures) const;
  /// What stayed in each pixel, row by row, or empty_pixel.
  std::span<const std::uint32_t> pixels(std::uint32_t picture) const;

 private:
  VkRenderPass render_pass_;
  std::uint32_t size_;
  std::uint32_t count_;
  LayeredImage pixel_image_;
  LayeredImage depth_image_;
  VisibleBuffer pixels_;
  std::vector<OwnedImageView> views_;
  std::vector<OwnedFramebuffer> framebuffers_;
};

}  // namespace foredraw::gpu

#pragma once
// Images that shaders sample.

#include <foredraw/gpu/descriptor_sets.h>
#include <foredraw/gpu/memory.h>

#include <cstdint>
#include <span>

namespace foredraw::gpu {

/// A mip level, rows from the top.
struct TextureLevel {
  std::uint32_t width = 1, height = 1;
  std::span<const std::byte> texels;
};

/// An image with its mip levels, in the device's own memory.
class Texture {
 public:
  /// `levels`: each half as wide and high as the one before, rounded down but not to 0; one at least. Those that are
  /// larger than the device's images are left out. `format`: what a texel is; usually four channels of 8 bits, which
  /// are read as 0 to 1.
  Texture(Device& device, std::span<const TextureLevel> levels, VkFormat format = VK_FORMAT_R8G8B8A8_UNORM);

  VkImageView view() const { return view_.get(); }

 private:
  LayeredImage image_;
  OwnedImageView view_;
};

/// How a texture is read: `filter` between texels, nothing between mip levels, and what lies beyond its edges.
OwnedSampler make_sampler(const Device& device, VkFilter filter, VkSamplerAddressMode u, VkSamplerAddressMode v);

/// That of sets of textures, texture i at binding i, for fragment shaders.
inline OwnedSetLayout texture_layout(const Device& device, std::uint32_t textures) {
  return set_layout(device, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, textures, VK_SHADER_STAGE_FRAGMENT_BIT);
}

/// A texture, and how it is read.
struct SampledTexture {
  VkImageView view = VK_NULL_HANDLE;
  VkSampler sampler = VK_NULL_HANDLE;
};

/// Descriptor sets of such a layout. Device and layout have to live longer.
class TextureSets : public DescriptorSets {
 public:
  /// `most`: how many sets there may be at most; none is fine.
  TextureSets(const Device& device, VkDescriptorSetLayout layout, std::uint32_t textures, std::size_t most)
      : DescriptorSets(device, layout, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, textures, most) {}

  /// Puts the textures into the set: not while commands that use it wait.
  void write(VkDescriptorSet set, std::span<const SampledTexture> textures) const;
};

}  // namespace foredraw::gpu

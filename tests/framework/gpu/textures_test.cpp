#include <foredraw/gpu/textures.h>

#include "support/on_device.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace foredraw::gpu::textures_test {
namespace {

using GpuTextures = testing::OnDevice;

TEST_F(GpuTextures, begin_with_the_first_level_that_the_device_holds) {
  Device device(choice());
  const std::uint32_t most = device.limits().maxImageDimension2D;
  const std::vector<std::byte> texels(std::size_t{4} * 4 * most);
  const auto level = [&](std::uint32_t width) { return TextureLevel{width, 1, std::span(texels).first(4 * width)}; };
  const std::vector<TextureLevel> levels = {level(4 * most), level(2 * most), level(most), level(most / 2)};
  EXPECT_NE(Texture(device, levels).view(), VkImageView{VK_NULL_HANDLE});
  EXPECT_THROW(Texture(device, {}), std::runtime_error);
}

TEST_F(GpuTextures, sets_hold_images_and_how_they_are_read) {
  Device device(choice());
  const std::vector<std::byte> texels(4);
  const Texture texture(device, std::vector{TextureLevel{1, 1, texels}});
  const OwnedSampler sampler =
      make_sampler(device, VK_FILTER_NEAREST, VK_SAMPLER_ADDRESS_MODE_REPEAT, VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT);
  const OwnedSetLayout layout = texture_layout(device, 2);
  TextureSets sets(device, layout.get(), 2, 2);
  const VkDescriptorSet set = sets.add();
  const SampledTexture sampled{texture.view(), sampler.get()};
  sets.write(set, std::array{sampled, sampled});
  EXPECT_NE(sets.add(), set);
}

}  // namespace
}  // namespace foredraw::gpu::textures_test

#include <foredraw/gpu/pictures.h>

#include "support/on_device.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace foredraw::gpu::pictures_test {
namespace {

using GpuPictures = testing::OnDevice;

TEST_F(GpuPictures, are_empty_where_nothing_is_drawn) {
  Device device(choice());
  const OwnedRenderPass render_pass = make_render_pass(device);
  const Pictures pictures(device, render_pass.get(), 33);
  ASSERT_GE(pictures.count(), 3u);
  device.run([&](VkCommandBuffer commands) {
    for (std::uint32_t picture = 0; picture < 3; ++picture) {
      pictures.begin(commands, picture);
      VkClearAttachment painted{VK_IMAGE_ASPECT_COLOR_BIT, 0, {}};
      painted.clearValue.color.uint32[0] = picture;
      const VkClearRect row{{{0, static_cast<std::int32_t>(picture)}, {33, 1}}, 0, 1};
      vkCmdClearAttachments(commands, 1, &painted, 1, &row);
      if (picture == 1) pictures.clear(commands);
      vkCmdEndRenderPass(commands);
    }
    pictures.copy_out(commands, 3);
  });
  for (std::uint32_t picture = 0; picture < 3; ++picture) {
    const auto pixels = pictures.pixels(picture);
    ASSERT_EQ(pixels.size(), 33u * 33);
    EXPECT_EQ(std::ranges::count(pixels.subspan(33 * picture, 33), picture), picture == 1 ? 0 : 33);
    EXPECT_EQ(std::ranges::count(pixels, empty_pixel), picture == 1 ? 33 * 33 : 32 * 33);
  }
}

TEST_F(GpuPictures, are_as_many_as_fit_and_none_where_one_is_too_large) {
  const Device device(choice());
  const OwnedRenderPass render_pass = make_render_pass(device);
  EXPECT_LT(Pictures(device, render_pass.get(), 1200).count(), 4u);
  EXPECT_EQ(Pictures(device, render_pass.get(), 4000).count(), 1u);
  try {
    Pictures(device, render_pass.get(), 1 << 20);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("smaller size"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace foredraw::gpu::pictures_test

#include <foredraw/gpu/memory.h>

#include "support/on_device.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace foredraw::gpu::gpu_memory_test {
namespace {

using GpuMemory = testing::OnDevice;

TEST_F(GpuMemory, what_is_put_into_the_device_comes_out_again) {
  Device device(choice());
  std::vector<std::uint32_t> numbers(1000);
  std::iota(numbers.begin(), numbers.end(), 7u);
  const DeviceBuffer there(device, std::as_bytes(std::span(numbers)), VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
  const VisibleBuffer here(device, 4000, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
  device.run([&](VkCommandBuffer commands) {
    const VkBufferCopy all{0, 0, 4000};
    vkCmdCopyBuffer(commands, there.get(), here.get(), 1, &all);
    let_see(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_HOST_BIT,
            VK_ACCESS_HOST_READ_BIT);
  });
  EXPECT_TRUE(std::ranges::equal(here.as<std::uint32_t>(), numbers));
}

TEST_F(GpuMemory, buffers_may_be_of_nothing) {
  Device device(choice());
  EXPECT_NE(DeviceBuffer(device, {}, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT).get(), VkBuffer{VK_NULL_HANDLE});
  EXPECT_EQ(VisibleBuffer(device, 0, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT).as<std::uint32_t>().size(), 0u);
}

}  // namespace
}  // namespace foredraw::gpu::gpu_memory_test

#include <foredraw/gpu/memory.h>
#include <foredraw/gpu/stopwatch.h>

#include "support/on_device.h"

#include <gtest/gtest.h>

namespace foredraw::gpu::stopwatch_test {
namespace {

using GpuStopwatch = testing::OnDevice;

TEST_F(GpuStopwatch, work_takes_time) {
  Device device(choice());
  if (device.timestamp_mask() == 0) GTEST_SKIP() << "this device has no clock";
  const VisibleBuffer buffer(device, 1 << 24, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
  const double time = nanoseconds(device, [&](VkCommandBuffer commands) {
    for (int i = 0; i < 30; ++i) {
      vkCmdFillBuffer(commands, buffer.get(), 0, VK_WHOLE_SIZE, 1);
      let_see(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_TRANSFER_BIT,
              VK_ACCESS_TRANSFER_WRITE_BIT);
    }
  });
  EXPECT_GT(time, 0);
}

}  // namespace
}  // namespace foredraw::gpu::stopwatch_test

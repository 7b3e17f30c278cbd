#include <foredraw/gpu/queries.h>
#include <foredraw/gpu/stopwatch.h>

#include <array>

namespace foredraw::gpu {

double nanoseconds(Device& device, const std::function<void(VkCommandBuffer)>& record) {
  const Queries stamps(device, VK_QUERY_TYPE_TIMESTAMP, 2);
  device.run([&](VkCommandBuffer commands) {
    stamps.reset(commands);
    vkCmdWriteTimestamp(commands, VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, stamps.get(), 0);
    record(commands);
    vkCmdWriteTimestamp(commands, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, stamps.get(), 1);
  });
  std::array<std::uint64_t, 2> ticks{};
  stamps.read(0, ticks);
  // The clock may have less than 64 bits and come round.
  const std::uint64_t elapsed = (ticks[1] - ticks[0]) & device.timestamp_mask();
  return static_cast<double>(elapsed) * static_cast<double>(device.limits().timestampPeriod);
}

}  // namespace foredraw::gpu

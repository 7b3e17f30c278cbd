#include <foredraw/gpu/stopwatch.h>

#include <array>

namespace foredraw::gpu {

double Stopwatch::time(const std::function<void(VkCommandBuffer)>& record) {
  device_.run([&](VkCommandBuffer commands) {
    stamps_.reset(commands);
    vkCmdWriteTimestamp(commands, VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, stamps_.get(), 0);
    record(commands);
    vkCmdWriteTimestamp(commands, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, stamps_.get(), 1);
  });
  std::array<std::uint64_t, 2> ticks{};
  stamps_.read(0, ticks);
  // The clock may have less than 64 bits and come round.
  const std::uint64_t elapsed = (ticks[1] - ticks[0]) & device_.timestamp_mask();
  return static_cast<double>(elapsed) * static_cast<double>(device_.limits().timestampPeriod);
}

}  // namespace foredraw::gpu

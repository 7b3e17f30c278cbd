#include "stopwatch.h"

#include <array>

namespace foredraw {

Stopwatch::Stopwatch(VulkanDevice& device) : device_(device) {
  VkQueryPoolCreateInfo info{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
  info.queryType = VK_QUERY_TYPE_TIMESTAMP;
  info.queryCount = 2;
  stamps_ = OwnedQueryPool(device.get(), info, "vkCreateQueryPool");
}

double Stopwatch::time(const std::function<void(VkCommandBuffer)>& record) {
  device_.run([&](VkCommandBuffer commands) {
    vkCmdResetQueryPool(commands, stamps_.get(), 0, 2);
    vkCmdWriteTimestamp(commands, VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, stamps_.get(), 0);
    record(commands);
    vkCmdWriteTimestamp(commands, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, stamps_.get(), 1);
  });
  std::array<std::uint64_t, 2> ticks{};
  check(vkGetQueryPoolResults(device_.get(), stamps_.get(), 0, 2, sizeof(ticks), ticks.data(), sizeof(ticks[0]),
                              VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
        "vkGetQueryPoolResults");
  // The clock may have less than 64 bits and come round.
  const std::uint64_t elapsed = (ticks[1] - ticks[0]) & device_.timestamp_mask();
  return static_cast<double>(elapsed) * static_cast<double>(device_.limits().timestampPeriod);
}

}  // namespace foredraw

#pragma once
#include <foredraw/gpu/device.h>

#include <cstdint>
#include <span>

namespace foredraw::gpu {

/// Numbers that the device takes down while it works through commands.
class Queries {
 public:
  /// `statistics`: of VK_QUERY_TYPE_PIPELINE_STATISTICS, which one. The device has to live longer.
  Queries(const Device& device, VkQueryType type, std::uint32_t count, VkQueryPipelineStatisticFlags statistics = 0);

  VkQueryPool get() const { return pool_.get(); }
  /// All of them; not within a render pass.
  void reset(VkCommandBuffer commands) const { vkCmdResetQueryPool(commands, get(), 0, count_); }
  /// Waits for queries `first`, `first` + 1, ... Each has to have been used since the reset. `numbers`: how many a
  /// query of this type takes down.
  void read(std::uint32_t first, std::span<std::uint64_t> results, std::uint32_t numbers = 1) const;

 private:
  VkDevice device_;
  std::uint32_t count_;
  OwnedQueryPool pool_;
};

}  // namespace foredraw::gpu

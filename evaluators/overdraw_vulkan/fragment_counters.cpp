#include "fragment_counters.h"

#include <algorithm>

namespace foredraw {

FragmentCounters::FragmentCounters(const VulkanDevice& device, DrawPipelines& pipelines, CountMethod method,
                                   std::uint32_t count)
    : device_(device), pipelines_(pipelines), method_(method), count_(count) {
  if (method == CountMethod::atomics) {
    atomics_ = VisibleBuffer(device, std::size_t{count} * sizeof(std::uint32_t), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    return;
  }
  VkQueryPoolCreateInfo info{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
  info.queryType = VK_QUERY_TYPE_OCCLUSION;
  info.queryCount = count;
  queries_ = OwnedQueryPool(device.get(), info, "vkCreateQueryPool");
}

void FragmentCounters::start(VkCommandBuffer commands) const {
  if (method_ == CountMethod::queries) {
    vkCmdResetQueryPool(commands, queries_.get(), 0, count_);
    return;
  }
  std::ranges::fill(atomics_.as<std::uint32_t>(), 0);  // seen by the device, for it is written before the hand-in
  const VkDescriptorSet set = pipelines_.counters_at(atomics_.get());
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines_.layout(), 0, 1, &set, 0, nullptr);
}

void FragmentCounters::finish(VkCommandBuffer commands) const {
  if (method_ == CountMethod::queries) return;
  let_see(commands, VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, VK_ACCESS_SHADER_WRITE_BIT, VK_PIPELINE_STAGE_HOST_BIT,
          VK_ACCESS_HOST_READ_BIT);
}

void FragmentCounters::begin(VkCommandBuffer commands, std::uint32_t counter) const {
  if (method_ == CountMethod::atomics) return;
  vkCmdBeginQuery(commands, queries_.get(), counter, VK_QUERY_CONTROL_PRECISE_BIT);
}

void FragmentCounters::end(VkCommandBuffer commands, std::uint32_t counter) const {
  if (method_ == CountMethod::atomics) return;
  vkCmdEndQuery(commands, queries_.get(), counter);
}

std::vector<std::uint64_t> FragmentCounters::read(std::uint32_t count) const {
  if (method_ == CountMethod::atomics) {
    const std::span<std::uint32_t> counted = atomics_.as<std::uint32_t>().first(count);
    return {counted.begin(), counted.end()};
  }
  std::vector<std::uint64_t> counted(count);
  check(vkGetQueryPoolResults(device_.get(), queries_.get(), 0, count, count * sizeof(std::uint64_t), counted.data(),
                              sizeof(std::uint64_t), VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
        "vkGetQueryPoolResults");
  return counted;
}

}  // namespace foredraw

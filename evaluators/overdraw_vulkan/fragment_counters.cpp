#include "fragment_counters.h"

#include <algorithm>

namespace foredraw {

FragmentCounters::FragmentCounters(const gpu::Device& device, DrawPipelines& pipelines, CountMethod method,
                                   std::uint32_t count)
    : pipelines_(pipelines), method_(method), count_(count), queries_(device, VK_QUERY_TYPE_OCCLUSION, count) {
  if (method == CountMethod::queries) return;
  atomics_ = gpu::VisibleBuffer(device, std::size_t{count} * sizeof(std::uint32_t), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
}

void FragmentCounters::start(VkCommandBuffer commands) {
  is_queried_.assign(count_, false);
  queries_.reset(commands);
  if (method_ == CountMethod::queries) return;
  std::ranges::fill(atomics_.as<std::uint32_t>(), 0);  // seen by the device, for it is written before the hand-in
  const VkDescriptorSet set = pipelines_.counters_at(atomics_.get());
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines_.layout(), 0, 1, &set, 0, nullptr);
}

void FragmentCounters::finish(VkCommandBuffer commands) const {
  if (method_ == CountMethod::queries) return;
  gpu::let_see(commands, VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, VK_ACCESS_SHADER_WRITE_BIT, VK_PIPELINE_STAGE_HOST_BIT,
               VK_ACCESS_HOST_READ_BIT);
}

void FragmentCounters::begin(VkCommandBuffer commands, std::uint32_t counter, bool has_holes) {
  if (method_ == CountMethod::atomics && !has_holes) return;
  is_queried_[counter] = true;
  vkCmdBeginQuery(commands, queries_.get(), counter, VK_QUERY_CONTROL_PRECISE_BIT);
}

void FragmentCounters::end(VkCommandBuffer commands, std::uint32_t counter) const {
  if (is_queried_[counter]) vkCmdEndQuery(commands, queries_.get(), counter);
}

std::vector<std::uint64_t> FragmentCounters::read(std::uint32_t count) const {
  std::vector<std::uint64_t> counted(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (is_queried_[i]) {
      queries_.read(i, std::span(counted).subspan(i, 1));
    } else {
      counted[i] = atomics_.as<std::uint32_t>()[i];
    }
  }
  return counted;
}

}  // namespace foredraw

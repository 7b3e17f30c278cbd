#include "overdraw_vulkan.h"

#include "vulkan_painter.h"

namespace foredraw {

std::optional<std::vector<std::uint64_t>> vertex_shader_invocations(OverdrawDevice& overdraw_device,
                                                                    std::span<const RasterPart> parts) {
  VulkanPainter& painter = overdraw_device.painter();
  VulkanDevice& device = painter.device();
  if (!device.counts_vertices()) return std::nullopt;
  std::vector<std::uint64_t> invocations(parts.size());
  const UploadedParts uploaded = painter.uploaded(parts);
  if (uploaded.drawn.empty()) return invocations;

  VkQueryPoolCreateInfo info{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
  info.queryType = VK_QUERY_TYPE_PIPELINE_STATISTICS;
  info.queryCount = static_cast<std::uint32_t>(uploaded.drawn.size());
  info.pipelineStatistics = VK_QUERY_PIPELINE_STATISTIC_VERTEX_SHADER_INVOCATIONS_BIT;
  const OwnedQueryPool queries(device.get(), info, "vkCreateQueryPool");
  const Pictures& pictures =
      painter.any_pictures();  // vertices are the same whatever is seen of them: one view will do
  device.run([&](VkCommandBuffer commands) {
    vkCmdResetQueryPool(commands, queries.get(), 0, info.queryCount);
    pictures.begin(commands, painter.pipelines().render_pass(), 0);
    painter.draw(commands, uploaded, View{},
                 {.before = [&](std::uint32_t i) { vkCmdBeginQuery(commands, queries.get(), i, 0); },
                  .after = [&](std::uint32_t i) { vkCmdEndQuery(commands, queries.get(), i); }});
    vkCmdEndRenderPass(commands);
  });
  std::vector<std::uint64_t> of_drawn(info.queryCount);
  check(
      vkGetQueryPoolResults(device.get(), queries.get(), 0, info.queryCount, info.queryCount * sizeof(std::uint64_t),
                            of_drawn.data(), sizeof(std::uint64_t), VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
      "vkGetQueryPoolResults");
  for (std::size_t i = 0; i < of_drawn.size(); ++i) invocations[uploaded.drawn[i].number] = of_drawn[i];
  return invocations;
}

}  // namespace foredraw

#include "overdraw_vulkan.h"

#include "vulkan_painter.h"

#include <foredraw/gpu/queries.h>

namespace foredraw {

std::optional<std::vector<std::uint64_t>> vertex_shader_invocations(OverdrawDevice& overdraw_device,
                                                                    std::span<const RasterPart> parts) {
  VulkanPainter& painter = overdraw_device.painter();
  gpu::Device& device = painter.device();
  if (!device.counts_vertices()) return std::nullopt;
  std::vector<std::uint64_t> invocations(parts.size());
  const UploadedParts uploaded = painter.uploaded(parts);
  if (uploaded.drawn.empty()) return invocations;

  std::vector<std::uint64_t> of_drawn(uploaded.drawn.size());
  const gpu::Queries queries(device, VK_QUERY_TYPE_PIPELINE_STATISTICS, static_cast<std::uint32_t>(of_drawn.size()),
                             VK_QUERY_PIPELINE_STATISTIC_VERTEX_SHADER_INVOCATIONS_BIT);
  // Vertices are the same whatever is seen of them: one view will do.
  const gpu::Pictures& pictures = painter.any_pictures();
  device.run([&](VkCommandBuffer commands) {
    queries.reset(commands);
    pictures.begin(commands, 0);
    painter.draw(commands, uploaded, View{},
                 {.before = [&](std::uint32_t i) { vkCmdBeginQuery(commands, queries.get(), i, 0); },
                  .after = [&](std::uint32_t i) { vkCmdEndQuery(commands, queries.get(), i); }});
    vkCmdEndRenderPass(commands);
  });
  queries.read(0, of_drawn);
  for (std::size_t i = 0; i < of_drawn.size(); ++i) invocations[uploaded.drawn[i].number] = of_drawn[i];
  return invocations;
}

}  // namespace foredraw

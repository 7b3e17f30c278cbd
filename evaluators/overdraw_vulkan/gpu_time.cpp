#include "overdraw_vulkan.h"

#include "view_batches.h"
#include "vulkan_painter.h"

#include <foredraw/gpu/stopwatch.h>

#include <algorithm>
#include <array>

namespace foredraw {

std::optional<GpuTime> gpu_time(OverdrawDevice& device, std::span<const RasterPart> parts, const Views& views) {
  VulkanPainter& painter = device.painter();
  if (painter.device().timestamp_mask() == 0) return std::nullopt;
  const UploadedParts uploaded = painter.uploaded(parts);
  if (uploaded.drawn.empty()) return GpuTime{};
  const gpu::Pictures& pictures = painter.pictures(views.size);

  const auto nanoseconds = [&](Shading shading) {
    double sum = 0;
    for_each_batch(views.views, views_in_batch(pictures, uploaded, 1), [&](std::span<const View> some) {
      sum += gpu::nanoseconds(painter.device(), [&](VkCommandBuffer commands) {
        for (std::uint32_t v = 0; v < some.size(); ++v) {
          pictures.begin(commands, v);
          painter.draw(commands, uploaded, some[v], {.shading = shading});
          vkCmdEndRenderPass(commands);
        }
      });
    });
    return sum;
  };
  constexpr std::size_t repetitions = 5;
  std::array<double, repetitions> light{};
  std::array<double, repetitions> heavy{};
  nanoseconds(Shading::owner);                     // wakes the device up
  for (std::size_t i = 0; i < repetitions; ++i) {  // by turns, so that both meet the same moments
    light[i] = nanoseconds(Shading::owner);
    heavy[i] = nanoseconds(Shading::heavy);
  }
  std::ranges::sort(light);
  std::ranges::sort(heavy);
  return GpuTime{light[repetitions / 2] * 1e-6, heavy[repetitions / 2] * 1e-6};
}

}  // namespace foredraw

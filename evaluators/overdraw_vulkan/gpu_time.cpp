#include "overdraw_vulkan.h"

#include "view_batches.h"
#include "vulkan_painter.h"

#include <algorithm>
#include <array>

namespace foredraw {

namespace {

/// Nanoseconds between a hand-in's first draw and the end of its last.
class Stopwatch {
 public:
  explicit Stopwatch(VulkanDevice& device) : device_(device) {
    VkQueryPoolCreateInfo info{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
    info.queryType = VK_QUERY_TYPE_TIMESTAMP;
    info.queryCount = 2;
    stamps_ = OwnedQueryPool(device.get(), info, "vkCreateQueryPool");
  }

  template <class Record>
  double time(Record record) {
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

 private:
  VulkanDevice& device_;
  OwnedQueryPool stamps_;
};

}  // namespace

std::optional<GpuTime> gpu_time(OverdrawDevice& device, std::span<const RasterPart> parts, const Views& views) {
  VulkanPainter& painter = device.painter();
  if (painter.device().timestamp_mask() == 0) return std::nullopt;
  const UploadedParts uploaded = painter.uploaded(parts);
  if (uploaded.drawn.empty()) return GpuTime{};
  const Pictures& pictures = painter.pictures(views.size);
  Stopwatch stopwatch(painter.device());

  const auto nanoseconds = [&](Shading shading) {
    double sum = 0;
    for_each_batch(views.views, views_in_batch(pictures, uploaded, 1), [&](std::span<const View> some) {
      sum += stopwatch.time([&](VkCommandBuffer commands) {
        for (std::uint32_t v = 0; v < some.size(); ++v) {
          pictures.begin(commands, painter.pipelines().render_pass(), v);
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

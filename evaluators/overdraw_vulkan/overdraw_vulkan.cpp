#include "overdraw_vulkan.h"

#include "view_batches.h"
#include "vulkan_painter.h"

#include <foredraw/gpu/queries.h>

namespace foredraw {

namespace {

/// Draws each view twice and counts both times. Where a fragment that is equally near passes too, it writes the depth
/// that is there already: the depth buffer goes through the same states as with `less`, and the two counts differ by
/// the ties alone. The second time counts what is shaded, and leaves each pixel to the part that it shows.
class BatchCount {
 public:
  BatchCount(VulkanPainter& painter, const UploadedParts& parts, int size)
      : painter_(painter),
        parts_(parts),
        pictures_(painter.pictures(size)),
        draws_(static_cast<std::uint32_t>(parts.drawn.size())),
        most_views_(views_in_batch(pictures_, parts, 2)),
        counters_(painter.device(), VK_QUERY_TYPE_OCCLUSION, 2 * draws_ * most_views_) {}

  std::uint32_t most_views() const { return most_views_; }

  void count(std::span<const View> views, OverdrawCounts& counts) {
    painter_.device().run([&](VkCommandBuffer commands) { record(commands, views); });
    const auto view_count = static_cast<std::uint32_t>(views.size());
    std::vector<std::uint64_t> passed(std::size_t{2} * draws_ * view_count);
    for (std::uint32_t i = 0; i < passed.size(); ++i) counters_.read(i, std::span(passed).subspan(i, 1));
    for (std::uint32_t v = 0; v < view_count; ++v) {
      std::vector<OverdrawCount> of_view(counts.size());
      for (std::uint32_t i = 0; i < draws_; ++i) {
        OverdrawCount& count = of_view[parts_.drawn[i].number];
        count.shaded = passed[first_counter(v, Passing::nearer) + i];
        count.ties = passed[first_counter(v, Passing::nearer_or_equal) + i] - count.shaded;
      }
      for (const std::uint32_t owner : pictures_.pixels(v)) {
        if (owner != gpu::empty_pixel) ++of_view[owner].visible;
      }
      for (std::size_t part = 0; part < counts.size(); ++part) counts[part].push_back(of_view[part]);
    }
  }

 private:
  std::uint32_t first_counter(std::uint32_t view, Passing passing) const {
    return (2 * view + (passing == Passing::nearer ? 1 : 0)) * draws_;
  }

  void record(VkCommandBuffer commands, std::span<const View> views) {
    counters_.reset(commands);
    for (std::uint32_t v = 0; v < views.size(); ++v) {
      pictures_.begin(commands, v);
      draw(commands, views[v], Passing::nearer_or_equal, v);
      pictures_.clear(commands);
      draw(commands, views[v], Passing::nearer, v);
      vkCmdEndRenderPass(commands);
    }
    pictures_.copy_out(commands, static_cast<std::uint32_t>(views.size()));
  }

  void draw(VkCommandBuffer commands, const View& view, Passing passing, std::uint32_t v) {
    const std::uint32_t first = first_counter(v, passing);
    painter_.draw(commands, parts_, view,
                  {.passing = passing,
                   .before =
                       [&](std::uint32_t i) {
                         vkCmdBeginQuery(commands, counters_.get(), first + i, VK_QUERY_CONTROL_PRECISE_BIT);
                       },
                   .after = [&](std::uint32_t i) { vkCmdEndQuery(commands, counters_.get(), first + i); }});
  }

  VulkanPainter& painter_;
  const UploadedParts& parts_;
  const gpu::Pictures& pictures_;
  std::uint32_t draws_;
  std::uint32_t most_views_;
  gpu::Queries counters_;
};

}  // namespace

OverdrawDevice::OverdrawDevice(const gpu::DeviceChoice& choice) : painter_(std::make_unique<VulkanPainter>(choice)) {}
OverdrawDevice::~OverdrawDevice() = default;

const std::string& OverdrawDevice::name() const { return painter_->device().name(); }
bool OverdrawDevice::is_processor() const { return painter_->device().is_processor(); }
int OverdrawDevice::depth_bits() const { return painter_->device().depth_format() == VK_FORMAT_D32_SFLOAT ? 32 : 24; }

OverdrawCounts overdraw_vulkan(OverdrawDevice& device, std::span<const RasterPart> parts, const Views& views) {
  OverdrawCounts counts(parts.size());
  VulkanPainter& painter = device.painter();
  const UploadedParts uploaded = painter.uploaded(parts);
  if (uploaded.drawn.empty()) return OverdrawCounts(parts.size(), std::vector<OverdrawCount>(views.views.size()));
  BatchCount batch(painter, uploaded, views.size);
  for_each_batch(views.views, batch.most_views(), [&](std::span<const View> some) { batch.count(some, counts); });
  return counts;
}

}  // namespace foredraw

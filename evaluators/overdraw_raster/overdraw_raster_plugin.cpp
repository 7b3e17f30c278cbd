#include "overdraw_raster.h"

#include <foredraw/measuring/overdraw_evaluator.h>

namespace foredraw {

namespace {

class OverdrawRasterService final : public OverdrawService {
 public:
  using OverdrawService::OverdrawService;

  OverdrawCounts draw(std::span<const RasterPart> parts, const Views& views, Run& run) const override {
    return overdraw_raster(parts, views, run.executor);
  }

  bool can_capture() const override { return true; }

  std::optional<FragmentLayers> capture(std::span<const RasterPart> parts, const Views& views, Run& run,
                                        std::size_t most_bytes) const override {
    return fragment_layers(parts, views, run.executor, most_bytes);
  }
};

}  // namespace

Plugin overdraw_raster_plugin() {
  Plugin plugin = overdraw_plugin<OverdrawOptions>(
      {
          .name = "overdraw-raster",
          .summary = "Measures overdraw exactly, by drawing every subject from many sides on the processor",
          .reference = "Han, Sander 2016, section 1 (overdraw ratio); own",
      },
      [](auto&) {},
      [](const OverdrawOptions& options) { return std::make_unique<OverdrawRasterService>(options.faces); });
  plugin.exact = true;
  return plugin;
}

}  // namespace foredraw

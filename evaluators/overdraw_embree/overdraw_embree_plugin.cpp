#include "overdraw_embree.h"

#include <foredraw/measuring/overdraw_evaluator.h>

namespace foredraw {

namespace {

class OverdrawEmbreeService final : public OverdrawService {
 public:
  OverdrawEmbreeService(Faces faces, const OverdrawEmbreeOptions& options)
      : OverdrawService(faces), options_(options) {}

  OverdrawCounts draw(std::span<const RasterPart> parts, const Views& views, Run& run) const override {
    return overdraw_embree(parts, views, options_, run.executor);
  }

 private:
  OverdrawEmbreeOptions options_;
};

struct Options : OverdrawOptions, OverdrawEmbreeOptions {};

}  // namespace

Plugin overdraw_embree_plugin() {
  return overdraw_plugin<Options>(
      {
          .name = "overdraw-embree",
          .summary = "Measures overdraw by ray tracing, as a slow but independent check of overdraw-raster",
          .reference = "Han, Sander 2016, section 1 (overdraw ratio); Embree (Wald et al. 2014); own",
      },
      [](auto& table) {
        table.template row<int>(
            &Options::samples, "samples",
            "Rays through each pixel: one through its centre, or more at random points; time grows in proportion",
            {1, 1024, "rays"});
      },
      [](const Options& options) {
        return std::make_unique<OverdrawEmbreeService>(
            options.faces, OverdrawEmbreeOptions{options.samples, static_cast<std::uint64_t>(options.ViewSet::seed)});
      });
}

}  // namespace foredraw

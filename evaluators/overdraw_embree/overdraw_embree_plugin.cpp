#include "overdraw_embree.h"

#include "traced_parts.h"

#include <foredraw/analysis/view_shares.h>
#include <foredraw/technique/overdraw_evaluator.h>

#include <optional>

namespace foredraw {

namespace {

class OverdrawEmbree final : public OverdrawService {
 public:
  OverdrawEmbree(Faces faces, const OverdrawEmbreeOptions& options) : OverdrawService(faces), options_(options) {}

  OverdrawCounts draw(std::span<const RasterPart> parts, const Views& views, Run& run) override {
    std::optional<TracedParts> traced;
    run.executor.for_each(1, [&](std::size_t) { traced.emplace(parts); });  // by no more threads than we are given
    return draw_in_shares(views, run.executor, [&](const Views& some) { return traced->count(some, options_); });
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
          .summary = "Counts overdraw along rays, with as many samples in a pixel as one likes",
          .reference = "Han, Sander 2016, section 1 (overdraw ratio); Embree (Wald et al. 2014); own",
      },
      [](auto& table) {
        table.template row<int>(&Options::samples, "samples",
                                "Rays through each pixel: one through its middle, or more at random places",
                                {1, 1024, "rays"});
      },
      [](const Options& options) {
        return std::make_unique<OverdrawEmbree>(
            options.faces, OverdrawEmbreeOptions{options.samples, static_cast<std::uint64_t>(options.ViewSet::seed)});
      });
}

}  // namespace foredraw

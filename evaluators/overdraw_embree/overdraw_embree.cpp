#include "overdraw_embree.h"

#include "traced_parts.h"

#include <optional>
#include <vector>

namespace foredraw {

OverdrawCounts overdraw_embree(std::span<const RasterPart> parts, const Views& views,
                               const OverdrawEmbreeOptions& options, const Executor& executor) {
  // Embree shares out the making of its tree over whatever threads it finds: here, those of the executor.
  std::optional<TracedParts> traced;
  executor.for_each(1, [&](std::size_t) { traced.emplace(parts); });

  OverdrawCounts counts(parts.size(), std::vector<OverdrawCount>(views.views.size()));
  executor.for_each(views.views.size(), [&](std::size_t view) {
    const std::vector<OverdrawCount> of_view = traced->count(views.views[view], views.size, options);
    for (std::size_t part = 0; part < parts.size(); ++part) counts[part][view] = of_view[part];
  });
  return counts;
}

}  // namespace foredraw

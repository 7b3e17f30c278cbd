#include "overdraw_embree.h"

#include "traced_parts.h"

#include <foredraw/base/parallel.h>

namespace foredraw {

OverdrawCounts overdraw_embree(std::span<const RasterPart> parts, const Views& views,
                               const OverdrawEmbreeOptions& options) {
  OverdrawCounts counts(parts.size());
  // Embree shares out the making of its tree over whatever threads it finds.
  const Executor alone(1);
  alone.for_each(1, [&](std::size_t) {
    const TracedParts traced(parts);
    for (const View& view : views.views) {
      const std::vector<OverdrawCount> of_view = traced.count(view, views.size, options);
      for (std::size_t part = 0; part < parts.size(); ++part) counts[part].push_back(of_view[part]);
    }
  });
  return counts;
}

}  // namespace foredraw

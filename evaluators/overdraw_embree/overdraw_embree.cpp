#include "overdraw_embree.h"

#include "traced_parts.h"

#include <foredraw/base/parallel.h>

namespace foredraw {

OverdrawCounts overdraw_embree(std::span<const RasterPart> parts, const Views& views,
                               const OverdrawEmbreeOptions& options) {
  OverdrawCounts counts;
  // Embree shares out the making of its tree over whatever threads it finds.
  const Executor alone(1);
  alone.for_each(1, [&](std::size_t) { counts = TracedParts(parts).count(views, options); });
  return counts;
}

}  // namespace foredraw

#pragma once
// Views are handed in several at a time: enough to keep the device busy, few enough to bound memory and waiting.

#include "uploaded_parts.h"

#include <foredraw/gpu/pictures.h>
#include <foredraw/scene/views.h>

#include <algorithm>
#include <cstdint>
#include <span>

namespace foredraw {

/// How many views one hand-in draws, where each is drawn `times` times; 1 at least. At most 2^27 triangles and 2^16
/// draws: drivers take a device that is long busy with one hand-in for a device that hangs.
inline std::uint32_t views_in_batch(const gpu::Pictures& pictures, const UploadedParts& parts, std::uint64_t times) {
  const std::uint64_t by_triangles = (1u << 27) / (times * parts.triangles);
  const std::uint64_t by_draws = (1u << 16) / (times * parts.drawn.size());
  return static_cast<std::uint32_t>(
      std::max<std::uint64_t>(1, std::min({std::uint64_t{pictures.count()}, by_triangles, by_draws})));
}

/// Calls visit(some views) until all have had their turn.
template <class Visit>
void for_each_batch(std::span<const View> views, std::size_t most, Visit visit) {
  for (std::size_t first = 0; first < views.size(); first += most) {
    visit(views.subspan(first, std::min(most, views.size() - first)));
  }
}

}  // namespace foredraw

#pragma once
// What overdraw_raster must count, found without cleverness.

#include "support/exact_fragments.h"

#include <foredraw/overdraw/overdraw_count.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace foredraw {

/// [part], in one orthographic view.
inline std::vector<OverdrawCount> overdraw_by_asking(std::span<const RasterPart> parts, const glm::dvec3& direction,
                                                     int size) {
  struct Drawn {
    testing::cpp_int depth;
    std::size_t part;
  };
  std::map<std::pair<int, int>, std::vector<Drawn>> pixels;  // in the order of drawing
  for (const testing::ExactFragment& fragment : testing::exact_fragments(parts, {direction}, size)) {
    pixels[{fragment.x, fragment.y}].push_back({testing::rounded_down(fragment.depth), fragment.part});
  }
  std::vector<OverdrawCount> counts(parts.size());
  for (const auto& [pixel, drawn] : pixels) {
    const Drawn* nearest = nullptr;
    for (const Drawn& fragment : drawn) {
      if (nearest != nullptr && fragment.depth == nearest->depth) ++counts[fragment.part].ties;
      if (nearest != nullptr && fragment.depth >= nearest->depth) continue;
      ++counts[fragment.part].shaded;
      nearest = &fragment;
    }
    ++counts[nearest->part].visible;
  }
  return counts;
}

}  // namespace foredraw

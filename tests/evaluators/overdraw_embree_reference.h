#pragma once
// What overdraw_embree must count, found without a tree and without floats.

#include "../../evaluators/overdraw_embree/overdraw_embree.h"
#include "../../evaluators/overdraw_embree/sample_pattern.h"

#include <foredraw/viewing/camera.h>

#include <algorithm>
#include <vector>

namespace foredraw {

/// Every sample asked of every triangle, in wide integers.
inline std::vector<OverdrawCount> overdraw_by_asking(std::span<const RasterPart> parts, const View& view, int size,
                                                     const OverdrawEmbreeOptions& options) {
  const Camera camera(view, size * (SamplePattern::steps / subpixels));
  struct Asked {
    std::array<Corner, 3> corners;
    std::size_t part;
  };
  std::vector<Asked> triangles;  // that show a face, turning counter-clockwise
  const std::vector<PreparedPart> ready = prepared(parts);
  for (std::size_t part = 0; part < parts.size(); ++part) {
    for (std::size_t t = 0; t < ready[part].triangle_count(); ++t) {
      std::array<Corner, 3> c;
      for (std::size_t i = 0; i < 3; ++i) c[i] = camera.project(ready[part].position(ready[part].corners[i][t]));
      const std::int64_t area = doubled_area(c[0], c[1], c[2]);
      if (area == 0 || (parts[part].culls_back_faces && area < 0)) continue;
      if (area < 0) std::swap(c[1], c[2]);
      triangles.push_back({c, part});
    }
  }
  const auto edge = [](const Corner& p, const Corner& q, __int128 x, __int128 y) {
    return (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
  };
  const auto covers = [&](const Corner& p, const Corner& q, __int128 x, __int128 y) {
    const bool is_top_or_left = p.y > q.y || (p.y == q.y && p.x > q.x);
    return edge(p, q, x, y) > 0 || (edge(p, q, x, y) == 0 && is_top_or_left);
  };
  const auto depth = [&](const std::array<Corner, 3>& c, __int128 x, __int128 y) -> std::uint64_t {
    const auto& [p, q, r] = c;
    const __int128 area = edge(p, q, r.x, r.y);
    const std::array<__int128, 3> weights = {edge(q, r, x, y), edge(r, p, x, y), edge(p, q, x, y)};
    if (!camera.is_perspective()) {
      const __int128 sum = weights[0] * p.depth + weights[1] * q.depth + weights[2] * r.depth;
      return static_cast<std::uint64_t>((2 * sum + area) / (2 * area));
    }
    const long double before = camera.steps_before_sphere();
    long double inverse = 0;
    for (std::size_t i = 0; i < 3; ++i) inverse += static_cast<long double>(weights[i]) / area / (before + c[i].depth);
    return static_cast<std::uint64_t>(1 / inverse - before + 0.5L);
  };

  std::vector<OverdrawCount> counts(parts.size());
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      for (int sample = 0; sample < options.samples; ++sample) {
        const auto place = SamplePattern(options.seed, x, y, options.samples)[sample];
        const __int128 u = __int128{x} * SamplePattern::steps + place.x;
        const __int128 v = __int128{y} * SamplePattern::steps + place.y;
        std::uint64_t nearest = ~std::uint64_t{0};
        std::size_t shown = parts.size();
        for (const auto& [c, part] : triangles) {
          if (!covers(c[0], c[1], u, v) || !covers(c[1], c[2], u, v) || !covers(c[2], c[0], u, v)) continue;
          const std::uint64_t here = depth(c, u, v);
          if (here < nearest) {
            ++counts[part].shaded;
            nearest = here;
            shown = part;
          } else if (here == nearest) {
            ++counts[part].ties;
          }
        }
        if (shown < parts.size()) ++counts[shown].visible;
      }
    }
  }
  return counts;
}

}  // namespace foredraw

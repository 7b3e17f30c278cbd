#include "pattern_samples.h"

#include <algorithm>
#include <stdexcept>

namespace foredraw {

namespace {

/// Of a third of a part, rounded.
std::uint32_t thirds(std::uint32_t count, std::uint32_t parts) {
  return (2 * count * weight_one + 3 * parts) / (6 * parts);
}

/// Rows of triangles side by side: row i has those between i/parts and (i + 1)/parts of u, upright and overturned ones
/// in turn.
std::size_t row_begin(std::size_t row, std::size_t parts) { return row * (2 * parts - row); }

/// Twice the area that a, b and p span, in 1/65536^2.
std::int64_t area(const TessellationPoint& a, const TessellationPoint& b, const TessellationPoint& p) {
  const auto u = [&](const TessellationPoint& q) { return std::int64_t{q.u} - a.u; };
  const auto v = [&](const TessellationPoint& q) { return std::int64_t{q.v} - a.v; };
  return u(b) * v(p) - v(b) * u(p);
}

}  // namespace

std::vector<TessellationPoint> sample_points(std::uint32_t parts) {
  std::vector<TessellationPoint> points;
  points.reserve(std::size_t{parts} * parts);
  for (std::uint32_t i = 0; i < parts; ++i) {
    for (std::uint32_t j = 0; i + j < parts; ++j) {
      points.push_back({thirds(3 * i + 1, parts), thirds(3 * j + 1, parts)});
      if (i + j + 1 < parts) points.push_back({thirds(3 * i + 2, parts), thirds(3 * j + 2, parts)});
    }
  }
  return points;
}

std::vector<LocatedSample> located_samples(const TessellationPattern& pattern, std::uint32_t parts) {
  const std::vector<TessellationPoint> samples = sample_points(parts);
  std::vector<LocatedSample> located(samples.size());
  std::vector<bool> is_known(samples.size(), false);
  for (const auto& corners : pattern.triangles) {
    const TessellationPoint &a = pattern.points[corners[0]], &b = pattern.points[corners[1]],
                            &c = pattern.points[corners[2]];
    const std::int64_t whole = area(a, b, c);
    if (whole == 0) continue;
    const auto part_of = [&](std::uint32_t at) { return std::min(at * parts / weight_one, parts - 1); };
    const auto [low_u, high_u] = std::minmax({a.u, b.u, c.u});
    const auto [low_v, high_v] = std::minmax({a.v, b.v, c.v});
    for (std::size_t row = part_of(low_u); row <= part_of(high_u); ++row) {
      const std::size_t end = row_begin(row + 1, parts);
      const std::size_t first = row_begin(row, parts) + 2 * part_of(low_v);
      const std::size_t last = row_begin(row, parts) + 2 * part_of(high_v) + 2;
      for (std::size_t s = first; s < std::min(last, end); ++s) {
        const std::array<std::int64_t, 3> shares{area(b, c, samples[s]), area(c, a, samples[s]),
                                                 area(a, b, samples[s])};
        const auto is_outside = [&](std::int64_t share) { return whole > 0 ? share < 0 : share > 0; };
        if (is_known[s] || std::ranges::any_of(shares, is_outside)) continue;
        is_known[s] = true;
        located[s].corners = corners;
        for (std::size_t i = 0; i < 3; ++i)
          located[s].weights[i] = static_cast<float>(static_cast<double>(shares[i]) / static_cast<double>(whole));
      }
    }
  }
  if (std::ranges::find(is_known, false) != is_known.end())
    throw std::logic_error("a pattern does not fill its triangle");
  return located;
}

}  // namespace foredraw

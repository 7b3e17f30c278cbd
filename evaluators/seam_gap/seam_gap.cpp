#include "seam_gap.h"

#include <algorithm>
#include <cmath>

namespace foredraw {

namespace {

constexpr double far_away = 1 << 20;  // texels, which a double tells apart from there

/// The height at a place in texels, 0 to 1. What lies far away is taken from there.
double height_at(const foredraw_height_map& map, glm::dvec2 uv) {
  glm::dvec2 at = uv * glm::dvec2(map.width, map.height);
  if (map.is_nearest == 0) at -= 0.5;
  for (int axis = 0; axis < 2; ++axis) at[axis] = std::clamp(at[axis], -far_away, far_away);
  const glm::dvec2 cell(std::floor(at.x), std::floor(at.y));
  const auto texel = [&](std::int32_t right, std::int32_t down) {
    const std::uint32_t x = foredraw_height_texel(static_cast<std::int32_t>(cell.x) + right, map.width, map.wrap[0]);
    const std::uint32_t y = foredraw_height_texel(static_cast<std::int32_t>(cell.y) + down, map.height, map.wrap[1]);
    return map.texels[std::size_t{y} * map.width + x] / 65535.0;
  };
  if (map.is_nearest != 0) return texel(0, 0);
  const glm::dvec2 part = at - cell;
  const double upper = (1 - part.x) * texel(0, 0) + part.x * texel(1, 0);
  const double lower = (1 - part.x) * texel(0, 1) + part.x * texel(1, 1);
  return (1 - part.y) * upper + part.y * lower;
}

double gap_at(std::span<const EdgeSide> sides, double t, const foredraw_height_map& map) {
  double least = 1, most = 0;
  for (const EdgeSide& side : sides) {
    const double height = height_at(map, (1 - t) * glm::dvec2(side.uv[0]) + t * glm::dvec2(side.uv[1]));
    least = std::min(least, height);
    most = std::max(most, height);
  }
  return most - least;
}

}  // namespace

SeamGap seam_gap(const SeamEdges& seams, const foredraw_height_map& map, const SeamGapOptions& options) {
  SeamGap result;
  result.edges = seams.seams;
  result.rule = seam_factors(seams, {map.width, map.height});
  const int steps = std::max(options.samples - 1, 1);
  for (const SharedEdge& edge : seams.edges) {
    double largest = 0;
    for (int i = 0; i <= steps && edge.kind == EdgeKind::seam; ++i) {
      const double gap = gap_at(seams.sides_of(edge), static_cast<double>(i) / steps, map);
      largest = std::max(largest, gap);
      result.squares += gap * gap;
      ++result.samples;
    }
    result.largest_of.push_back(largest);
    result.largest = std::max(result.largest, largest);
  }
  const SeamPoints points = seam_points(seams, result.rule, map);
  const std::vector<bool> is_unequal = unequal_points(points, map, static_cast<std::uint32_t>(options.bits));
  result.points = points.points.size();
  result.unequal = static_cast<std::size_t>(std::ranges::count(is_unequal, true));
  result.factors = exact_factors(seams, points, is_unequal);
  for (std::size_t e = 0; e < result.rule.size(); ++e) {
    if (result.factors[e] < result.rule[e]) ++result.below;
    if (result.factors[e] == 0 && result.rule[e] > 0) ++result.torn;
  }
  return result;
}

}  // namespace foredraw

#include <foredraw/analysis/convex_piece.h>

#include <algorithm>

namespace foredraw {

CutPiece cut(const ConvexPiece& piece, const glm::dvec3& normal, double at, double slack) {
  const auto corners = piece.corners();
  std::array<double, ConvexPiece::most_corners> heights;
  bool any_before = false, any_behind = false;
  const double on_it = slack * glm::length(normal);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    heights[i] = glm::dot(normal, corners[i]) - at;
    any_before = any_before || heights[i] > on_it;
    any_behind = any_behind || heights[i] < -on_it;
  }
  if (!any_before) return {piece, {}};
  if (!any_behind) return {{}, piece};
  const auto crosses = [&](std::size_t i) {
    const auto [low, high] = std::minmax(heights[i], heights[i + 1 < corners.size() ? i + 1 : 0]);
    return low < -on_it && high > on_it;
  };
  std::size_t crossings = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) crossings += crosses(i) ? 1 : 0;
  if (crossings > 2) return {piece, {}};
  CutPiece result;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t next = i + 1 < corners.size() ? i + 1 : 0;
    if (heights[i] <= on_it) result.behind.add(corners[i]);
    if (heights[i] >= -on_it) result.before.add(corners[i]);
    if (!crosses(i)) continue;
    const glm::dvec3 crossing = corners[i] + (corners[next] - corners[i]) * (heights[i] / (heights[i] - heights[next]));
    result.behind.add(crossing);
    result.before.add(crossing);
  }
  return result;
}

}  // namespace foredraw

#include <foredraw/report/pareto.h>

#include <algorithm>
#include <cmath>

namespace foredraw {

std::vector<std::size_t> pareto_front(std::span<const std::pair<double, double>> points) {
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [x, y] = points[i];
    if (!std::isfinite(x) || !std::isfinite(y)) continue;
    const bool is_beaten = std::ranges::any_of(points, [&](const std::pair<double, double>& other) {
      return other.first <= x && other.second <= y && (other.first < x || other.second < y);
    });
    if (!is_beaten) front.push_back(i);
  }
  return front;
}

}  // namespace foredraw

#include "near_looks.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace foredraw {

namespace {

/// 1 less the cosine of the angle at which nothing is near any more. A cap of 2/views holds one view of so many: this
/// one holds those around a view and their neighbours.
double reach(std::size_t views) {
  constexpr double widest = 0.16;  // 33 degrees
  return std::min(widest, 13.0 / static_cast<double>(views));
}

}  // namespace

NearLooks::NearLooks(const SubjectLayers& subject) {
  const std::vector<glm::dvec3>& directions = subject.directions;
  const auto same_pose = [&](std::size_t a, std::size_t b) {
    return subject.poses.empty() || subject.poses[a] == subject.poses[b];
  };
  for (std::uint32_t first = 0, end = 0; first < directions.size(); first = end) {
    while (end < directions.size() && same_pose(first, end)) ++end;
    const double far = reach(end - first);
    for (std::uint32_t look = first; look < end; ++look) {
      for (std::uint32_t other = first; other < end; ++other) {
        const double nearness = 1 - (1 - glm::dot(directions[look], directions[other])) / far;
        const auto weight = static_cast<std::int64_t>(256 * nearness * nearness);
        if (other == look) {
          near_.push_back({other, 256});
        } else if (nearness > 0 && weight > 0) {
          near_.push_back({other, weight});
        }
      }
      first_.push_back(near_.size());
    }
  }
}

}  // namespace foredraw

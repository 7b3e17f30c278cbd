#pragma once
// Crowds to choose levels for, and how far off what is chosen is.

#include <foredraw/base/random.h>
#include <foredraw/runtime/crowd_select.h>
#include <foredraw/runtime/tessellation_level.h>

#include <cmath>
#include <span>
#include <vector>

namespace foredraw::testing {

/// [instance] Evenly over a plane, from 2 to 40 units away.
inline std::vector<float> crowd_distances(std::uint32_t instances, std::uint64_t seed) {
  Random random(seed);
  std::vector<float> distances(instances);
  for (float& distance : distances) distance = static_cast<float>(std::sqrt(4 + 1596 * random.unit()));
  return distances;
}

/// Levels 1 to t_max of a cage of so many triangles, each off by 1 / level.
inline std::vector<foredraw_crowd_level> tessellated_levels(std::uint32_t t_max, std::uint32_t cage = 1) {
  std::vector<foredraw_crowd_level> levels;
  for (std::uint32_t t = 1; t <= t_max; ++t) {
    levels.push_back({cage * foredraw_tessellation_triangles(t), 1.0f / static_cast<float>(t)});
  }
  return levels;
}

/// The character of the paper, and what is left of it where there are many: down to 20 triangles.
inline std::vector<foredraw_crowd_level> froblin_levels() {
  std::vector<foredraw_crowd_level> levels = tessellated_levels(15, 5160);
  for (const std::uint32_t triangles : {2580u, 1290u, 516u, 200u, 80u, 20u}) {
    levels.push_back({triangles, std::sqrt(5160.0f / static_cast<float>(triangles))});
  }
  return levels;
}

class CrowdChooser {
 public:
  explicit CrowdChooser(std::vector<foredraw_crowd_level> levels) : levels_(std::move(levels)) {
    if (foredraw_crowd_prepare(levels_.data(), static_cast<std::uint32_t>(levels_.size()), &table_) == 0) levels_ = {};
    memory_.resize(foredraw_crowd_memory(&table_) / sizeof(std::uint32_t));
  }

  foredraw_crowd_result choose(std::span<const float> distances, std::uint64_t budget, float hysteresis = 0) {
    chosen_.resize(distances.size(), FOREDRAW_CROWD_NEW);
    return foredraw_crowd_select(&table_, distances.data(), static_cast<std::uint32_t>(distances.size()), budget,
                                 hysteresis, chosen_.data(), memory_.data());
  }

  const std::vector<foredraw_crowd_level>& levels() const { return levels_; }
  const foredraw_crowd_table& table() const { return table_; }
  const std::vector<std::uint8_t>& chosen() const { return chosen_; }

  std::uint64_t triangles() const {
    std::uint64_t sum = 0;
    for (const std::uint8_t level : chosen_) sum += levels_[level].triangles;
    return sum;
  }

  double squares(std::span<const float> distances) const {
    double sum = 0;
    for (std::size_t i = 0; i < distances.size(); ++i) {
      const double off = static_cast<double>(levels_[chosen_[i]].error) / static_cast<double>(distances[i]);
      sum += off * off;
    }
    return sum;
  }

 private:
  std::vector<foredraw_crowd_level> levels_;
  foredraw_crowd_table table_{};
  std::vector<std::uint32_t> memory_;
  std::vector<std::uint8_t> chosen_;
};

}  // namespace foredraw::testing

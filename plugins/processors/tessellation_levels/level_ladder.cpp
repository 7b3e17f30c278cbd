#include "level_ladder.h"

#include <foredraw/displaced/displaced_mesh.h>
#include <foredraw/displaced/shared_edges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace foredraw {

namespace {

constexpr float never = -1;

/// [i] the threshold of the step to level i + 1: the highest level that is taken of those whose threshold is passed.
using Thresholds = std::array<float, level_count - 1>;

/// Triangles with equal levels all around.
double cost(std::uint32_t level) {
  const double parts = 1u << level;
  return level == 0 ? 1 : 1.5 * parts * parts;
}

/// Along the lower hull of triangles and squared deviations.
Thresholds rms_thresholds(const std::array<HeightDeviation, level_count>& deviations, std::uint32_t finest) {
  Thresholds thresholds;
  thresholds.fill(never);
  for (std::uint32_t level = 0; level < finest;) {
    double steepest = 0;
    std::uint32_t next = level;
    for (std::uint32_t l = level + 1; l <= finest; ++l) {
      const double slope = (double{deviations[level].squared} - deviations[l].squared) / (cost(l) - cost(level));
      if (slope > 0 && slope >= steepest) steepest = slope, next = l;
    }
    if (next == level) break;
    thresholds[next - 1] = static_cast<float>(steepest);
    level = next;
  }
  return thresholds;
}

/// The largest deviation of what is coarser. A step that takes away less than an eighth of it is none: where the map
/// has a step of its own, all triangles that there may be would go there, and for nothing.
Thresholds largest_thresholds(const std::array<HeightDeviation, level_count>& deviations, std::uint32_t finest) {
  Thresholds thresholds;
  thresholds.fill(never);
  float least = deviations[0].largest;
  for (std::uint32_t level = 1; level <= finest; ++level) {
    if (!(deviations[level].largest < 0.875f * least)) continue;
    thresholds[level - 1] = least;
    least = deviations[level].largest;
  }
  return thresholds;
}

class ContentLadder final : public LevelLadder {
 public:
  ContentLadder(std::span<const std::array<HeightDeviation, level_count>> deviations, std::span<const float> shares,
                std::span<const std::uint8_t> finest, std::span<const std::uint32_t> edges,
                std::span<const std::uint8_t> limits, LevelGoal goal, std::uint64_t most_added)
      : shares_(shares), edges_(edges), limits_(limits), goal_(goal) {
    std::uint32_t affordable = level_count - 1;
    const auto added = [&](std::uint32_t level) {  // beside its neighbours, of which each gets an edge
      return cost(level) - 1 + (takes_larger() ? 3.0 * ((1u << level) + 1) : 0);
    };
    while (affordable > 0 && added(affordable) > static_cast<double>(most_added)) --affordable;
    thresholds_.reserve(deviations.size());
    for (std::size_t t = 0; t < deviations.size(); ++t) {
      const std::uint32_t most = std::min<std::uint32_t>(finest[t], affordable);
      thresholds_.push_back(goal == LevelGoal::rms ? rms_thresholds(deviations[t], most)
                                                   : largest_thresholds(deviations[t], most));
      for (const float threshold : thresholds_.back()) top_ = std::max(top_, threshold);
    }
    top_ = std::nextafter(top_, std::numeric_limits<float>::infinity());
  }

  float top() const override { return top_; }

  void at(const LadderPlace& place, std::vector<LogLevels>& levels) const override {
    levels.resize(thresholds_.size());
    const auto outer = [&](std::size_t edge) -> std::uint8_t& { return levels[edge / 3][edge % 3]; };
    for (std::size_t t = 0; t < levels.size(); ++t) {
      const std::uint8_t own = level_of(t, place);
      levels[t][3] = own;
      const bool has_a_say = takes_larger() || shares_[t] > 0;
      for (std::size_t edge = 3 * t; edge < 3 * t + 3; ++edge) {
        const std::size_t first = edges_[edge];
        if (first == edge) outer(edge) = unknown;
        if (!has_a_say) continue;
        std::uint8_t& level = outer(first);
        level = level == unknown ? own : takes_larger() ? std::max(level, own) : std::min(level, own);
      }
    }
    for (std::size_t edge = 0; edge < edges_.size(); ++edge) {
      std::uint8_t& level = outer(edge);
      const bool is_first = edges_[edge] == edge;
      level = !is_first ? outer(edges_[edge]) : level == unknown ? std::uint8_t{0} : std::min(level, limits_[edge]);
    }
  }

 private:
  static constexpr std::uint8_t unknown = 255;

  bool takes_larger() const { return goal_ == LevelGoal::largest; }

  std::uint8_t level_of(std::size_t triangle, const LadderPlace& place) const {
    for (std::size_t level = level_count; level-- > 1;) {
      const float threshold = thresholds_[triangle][level - 1];
      if (threshold > place.threshold || (threshold == place.threshold && triangle < place.ties))
        return static_cast<std::uint8_t>(level);
    }
    return 0;
  }

  std::span<const float> shares_;
  std::span<const std::uint32_t> edges_;
  std::span<const std::uint8_t> limits_;
  LevelGoal goal_;
  std::vector<Thresholds> thresholds_;  ///< [triangle] falling, but for what is never taken
  float top_ = 0;
};

class EdgeLengthLadder final : public LevelLadder {
 public:
  explicit EdgeLengthLadder(std::span<const HeightPart> parts) {
    for (const HeightPart& part : parts) {
      for (std::size_t edge = 0; edge < part.indices.size() / 3 * 3; ++edge) {
        const EdgeEnds ends = edge_ends(part.indices, edge);
        const glm::dvec3 along = glm::dvec3(part.positions[ends.from]) - glm::dvec3(part.positions[ends.to]);
        const auto length = static_cast<float>(std::sqrt((along.x * along.x + along.y * along.y) + along.z * along.z));
        lengths_.push_back(std::isfinite(length) ? length : 0);
        top_ = std::max(top_, lengths_.back());
      }
    }
    top_ = std::min(2 * top_, std::numeric_limits<float>::max());
  }

  float top() const override { return top_; }

  /// The threshold is how long a part may be: each level stands for what is nearest to it, by ratio.
  void at(const LadderPlace& place, std::vector<LogLevels>& levels) const override {
    constexpr double root = 1.4142135623730951;
    levels.assign(lengths_.size() / 3, LogLevels{});
    for (std::size_t edge = 0; edge < lengths_.size(); ++edge) {
      LogLevels& of = levels[edge / 3];
      std::uint8_t& level = of[edge % 3];
      while (level + 1u < level_count && lengths_[edge] > place.threshold * root * (1u << level)) ++level;
      of[3] = std::max(of[3], level);
    }
  }

 private:
  std::vector<float> lengths_;  ///< [edge]
  float top_ = 0;
};

class ConstantLadder final : public LevelLadder {
 public:
  explicit ConstantLadder(std::size_t triangles) : triangles_(triangles) {}
  float top() const override { return 1; }
  void at(const LadderPlace& place, std::vector<LogLevels>& levels) const override {
    std::uint8_t level = 0;
    while (level + 1u < level_count && 0.75f > place.threshold * static_cast<float>(1u << level)) ++level;
    levels.assign(triangles_, {level, level, level, level});
  }

 private:
  std::size_t triangles_;
};

}  // namespace

std::unique_ptr<LevelLadder> content_ladder(std::span<const std::array<HeightDeviation, level_count>> deviations,
                                            std::span<const float> shares, std::span<const std::uint8_t> finest,
                                            std::span<const std::uint32_t> edges, std::span<const std::uint8_t> limits,
                                            LevelGoal goal, std::uint64_t most_added) {
  return std::make_unique<ContentLadder>(deviations, shares, finest, edges, limits, goal, most_added);
}

std::unique_ptr<LevelLadder> edge_length_ladder(std::span<const HeightPart> parts) {
  return std::make_unique<EdgeLengthLadder>(parts);
}

std::unique_ptr<LevelLadder> constant_ladder(std::size_t triangles) {
  return std::make_unique<ConstantLadder>(triangles);
}

std::vector<std::uint32_t> shared_edges(std::span<const HeightPart> parts) {
  std::vector<glm::vec3> positions;
  for (const HeightPart& part : parts) positions.insert(positions.end(), part.positions.begin(), part.positions.end());
  std::vector<std::uint32_t> corners;
  std::uint32_t begin = 0;
  for (const HeightPart& part : parts) {
    for (const std::uint32_t index : part.indices.first(part.indices.size() / 3 * 3)) corners.push_back(begin + index);
    begin += static_cast<std::uint32_t>(part.positions.size());
  }
  return edges_at_places(corners, positions);
}

std::vector<std::uint8_t> edge_limits(std::span<const HeightPart> parts, std::span<const std::uint32_t> edges) {
  std::vector<std::uint8_t> limits(edges.size(), most_log_level);
  std::size_t begin = 0;
  for (const HeightPart& part : parts) {
    for (std::size_t edge = 0; edge < part.indices.size() / 3 * 3; ++edge) {
      const EdgeEnds ends = edge_ends(part.indices, edge);
      std::uint8_t& limit = limits[edges[begin + edge]];
      limit = std::min(limit, level_for_texels(part.places[ends.from], part.places[ends.to]));
    }
    begin += part.indices.size() / 3 * 3;
  }
  for (std::size_t edge = 0; edge < edges.size(); ++edge) limits[edge] = limits[edges[edge]];
  return limits;
}

}  // namespace foredraw

#include "tessellation_levels.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace foredraw {

namespace {

/// That a table can say.
constexpr std::uint64_t most_triangles = 0xffffffff;

using EqualDeviations = std::vector<std::array<HeightDeviation, level_count>>;

std::uint64_t count(std::span<const LogLevels> levels) {
  std::uint64_t sum = 0;
  for (const LogLevels& of : levels) sum += triangles_of(of);
  return sum;
}

/// Deviations of a mesh's levels. Only what changes is measured again.
class Measured {
 public:
  Measured(const HeightDeviations& deviations, const EqualDeviations& of_equal_levels)
      : deviations_(deviations), of_equal_levels_(of_equal_levels), levels_(deviations.triangles()) {
    for (const auto& of : of_equal_levels) values_.push_back(of[0]);
  }

  void set(std::span<const LogLevels> levels) {
    std::vector<std::uint32_t> which;
    std::vector<WholeLevels> whole;
    for (std::uint32_t t = 0; t < levels.size(); ++t) {
      if (levels[t] == levels_[t]) continue;
      const LogLevels& of = levels_[t] = levels[t];
      const bool are_equal = of[0] == of[1] && of[1] == of[2] && of[2] == of[3];
      if (are_equal && of[0] <= deviations_.finest()[t]) {
        values_[t] = of_equal_levels_[t][of[0]];
        continue;
      }
      which.push_back(t);
      whole.emplace_back();
      for (std::size_t i = 0; i < 4; ++i) whole.back()[i] = static_cast<std::uint8_t>(1u << of[i]);
    }
    const std::vector<HeightDeviation> measured = deviations_.of(which, whole);
    for (std::size_t i = 0; i < which.size(); ++i) values_[which[i]] = measured[i];
  }

  /// Of the triangles from `begin` up to `end`.
  MeshTessellation of(std::size_t begin, std::size_t end) const {
    double squared = 0, share = 0;
    MeshTessellation sum;
    for (std::size_t t = begin; t < end; ++t) {
      squared += values_[t].squared, share += deviations_.shares()[t];
      sum.largest = std::max(sum.largest, deviations_.unit() * values_[t].largest);
      sum.triangles += triangles_of(levels_[t]);
    }
    sum.rms = share > 0 ? deviations_.unit() * std::sqrt(squared / share) : 0;
    return sum;
  }
  MeshTessellation whole() const { return of(0, values_.size()); }
  double error(LevelGoal goal) const { return goal == LevelGoal::rms ? whole().rms : whole().largest; }
  float largest(std::size_t triangle) const { return values_[triangle].largest; }

 private:
  const HeightDeviations& deviations_;
  const EqualDeviations& of_equal_levels_;
  std::vector<LogLevels> levels_;
  std::vector<HeightDeviation> values_;
};

/// The finest levels that the ladder has for so many triangles.
void within(const LevelLadder& ladder, std::uint64_t most, std::vector<LogLevels>& levels) {
  const auto holds = [&](const LadderPlace& place) {
    ladder.at(place, levels);
    return count(levels) <= most;
  };
  LadderPlace place;
  if (holds(place)) return;
  // Floats that are not negative are in the sequence of their bits.
  std::uint32_t low = 0, high = std::bit_cast<std::uint32_t>(ladder.top());
  while (high - low > 1) {
    const std::uint32_t middle = low + (high - low) / 2;
    (holds({std::bit_cast<float>(middle), 0}) ? high : low) = middle;
  }
  place.threshold = std::bit_cast<float>(high);
  std::uint32_t with = 0, without = static_cast<std::uint32_t>(levels.size()) + 1;
  while (without - with > 1) {
    const std::uint32_t middle = with + (without - with) / 2;
    (holds({place.threshold, middle}) ? with : without) = middle;
  }
  place.ties = with;
  ladder.at(place, levels);
}

/// The coarsest levels of the ladder that do not exceed the error, to some thousandths of the threshold; the finest
/// ones where none reaches it.
void within_error(const LevelLadder& ladder, double most, LevelGoal goal, Measured& measured,
                  std::vector<LogLevels>& levels) {
  constexpr std::uint32_t close = 1u << 15;  // of 2^23 between a float and its double
  const auto holds = [&](float threshold) {
    ladder.at({threshold, 0}, levels);
    measured.set(levels);
    return measured.error(goal) <= most;
  };
  if (holds(ladder.top())) return;
  std::uint32_t low = 0, high = std::bit_cast<std::uint32_t>(ladder.top());
  while (high - low > close) {
    const std::uint32_t middle = low + (high - low) / 2;
    (holds(std::bit_cast<float>(middle)) ? low : high) = middle;
  }
  ladder.at({std::bit_cast<float>(low), 0}, levels);
}

/// Makes triangles finer until none deviates farther, as far as the map goes.
void refine(double most, std::span<const std::uint32_t> edges, std::span<const std::uint8_t> limits,
            const HeightDeviations& deviations, Measured& measured, std::vector<LogLevels>& levels) {
  const auto outer = [&](std::size_t edge) -> std::uint8_t& { return levels[edge / 3][edge % 3]; };
  for (bool is_finer = true; is_finer;) {
    is_finer = false;
    measured.set(levels);
    for (std::size_t t = 0; t < levels.size(); ++t) {
      if (deviations.unit() * measured.largest(t) <= most || levels[t][3] >= deviations.finest()[t]) continue;
      ++levels[t][3];
      is_finer = true;
      for (std::size_t edge = 3 * t; edge < 3 * t + 3; ++edge) {
        std::uint8_t& level = outer(edges[edge]);
        level = std::max(level, std::min(levels[t][3], limits[edge]));
      }
    }
    for (std::size_t edge = 0; edge < edges.size(); ++edge) outer(edge) = outer(edges[edge]);
  }
}

}  // namespace

std::uint32_t triangles_of(const LogLevels& levels) {
  if (levels == LogLevels{}) return 1;
  const std::uint32_t within = (1u << std::max<std::uint8_t>(levels[3], 1)) - 2;
  return (1u << levels[0]) + (1u << levels[1]) + (1u << levels[2]) + 3 * within + 3 * within * within / 2;
}

LogLevels scaled(const LogLevels& levels, std::uint32_t scale) {
  LogLevels result;
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = static_cast<std::uint8_t>(levels[i] - std::min<std::uint32_t>(levels[i], scale));
  return result;
}

ChosenLevels tessellation_levels(std::span<const HeightPart> parts, LevelMethod method,
                                 const TessellationLimits& limits, const Executor& executor) {
  const std::vector<std::uint32_t> edges = shared_edges(parts);
  const std::vector<std::uint8_t> edge_most = edge_limits(parts, edges);
  const HeightDeviations deviations(parts, executor);
  const EqualDeviations of_equal_levels = deviations.of_equal_levels();
  Measured measured(deviations, of_equal_levels);
  ChosenLevels result;
  result.plain = measured.whole();
  const std::uint64_t most = std::min(limits.triangles.value_or(most_triangles), most_triangles);
  const std::uint64_t most_added = most - std::min<std::uint64_t>(most, deviations.triangles());
  const std::unique_ptr<LevelLadder> ladder =
      method == LevelMethod::content ? content_ladder(of_equal_levels, deviations.shares(), deviations.finest(), edges,
                                                      edge_most, limits.goal, most_added)
      : method == LevelMethod::edge_length ? edge_length_ladder(parts)
                                           : constant_ladder(deviations.triangles());
  std::vector<LogLevels>& levels = result.levels;
  levels.resize(deviations.triangles());
  if (limits.error && method == LevelMethod::content && limits.goal == LevelGoal::largest) {
    const double error = deviations.unit() > 0 ? *limits.error / deviations.unit() : 0;
    ladder->at({static_cast<float>(error), 0}, levels);
    refine(*limits.error, edges, edge_most, deviations, measured, levels);
  } else if (limits.error) {
    within_error(*ladder, *limits.error, limits.goal, measured, levels);
  }
  if (!limits.error || count(levels) > most) within(*ladder, most, levels);

  measured.set(levels);
  result.chosen = measured.whole();
  std::vector<std::uint8_t> finest(parts.size(), 0);
  for (std::size_t part = 0; part < parts.size(); ++part) {
    for (std::size_t t = deviations.first_triangle(part); t < deviations.first_triangle(part + 1); ++t)
      finest[part] = std::max(finest[part], std::ranges::max(levels[t]));
  }
  result.scales.resize(parts.size());
  std::vector<LogLevels> coarser = levels;
  for (std::uint32_t s = 0; s < level_count; ++s) {
    for (std::size_t t = 0; t < levels.size(); ++t) coarser[t] = scaled(levels[t], s);
    measured.set(coarser);
    for (std::size_t part = 0; part < parts.size(); ++part) {
      if (s > finest[part]) continue;
      const MeshTessellation of = measured.of(deviations.first_triangle(part), deviations.first_triangle(part + 1));
      TessellationScale scale{static_cast<std::uint32_t>(of.triangles), static_cast<float>(of.rms),
                              static_cast<float>(of.largest)};
      if (s > 0) {
        scale.rms = std::max(scale.rms, result.scales[part].back().rms);
        scale.largest = std::max(scale.largest, result.scales[part].back().largest);
      }
      result.scales[part].push_back(scale);
    }
  }
  return result;
}

}  // namespace foredraw

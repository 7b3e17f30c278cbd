#include "height_deviations.h"

#include "pattern_samples.h"

#include <foredraw/displaced/displaced_mesh.h>
#include <foredraw/displaced/height_bits.h>
#include <foredraw/geometry/triangle_area.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace foredraw {

namespace {

constexpr std::uint32_t least_sampling = 2;  // 16 samples
constexpr std::size_t chunk = 256;           // triangles of a task
constexpr std::size_t block = 1 << 16;       // triangles that are sorted at once

/// What a tessellator shows of any triangle at some levels, and where its samples lie in that.
struct Shown {
  std::vector<TessellationPoint> points;
  std::vector<LocatedSample> samples;

  Shown(const WholeLevels& levels, std::uint32_t sampling) {
    TessellationLevels wanted;
    for (std::size_t e = 0; e < 3; ++e) wanted.outer[e] = levels[e];
    wanted.inner = levels[3];
    TessellationPattern pattern = tessellation_pattern(wanted, TessellationSpacing::equal);
    samples = located_samples(pattern, 1u << sampling);
    points = std::move(pattern.points);
  }
};

WholeLevels equal_levels(std::uint32_t log2) {
  const auto level = static_cast<std::uint8_t>(1u << log2);
  return {level, level, level, level};
}

double area_of(const HeightPart& part, std::size_t triangle) {
  const auto corner = [&](std::size_t c) { return glm::dvec3(part.positions[part.indices[3 * triangle + c]]); };
  const double area = triangle_area(corner(0), corner(1), corner(2));
  return std::isfinite(area) ? area : 0;
}

std::uint8_t finest_of(const HeightPart& part, std::size_t triangle) {
  std::uint8_t level = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    level = std::max(level, level_for_texels(part.places[part.indices[3 * triangle + c]],
                                             part.places[part.indices[3 * triangle + (c + 1) % 3]]));
  }
  return level;
}

}  // namespace

/// Those of one triangle, as many bits as the shaders read.
class HeightDeviations::Heights {
 public:
  Heights(const HeightPart& part, std::size_t triangle, double unit, float share) : map_(&part.map), share_(share) {
    for (std::size_t c = 0; c < 3; ++c) {
      const auto& place = part.places[part.indices[3 * triangle + c]];
      x_[c] = place[0], y_[c] = place[1];
    }
    constexpr double range = (1u << height_bits) - 1;
    scale_ = unit > 0 && std::isfinite(part.factor) ? std::abs(double{part.factor}) / unit / range : 0;
  }

  void at(std::span<const TessellationPoint> points, std::vector<float>& heights) const {
    heights.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto weights = points[i].weights();
      heights[i] = static_cast<float>(foredraw_displaced_height(
          map_, foredraw_height_between(x_, weights.data()), foredraw_height_between(y_, weights.data()), height_bits));
    }
  }

  /// `sampled`: at the samples; `shown`: at the pattern's points.
  HeightDeviation deviation(const Shown& pattern, std::span<const float> sampled, std::span<const float> shown) const {
    double squared = 0;  // of whole heights
    float largest = 0;
    for (std::size_t i = 0; i < sampled.size(); ++i) {
      const auto& [corners, weights] = pattern.samples[i];
      const float linear =
          weights[0] * shown[corners[0]] + weights[1] * shown[corners[1]] + weights[2] * shown[corners[2]];
      const float deviation = std::abs(sampled[i] - linear);
      squared += double{deviation} * deviation;
      largest = std::max(largest, deviation);
    }
    const double mean = squared / static_cast<double>(sampled.size());
    return {static_cast<float>(mean * scale_ * scale_ * share_), static_cast<float>(largest * scale_)};
  }

 private:
  const foredraw_height_map* map_;
  std::int32_t x_[3], y_[3];
  double scale_ = 0;
  float share_ = 0;
};

HeightDeviations::HeightDeviations(std::span<const HeightPart> parts, const Executor& executor)
    : parts_(parts.begin(), parts.end()), executor_(executor) {
  begins_.push_back(0);
  for (const HeightPart& part : parts_) {
    begins_.push_back(begins_.back() + part.indices.size() / 3);
    if (std::isfinite(part.factor)) unit_ = std::max(unit_, std::abs(double{part.factor}));
  }
  double whole = 0;
  for (const HeightPart& part : parts_) {
    for (std::size_t t = 0; t < part.indices.size() / 3; ++t) {
      whole += area_of(part, t);
      finest_.push_back(finest_of(part, t));
    }
  }
  shares_.reserve(finest_.size());
  for (const HeightPart& part : parts_) {
    for (std::size_t t = 0; t < part.indices.size() / 3; ++t)
      shares_.push_back(whole > 0 ? static_cast<float>(area_of(part, t) / whole) : 0);
  }
}

HeightDeviations::Heights HeightDeviations::heights_of(std::size_t triangle) const {
  const auto part = static_cast<std::size_t>(std::ranges::upper_bound(begins_, triangle) - begins_.begin()) - 1;
  return {parts_[part], triangle - begins_[part], unit_, shares_[triangle]};
}

std::uint32_t HeightDeviations::sampling_of(std::size_t triangle) const {
  return std::max<std::uint32_t>(finest_[triangle], least_sampling);
}

std::vector<std::array<HeightDeviation, level_count>> HeightDeviations::of_equal_levels() const {
  std::vector<std::array<HeightDeviation, level_count>> result(triangles());
  std::map<std::pair<std::uint32_t, std::uint32_t>, Shown> shown;  // by sampling and level
  std::array<std::vector<TessellationPoint>, level_count> samples;
  for (const std::uint32_t finest : finest_) {
    const std::uint32_t sampling = std::max(finest, least_sampling);
    if (samples[sampling].empty()) samples[sampling] = sample_points(1u << sampling);
    for (std::uint32_t level = finest + 1; level-- > 0;) {
      const bool is_new = !shown.contains({sampling, level});
      if (!is_new) break;  // and so are those below
      shown.emplace(std::pair{sampling, level}, Shown(equal_levels(level), sampling));
    }
  }
  executor_.for_each((triangles() + chunk - 1) / chunk, [&](std::size_t task) {
    std::vector<float> sampled, points;
    for (std::size_t t = task * chunk; t < std::min(triangles(), (task + 1) * chunk); ++t) {
      const Heights heights = heights_of(t);
      heights.at(samples[sampling_of(t)], sampled);
      for (std::uint32_t level = 0; level <= finest_[t]; ++level) {
        const Shown& pattern = shown.at({sampling_of(t), level});
        heights.at(pattern.points, points);
        result[t][level] = heights.deviation(pattern, sampled, points);
      }
    }
  });
  return result;
}

std::vector<HeightDeviation> HeightDeviations::of(std::span<const std::uint32_t> which,
                                                  std::span<const WholeLevels> levels) const {
  std::vector<HeightDeviation> result(which.size());
  std::vector<std::uint32_t> order;
  const auto key = [&](std::uint32_t i) { return std::pair{sampling_of(which[i]), levels[i]}; };
  for (std::size_t begin = 0; begin < which.size(); begin += block) {
    // Triangles with the same pattern together, in tasks of their own.
    order.resize(std::min(block, which.size() - begin));
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::uint32_t>(begin + i);
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
      return std::pair{key(a), a} < std::pair{key(b), b};
    });
    std::vector<std::size_t> tasks;
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (i == 0 || key(order[i]) != key(order[i - 1]) || i - tasks.back() == chunk) tasks.push_back(i);
    }
    tasks.push_back(order.size());
    executor_.for_each(tasks.size() - 1, [&](std::size_t task) {
      const auto [sampling, at] = key(order[tasks[task]]);
      const Shown pattern(at, sampling);
      const std::vector<TessellationPoint> samples = sample_points(1u << sampling);
      std::vector<float> sampled, points;
      for (std::size_t i = tasks[task]; i < tasks[task + 1]; ++i) {
        const Heights heights = heights_of(which[order[i]]);
        heights.at(samples, sampled);
        heights.at(pattern.points, points);
        result[order[i]] = heights.deviation(pattern, sampled, points);
      }
    });
  }
  return result;
}

std::uint8_t level_for_texels(const std::array<std::int32_t, 2>& from, const std::array<std::int32_t, 2>& to) {
  const double u = double(from[0]) - to[0], v = double(from[1]) - to[1];
  const double parts = std::sqrt(u * u + v * v) / (256 * usual_texels_per_part);
  std::uint8_t level = 0;
  while (level + 1u < level_count && 2u << level <= parts) ++level;
  return level;
}

}  // namespace foredraw

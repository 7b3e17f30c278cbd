#include "displacement_seams.h"

#include "averaged_seams.h"
#include "equal_heights.h"
#include "equal_integers.h"
#include "is_cancelled.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace foredraw {

namespace {

using processors::displacement_seams::EqualityRow;
using processors::displacement_seams::IntegerHeights;

constexpr double most_height = 65535;
constexpr int most_passes = 100, most_halvings = 6;

/// Points inside of edges are released, factor by factor, until all others are equal.
class Settling {
 public:
  Settling(const SeamEdges& seams, const SeamPoints& points, IntegerHeights& heights, const std::atomic<bool>* cancel)
      : seams_(seams), points_(points), heights_(heights), cancel_(cancel), factors_(points.factors) {}

  void run() {
    heights_.settle(most_passes, cancel_);
    for (int round = 0; round < most_halvings && heights_.unequal_count() > 0; ++round) {
      halve_factors();
      heights_.settle(most_passes, cancel_);
    }
  }

 private:
  /// Of edges with a point inside that is not equal.
  void halve_factors() {
    std::vector<bool> is_halved(factors_.size(), false);
    for (std::size_t p = seams_.corners.size(); p < points_.points.size(); ++p) {
      if (heights_.is_unequal(p)) is_halved[points_.points[p].edge] = true;
    }
    for (std::size_t p = seams_.corners.size(); p < points_.points.size(); ++p) {
      const SeamPoint& point = points_.points[p];
      if (!is_halved[point.edge]) continue;
      const std::uint32_t steps = 2 * (points_.factors[point.edge] / factors_[point.edge]);
      if (point.step % steps != 0) heights_.release(p);
    }
    for (std::size_t e = 0; e < factors_.size(); ++e) {
      if (is_halved[e]) factors_[e] /= 2;
    }
  }

  const SeamEdges& seams_;
  const SeamPoints& points_;
  IntegerHeights& heights_;
  const std::atomic<bool>* cancel_;
  std::vector<std::uint32_t> factors_;  ///< [edge]
};

std::uint16_t rounded(double height) {
  return static_cast<std::uint16_t>(std::floor(std::clamp(height, 0.0, most_height) + 0.5));
}

/// Into the range between a new 0 and 1.
std::uint16_t scaled(double height, double at_zero, double at_one) {
  return rounded((height - at_zero) * (most_height / (at_one - at_zero)));
}

/// New heights of texels that the seams lie in. If the range is another one, all texels are scaled.
struct Solution {
  double at_zero = 0, at_one = most_height;
  std::vector<std::uint32_t> seam_texels;  ///< ascending
  std::vector<std::uint16_t> values;       ///< of these

  bool is_scaled() const { return at_zero != 0 || at_one != most_height; }
  std::uint16_t scaled(double height) const { return foredraw::scaled(height, at_zero, at_one); }
};

/// Of the texels that the seams lie in, nearly equal on both sides; and which texels these are.
std::vector<double> nearly_equal(const SeamEdges& seams, const SeamPoints& points, const foredraw_height_map& map,
                                 const std::atomic<bool>* cancel, std::vector<std::uint32_t>& seam_texels) {
  std::vector<EqualityRow> at_points = processors::displacement_seams::rows_of_points(points, map);
  std::vector<EqualityRow> along;
  if (map.is_nearest == 0) {
    const std::vector<EqualityRow> exact =
        processors::displacement_seams::rows_of_exact_points(seams, points.factors, map);
    at_points.insert(at_points.end(), exact.begin(), exact.end());
    along = processors::displacement_seams::rows_along_seams(seams, map);
  }
  seam_texels = processors::displacement_seams::numbered(along, at_points);
  std::vector<double> heights;
  heights.reserve(seam_texels.size());
  for (const std::uint32_t texel : seam_texels) heights.push_back(map.texels[texel]);
  return processors::displacement_seams::equal_heights(std::move(heights), std::move(along), std::move(at_points),
                                                       {.cancel = cancel});
}

Solution solved(const SeamEdges& seams, const SeamPoints& points, const foredraw_height_map& map,
                const DisplacementSeamsOptions& options) {
  Solution solution;
  std::vector<std::uint16_t> values;
  {
    const std::vector<double> heights = nearly_equal(seams, points, map, options.cancel, solution.seam_texels);
    for (const double height : heights) {
      solution.at_zero = std::min(solution.at_zero, height);
      solution.at_one = std::max(solution.at_one, height);
    }
    values.reserve(heights.size());
    for (const double height : heights) values.push_back(solution.scaled(height));
  }
  IntegerHeights integers(points, map, solution.seam_texels, std::move(values), options.bits);
  Settling(seams, points, integers, options.cancel).run();
  solution.values = integers.values();
  return solution;
}

/// What it changes beside the scale, ascending.
std::vector<std::uint32_t> put_solution(const Solution& solution, std::vector<std::uint16_t>& texels) {
  if (solution.is_scaled()) {
    for (std::uint16_t& texel : texels) texel = solution.scaled(texel);
  }
  std::vector<std::uint32_t> changed;
  for (std::size_t i = 0; i < solution.seam_texels.size(); ++i) {
    std::uint16_t& texel = texels[solution.seam_texels[i]];
    if (texel != solution.values[i]) changed.push_back(solution.seam_texels[i]);
    texel = solution.values[i];
  }
  return changed;
}

std::size_t count(const std::vector<bool>& is_unequal) {
  return static_cast<std::size_t>(std::ranges::count(is_unequal, true));
}

/// Solutions as long as each leaves fewer points unequal than the one before.
void solve(const SeamEdges& seams, const SeamPoints& points, foredraw_height_map map,
           const DisplacementSeamsOptions& options, SeamRepair& result) {
  std::vector<std::uint16_t> texels(map.texels, map.texels + std::size_t{map.width} * map.height);
  map.texels = texels.data();
  while (result.unequal_after > 0) {
    const Solution solution = solved(seams, points, map, options);
    if (processors::displacement_seams::is_cancelled(options.cancel)) break;
    std::vector<std::uint16_t> before;  // all texels where all are scaled
    if (solution.is_scaled()) before = texels;
    for (const std::uint32_t texel : solution.seam_texels)
      if (!solution.is_scaled()) before.push_back(texels[texel]);
    std::vector<std::uint32_t> changed = put_solution(solution, texels);
    const std::vector<bool> is_unequal = unequal_points(points, map, options.bits);
    if (count(is_unequal) >= result.unequal_after) {
      for (std::size_t i = 0; i < before.size(); ++i)
        texels[solution.is_scaled() ? i : solution.seam_texels[i]] = before[i];
      break;
    }
    result.is_new = true;
    result.unequal_after = count(is_unequal);
    result.factors = exact_factors(seams, points, is_unequal);
    if (solution.is_scaled()) result.scales.push_back({solution.at_zero, solution.at_one});
    const double from = result.at_zero, range = (result.at_one - result.at_zero) / most_height;
    result.at_zero = from + range * solution.at_zero;
    result.at_one = from + range * solution.at_one;
    std::vector<std::uint32_t> all;
    std::ranges::set_union(result.seam_texels, changed, std::back_inserter(all));
    result.seam_texels = std::move(all);
  }
  for (const std::uint32_t texel : result.seam_texels) result.values.push_back(texels[texel]);
}

void average(const SeamEdges& seams, const SeamPoints& points, foredraw_height_map map,
             const DisplacementSeamsOptions& options, SeamRepair& result) {
  processors::displacement_seams::AveragedMap averaged =
      processors::displacement_seams::averaged_seams(seams, map, options.iterations, options.cancel);
  if (averaged.changed.empty() || processors::displacement_seams::is_cancelled(options.cancel)) return;
  map.texels = averaged.texels.data();
  const std::vector<bool> is_unequal = unequal_points(points, map, options.bits);
  result.is_new = true;
  result.unequal_after = count(is_unequal);
  result.factors = exact_factors(seams, points, is_unequal);
  result.seam_texels = std::move(averaged.changed);
  for (const std::uint32_t texel : result.seam_texels) result.values.push_back(averaged.texels[texel]);
}

}  // namespace

SeamRepair seam_repair(const SeamEdges& seams, const foredraw_height_map& map,
                       const DisplacementSeamsOptions& options) {
  SeamRepair result;
  result.rule = seam_factors(seams, {map.width, map.height});
  const SeamPoints points = seam_points(seams, result.rule, map);
  const std::vector<bool> is_unequal = unequal_points(points, map, options.bits);
  result.points = points.points.size();
  result.unequal_before = result.unequal_after = count(is_unequal);
  result.factors = exact_factors(seams, points, is_unequal);
  if (result.unequal_before == 0) return result;
  if (options.method == SeamMethod::exact) {
    solve(seams, points, map, options, result);
  } else {
    average(seams, points, map, options, result);
  }
  return result;
}

void put(const SeamRepair& repair, std::span<std::uint16_t> texels) {
  for (const auto& [at_zero, at_one] : repair.scales) {
    for (std::uint16_t& texel : texels) texel = scaled(texel, at_zero, at_one);
  }
  for (std::size_t i = 0; i < repair.seam_texels.size(); ++i) texels[repair.seam_texels[i]] = repair.values[i];
}

RepairedMap displacement_seams(const SeamEdges& seams, const foredraw_height_map& map,
                               const DisplacementSeamsOptions& options) {
  RepairedMap result{seam_repair(seams, map, options), {}};
  if (!result.is_new) return result;
  result.texels.assign(map.texels, map.texels + std::size_t{map.width} * map.height);
  put(result, result.texels);
  return result;
}

}  // namespace foredraw

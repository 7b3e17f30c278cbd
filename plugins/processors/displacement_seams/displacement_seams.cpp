#include "displacement_seams.h"

#include "averaged_seams.h"
#include "equal_heights.h"
#include "equal_integers.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace foredraw {

namespace {

using seams::EqualityRow;
using seams::IntegerHeights;

constexpr double most_height = 65535;
constexpr int most_passes = 100, most_halvings = 6;

/// Points inside of edges are released, factor by factor, until all others are equal.
class Settling {
 public:
  Settling(const SeamEdges& seams, const SeamPoints& points, IntegerHeights& heights)
      : seams_(seams), points_(points), heights_(heights), factors_(points.factors) {}

  void run() {
    heights_.settle(most_passes);
    for (int round = 0; round < most_halvings && heights_.unequal_count() > 0; ++round) {
      halve_factors();
      heights_.settle(most_passes);
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
  std::vector<std::uint32_t> factors_;  ///< [edge]
};

struct Solution {
  std::vector<std::uint16_t> texels;
  double at_zero = 0, at_one = most_height;
  std::vector<std::uint32_t> seam_texels;
};

std::uint16_t rounded(double height) {
  return static_cast<std::uint16_t>(std::floor(std::clamp(height, 0.0, most_height) + 0.5));
}

Solution solved(const SeamEdges& seams, const SeamPoints& points, const foredraw_height_map& map, std::uint32_t bits) {
  Solution solution;
  std::vector<EqualityRow> at_points = seams::rows_of_points(points, map);
  std::vector<EqualityRow> along;
  if (map.is_nearest == 0) {
    const std::vector<EqualityRow> exact = seams::rows_of_exact_points(seams, points.factors, map);
    at_points.insert(at_points.end(), exact.begin(), exact.end());
    along = seams::rows_along_seams(seams, map);
  }
  solution.seam_texels = seams::numbered(along, at_points);

  std::vector<double> heights;
  for (const std::uint32_t texel : solution.seam_texels) heights.push_back(map.texels[texel]);
  heights = seams::equal_heights(heights, along, at_points);
  for (const double height : heights) {
    solution.at_zero = std::min(solution.at_zero, height);
    solution.at_one = std::max(solution.at_one, height);
  }
  const bool is_scaled = solution.at_zero < 0 || solution.at_one > most_height;
  const double scale = most_height / (solution.at_one - solution.at_zero);
  const auto scaled = [&](double height) { return rounded((height - solution.at_zero) * scale); };
  solution.texels.assign(map.texels, map.texels + std::size_t{map.width} * map.height);
  if (is_scaled) {
    for (std::uint16_t& texel : solution.texels) texel = scaled(texel);
  }
  std::vector<std::uint16_t> values;
  for (const double height : heights) values.push_back(is_scaled ? scaled(height) : rounded(height));

  IntegerHeights integers(points, map, solution.seam_texels, std::move(values), bits);
  Settling(seams, points, integers).run();
  std::vector<std::uint32_t> changed;
  for (std::size_t i = 0; i < solution.seam_texels.size(); ++i) {
    std::uint16_t& texel = solution.texels[solution.seam_texels[i]];
    if (texel != integers.values()[i]) changed.push_back(solution.seam_texels[i]);
    texel = integers.values()[i];
  }
  solution.seam_texels = std::move(changed);
  return solution;
}

std::size_t count(const std::vector<bool>& is_unequal) {
  return static_cast<std::size_t>(std::ranges::count(is_unequal, true));
}

/// Solutions as long as each leaves fewer points unequal than the one before.
void solve(const SeamEdges& seams, const SeamPoints& points, foredraw_height_map map, std::uint32_t bits,
           RepairedMap& result) {
  while (result.unequal_after > 0) {
    Solution solution = solved(seams, points, map, bits);
    map.texels = solution.texels.data();
    const std::vector<bool> is_unequal = unequal_points(points, map, bits);
    if (count(is_unequal) >= result.unequal_after) return;
    result.unequal_after = count(is_unequal);
    result.factors = exact_factors(seams, points, is_unequal);
    const double from = result.at_zero, range = (result.at_one - result.at_zero) / most_height;
    result.at_zero = from + range * solution.at_zero;
    result.at_one = from + range * solution.at_one;
    result.texels = std::move(solution.texels);
    std::vector<std::uint32_t> changed;
    std::ranges::set_union(result.seam_texels, solution.seam_texels, std::back_inserter(changed));
    result.seam_texels = std::move(changed);
    map.texels = result.texels.data();
  }
}

}  // namespace

RepairedMap displacement_seams(const SeamEdges& seams, const foredraw_height_map& map,
                               const DisplacementSeamsOptions& options) {
  RepairedMap result;
  result.rule = seam_factors(seams, {map.width, map.height});
  const SeamPoints points = seam_points(seams, result.rule, map);
  const std::vector<bool> is_unequal = unequal_points(points, map, options.bits);
  result.points = points.points.size();
  result.unequal_before = result.unequal_after = count(is_unequal);
  result.factors = exact_factors(seams, points, is_unequal);
  if (result.unequal_before == 0) return result;
  if (options.method == SeamMethod::exact) {
    solve(seams, points, map, options.bits, result);
    return result;
  }
  seams::AveragedMap averaged = seams::averaged_seams(seams, map, options.iterations);
  if (averaged.changed.empty()) return result;
  result.texels = std::move(averaged.texels);
  result.seam_texels = std::move(averaged.changed);
  foredraw_height_map now = map;
  now.texels = result.texels.data();
  const std::vector<bool> is_unequal_now = unequal_points(points, now, options.bits);
  result.unequal_after = count(is_unequal_now);
  result.factors = exact_factors(seams, points, is_unequal_now);
  return result;
}

}  // namespace foredraw

#include <foredraw/displaced/edge_division.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace foredraw {

namespace {

constexpr std::uint32_t half = weight_one / 2;

/// The nearest whole number, ties to even ones, whatever the processor's mode of rounding.
std::uint32_t nearest(double value) {
  const double below = std::floor(value);
  const auto whole = static_cast<std::uint32_t>(below);
  const double rest = value - below;
  return rest > 0.5 || (rest == 0.5 && whole % 2 == 1) ? whole + 1 : whole;
}

/// The length of one of `parts` equal parts of an edge, rounded.
std::uint32_t part_of_edge(std::uint32_t parts) { return (weight_one + parts / 2) / parts; }

}  // namespace

float effective_level(float level, TessellationSpacing spacing) {
  if (!(level > 0)) return 0;
  const float least = spacing == TessellationSpacing::fractional_even ? 2.0f : 1.0f;
  const float most = spacing == TessellationSpacing::fractional_odd ? 63.0f : 64.0f;
  const float clamped = std::clamp(level, least, most);
  if (spacing == TessellationSpacing::equal) return std::ceil(clamped);
  return static_cast<float>(nearest(double{clamped} * weight_one)) / weight_one;
}

EdgeDivision::EdgeDivision(float level, TessellationSpacing spacing) {
  const auto fixed = static_cast<std::uint32_t>(double{level} * weight_one);  // exact
  is_odd_ = spacing == TessellationSpacing::fractional_odd ||
            (spacing == TessellationSpacing::equal && (fixed / weight_one) % 2 == 1);
  // An odd edge has the middle of a part in its middle: half a part more belongs to each half.
  const std::uint32_t points = (fixed + 1) / 2 + (is_odd_ ? half : 0);
  coarse_ = points / weight_one;
  fraction_ = points % weight_one;
  fine_ = coarse_ + (fraction_ > 0 ? 1 : 0);
  const std::uint32_t odd = is_odd_ ? 1 : 0;
  coarse_part_ = part_of_edge(2 * coarse_ - odd);
  fine_part_ = part_of_edge(2 * fine_ - odd);
  if (fraction_ == 0) return;
  // Parts are split from the corner on, every second one; once all are split, it begins anew.
  const std::uint32_t whole_parts = coarse_ - odd;
  split_ = whole_parts == 0 ? 0 : 2 * (whole_parts - std::bit_floor(whole_parts)) + 1;
}

std::uint32_t EdgeDivision::place(std::uint32_t point) const {
  if (2 * point == parts()) return half;
  if (2 * point > parts()) return weight_one - place(parts() - point);
  const std::uint32_t before = point > split_ ? point - 1 : point;
  const std::uint32_t coarse = before * coarse_part_, fine = point * fine_part_;  // at most half an edge
  return (coarse * (weight_one - fraction_) + fine * fraction_ + half) / weight_one;
}

}  // namespace foredraw

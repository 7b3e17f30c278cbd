#include "wire_run.h"

#include <algorithm>
#include <deque>
#include <numbers>

namespace foredraw::processors::wire_radius {

namespace {

/// Of the sections of a run, so that half of them are below.
template <class Value>
double median(const Chain& chain, const WireRun& run, Value value) {
  std::vector<double> values;
  for (std::size_t i = run.first; i <= run.last; ++i) values.push_back(value(chain.sections[i].section));
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace

std::optional<WireRun> longest_run(const Chain& chain, double taper) {
  const std::vector<ChainSection>& all = chain.sections;
  if (all.size() < 2) return std::nullopt;
  const auto half = [&](std::size_t i) { return all[i].section.half_width(); };
  // Two queues hold the candidates for the least and the greatest of the sections from `first` to `last`.
  std::deque<std::size_t> least, greatest;
  WireRun best;
  double longest = 0;
  for (std::size_t first = 0, last = 0; last < all.size(); ++last) {
    while (!least.empty() && half(least.back()) >= half(last)) least.pop_back();
    while (!greatest.empty() && half(greatest.back()) <= half(last)) greatest.pop_back();
    least.push_back(last);
    greatest.push_back(last);
    while (half(greatest.front()) > taper * half(least.front())) {
      if (least.front() == first) least.pop_front();
      if (greatest.front() == first) greatest.pop_front();
      ++first;
    }
    const double length = all[last].along - all[first].along;
    if (length > longest) {
      longest = length;
      best.first = first;
      best.last = last;
    }
  }
  if (!(longest > 0)) return std::nullopt;
  best.closed = chain.closed && best.first == 0 && best.last + 1 == all.size();
  best.length = best.closed ? chain.length() : longest;
  double flat = 0;
  for (std::size_t i = best.first; i < best.last; ++i) {
    const double step = all[i + 1].along - all[i].along;
    best.half_width += (half(i) + half(i + 1)) / 2 * step / longest;
    best.mean_width += (all[i].section.mean_half_width() + all[i + 1].section.mean_half_width()) * step / longest;
    if (all[i].section.is_flat()) flat += step;
  }
  best.kind = 2 * flat > longest ? WireKind::ribbon : WireKind::tube;
  return best;
}

std::optional<WireRefusal> shape_refusal(const Chain& chain, const WireRun& run, const WireOptions& options) {
  if (run.length < options.slender * run.mean_width) return WireRefusal::stout;
  if (run.kind == WireKind::ribbon && !options.ribbons) return WireRefusal::ribbon;
  if (chain.sections[run.first].section.closed) {
    // Three quarters of what the flattest box has that will do, at least.
    const double side = options.aspect;
    const double least_roundness = 0.75 * std::numbers::pi * side / ((1 + side) * (1 + side));
    const auto aspect = [](const Section& s) { return s.least > 0 ? s.greatest / s.least : 1e300; };
    if (median(chain, run, aspect) > options.aspect ||
        median(chain, run, [](const Section& s) { return s.roundness; }) < least_roundness) {
      return WireRefusal::flat;
    }
  }
  if (run.length < options.least_length) return WireRefusal::small;
  return std::nullopt;
}

}  // namespace foredraw::processors::wire_radius

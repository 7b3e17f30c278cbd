#include "equal_integers.h"

#include "is_cancelled.h"

#include <algorithm>
#include <array>

namespace foredraw::processors::displacement_seams {

constexpr std::uint32_t worth_of_corner = 16;

IntegerHeights::IntegerHeights(const SeamPoints& points, const foredraw_height_map& map,
                               std::span<const std::uint32_t> texels, std::vector<std::uint16_t> values,
                               std::uint32_t bits)
    : shift_(32 - bits),
      values_(std::move(values)),
      touch_starts_(texels.size() + 1, 0),
      is_unequal_(points.points.size(), false),
      is_released_(points.points.size(), false) {
  starts_.push_back(0);
  for (std::uint32_t p = 0; p < points.points.size(); ++p) {
    for (const glm::ivec2 place : points.places_of(points.points[p])) {
      const foredraw_height_footprint at = foredraw_height_footprint_at(&map, place.x, place.y);
      Footprint footprint{.point = p};
      for (std::uint32_t i = 0; i < 4; ++i) {
        if (at.weight[i] == 0) continue;
        const std::uint32_t place_in_map = at.row[i / 2] * map.width + at.column[i % 2];
        const auto texel = static_cast<std::uint32_t>(std::ranges::lower_bound(texels, place_in_map) - texels.begin());
        std::uint32_t k = 0;
        while (k < footprint.count && footprint.texels[k] != texel) ++k;
        footprint.count = std::max(footprint.count, k + 1);
        footprint.texels[k] = texel;
        footprint.weights[k] += at.weight[i];
        footprint.sum += at.weight[i] * values_[texel];
      }
      for (std::uint32_t k = 0; k < footprint.count; ++k) ++touch_starts_[footprint.texels[k] + 1];
      footprints_.push_back(footprint);
    }
    starts_.push_back(footprints_.size());
  }
  for (std::size_t t = 0; t < texels.size(); ++t) touch_starts_[t + 1] += touch_starts_[t];
  touches_.resize(touch_starts_.back());
  std::vector<std::size_t> ends(touch_starts_.begin(), touch_starts_.end() - 1);
  for (std::uint32_t f = 0; f < footprints_.size(); ++f) {
    const Footprint& footprint = footprints_[f];
    std::size_t shared = 0;
    for (std::uint32_t k = 0; k < footprint.count; ++k) {
      const std::uint32_t texel = footprint.texels[k];
      touches_[ends[texel]++] = {f, footprint.weights[k]};
      shared += touch_starts_[texel + 1] - touch_starts_[texel];
    }
    shared_.push_back(static_cast<std::uint32_t>(shared));
  }
  for (std::uint32_t p = 0; p < points.points.size(); ++p) {
    worth_.push_back(points.points[p].edge == SeamPoint::no_edge ? worth_of_corner : 1);
    judge(p);
  }
}

void IntegerHeights::judge(std::uint32_t point) {
  const auto all = std::span(footprints_).subspan(starts_[point], starts_[point + 1] - starts_[point]);
  const bool is_unequal = !is_released_[point] && std::ranges::any_of(all, [&](const Footprint& one) {
    return height(one) != height(all.front());
  });
  if (is_unequal == is_unequal_[point]) return;
  unequal_count_ += is_unequal ? std::size_t{1} : ~std::size_t{0};
  cost_ += is_unequal ? worth_[point] : -std::uint64_t{worth_[point]};
  is_unequal_[point] = is_unequal;
}

void IntegerHeights::release(std::size_t point) {
  is_released_[point] = true;
  judge(static_cast<std::uint32_t>(point));
}

void IntegerHeights::apply(Step step) {
  values_[step.texel] = static_cast<std::uint16_t>(values_[step.texel] + step.by);
  for (std::size_t i = touch_starts_[step.texel]; i < touch_starts_[step.texel + 1]; ++i) {
    Footprint& footprint = footprints_[touches_[i].footprint];
    footprint.sum += touches_[i].weight * static_cast<std::uint32_t>(step.by);  // modulo 2^32: it may be less
    judge(footprint.point);
  }
}

/// The step of one of its texels that brings it to a height and leaves the fewest points unequal; of equals the
/// smallest.
IntegerHeights::Step IntegerHeights::best_step(const Footprint& footprint, std::uint32_t wanted) {
  const std::int64_t least = (std::int64_t{wanted} << shift_) - footprint.sum;
  const std::int64_t most = least + (std::int64_t{1} << shift_) - 1;
  Step best;
  std::array<std::int64_t, 2> best_cost{};
  for (std::uint32_t k = 0; k < footprint.count; ++k) {
    const std::int64_t weight = footprint.weights[k];
    const std::uint32_t texel = footprint.texels[k];
    const std::int64_t first = least > 0 ? (least + weight - 1) / weight : -((weight - 1 - most) / weight);
    const std::int64_t middle = (least + most) / 2 / weight;
    for (const std::int64_t by : {first, first + (least > 0 ? 1 : -1), (first + middle) / 2, middle}) {
      if (by == 0 || by * weight < least || by * weight > most) continue;
      if (values_[texel] + by < 0 || values_[texel] + by > 65535) continue;
      const Step step{texel, static_cast<std::int32_t>(by)};
      apply(step);
      const std::array cost{static_cast<std::int64_t>(cost_), by < 0 ? -by : by};
      apply(step.back());
      if (best.by != 0 && cost >= best_cost) continue;
      best = step;
      best_cost = cost;
    }
  }
  return best;
}

/// The steps that were made. Sides that share texels move each other, so that they are asked several times.
std::vector<IntegerHeights::Step> IntegerHeights::bring_to(std::uint32_t point, std::uint32_t wanted) {
  std::vector<Step> steps;
  for (int sweep = 0; sweep < 4; ++sweep) {
    const std::size_t before = steps.size();
    for (std::size_t f = starts_[point]; f < starts_[point + 1]; ++f) {
      if (height(footprints_[f]) == wanted) continue;
      const Step step = best_step(footprints_[f], wanted);
      if (step.by == 0) continue;
      apply(step);
      steps.push_back(step);
    }
    if (steps.size() == before) break;
  }
  return steps;
}

void IntegerHeights::undo(const std::vector<Step>& steps) {
  for (auto step = steps.rbegin(); step != steps.rend(); ++step) apply(step->back());
}

/// That of the side that dictates, and then those of all sides, and beside them.
std::vector<std::uint32_t> IntegerHeights::heights_near(std::uint32_t point) const {
  const std::size_t begin = starts_[point], end = starts_[point + 1];
  std::size_t dictator = begin;
  for (std::size_t f = begin; f < end; ++f) {
    if (shared_[f] > shared_[dictator]) dictator = f;
  }
  const std::uint32_t most = ~std::uint32_t{0} >> shift_;
  std::vector<std::uint32_t> heights{height(footprints_[dictator])};
  for (std::size_t f = begin; f < end; ++f) {
    const std::uint32_t of_side = height(footprints_[f]);
    heights.push_back(of_side);
    if (of_side > 0) heights.push_back(of_side - 1);
    if (of_side < most) heights.push_back(of_side + 1);
  }
  return heights;
}

/// To the first of these heights that costs less.
void IntegerHeights::let_follow(std::uint32_t point) {
  const std::uint64_t before = cost_;
  for (const std::uint32_t wanted : heights_near(point)) {
    const std::vector<Step> steps = bring_to(point, wanted);
    if (cost_ < before) return;
    undo(steps);
  }
}

void IntegerHeights::return_to(const std::vector<std::uint16_t>& values) {
  for (std::uint32_t t = 0; t < values.size(); ++t) {
    if (values[t] != values_[t]) apply({t, values[t] - values_[t]});
  }
}

void IntegerHeights::settle(int most_passes, const std::atomic<bool>* cancel) {
  std::vector<std::uint16_t> best = values_;
  std::size_t fewest = unequal_count_;
  for (int pass = 0; pass < most_passes && unequal_count_ > 0; ++pass) {
    const std::uint64_t before = cost_;
    for (std::uint32_t p = 0; p + 1 < starts_.size(); ++p) {
      if (!is_unequal_[p]) continue;
      if (is_cancelled(cancel)) return;
      let_follow(p);
    }
    if (unequal_count_ < fewest) {
      fewest = unequal_count_;
      best = values_;
    }
    if (cost_ < before) continue;
    for (std::uint32_t p = 0; p + 1 < starts_.size(); ++p) {
      if (!is_unequal_[p]) continue;
      ++worth_[p];
      ++cost_;
    }
  }
  return_to(best);
}

}  // namespace foredraw::processors::displacement_seams

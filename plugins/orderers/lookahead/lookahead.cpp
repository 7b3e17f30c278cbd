#include "lookahead.h"

#include "fan_walk.h"

#include <algorithm>
#include <compare>
#include <numeric>

namespace foredraw {

namespace {

struct Effort {
  int candidates, depth;
  int margin;  ///< of promise, behind the most promising: who is further behind is not tried
};

constexpr std::size_t finalists = 3;  // who are tried out to the full depth
constexpr int usual_cost = 100;       // of a triangle, in 1/1024 of a vertex: robust orders shade a tenth of one again

Effort effort_of(const LookaheadOptions& options) {
  constexpr int all_rivals = FanWalk::unopposed - 1;
  constexpr Effort efforts[] = {{2, 3, 60}, {16, 8, all_rivals}, {16, 20, all_rivals}};
  const Effort usual = efforts[static_cast<int>(options.quality)];
  return {options.candidates > 0 ? options.candidates : usual.candidates,
          options.depth > 0 ? options.depth : usual.depth, usual.margin};
}

/// Found by random search on small meshes; README.md tells which.
FanWeights weights_of(const LookaheadOptions& options) {
  if (options.target == LookaheadTarget::nvidia) {  // the cache is emptied so often that ages hardly matter
    return {.done = 231,
            .done_power = 2,
            .waiting = 68,
            .waiting_old = 1002,
            .waiting_open = 575,
            .prefer_old = 5,
            .avoid_large = 14,
            .avoid_new = 3,
            .reserve = 0};
  }
  if (options.target != LookaheadTarget::robust) {
    return {.done = 24,
            .done_power = 2,
            .waiting = 18,
            .waiting_old = 870,
            .waiting_open = 52,
            .prefer_old = 37,
            .avoid_large = 18,
            .avoid_new = 50,
            .reserve = 4};
  }
  if (options.quality == LookaheadQuality::fast) {  // the first guess counts for more
    return {.done = 1043,
            .done_power = 1,
            .waiting = 48,
            .waiting_old = 298,
            .waiting_open = -5,
            .prefer_old = 5,
            .avoid_large = -29,
            .avoid_new = 75,
            .reserve = 8};
  }
  if (options.quality == LookaheadQuality::high) {  // who looks further needs less in reserve
    return {.done = 900,
            .done_power = 3,
            .waiting = -19,
            .waiting_old = 972,
            .waiting_open = 53,
            .prefer_old = 28,
            .avoid_large = -7,
            .avoid_new = 40,
            .reserve = 11};
  }
  return {.done = 1200,
          .done_power = 2,
          .waiting = -5,
          .waiting_old = 882,
          .waiting_open = 60,
          .prefer_old = 25,
          .avoid_large = 5,
          .avoid_new = 60,
          .reserve = 12};
}

struct Rival {
  std::int64_t cost;
  std::size_t rank;  ///< by promise, where costs are equal
  std::uint32_t center;

  auto operator<=>(const Rival&) const = default;
};

bool is_cancelled(const LookaheadOptions& options) {
  return options.cancel != nullptr && options.cancel->load(std::memory_order_relaxed);
}

/// One walk over the mesh, from fan to fan.
void walk_through(std::span<std::uint32_t> order, std::span<const std::uint32_t> indices, std::size_t vertex_count,
                  const LookaheadOptions& options, std::pmr::memory_resource& memory) {
  const Effort effort = effort_of(options);
  FanWalk walk(order, indices, vertex_count, cache_of(options), weights_of(options), memory);

  /// What it costs to go on around `center`, and then `fans` times wherever is most promising: what is paid on the way
  /// and the outlook at its end, beyond what so many triangles usually cost.
  const auto cost_of = [&](std::uint32_t center, int fans) {
    const FanWalk::Trial trial(walk);
    std::int64_t triangles = walk.draw(center);
    for (; fans > 0 && !trial.is_long(); --fans) {
      center = walk.most_promising();
      if (center == FanWalk::none) break;
      triangles += walk.draw(center);
    }
    return trial.cost() + walk.outlook() - usual_cost * triangles;
  };

  std::pmr::vector<Rival> rivals(&memory);
  const auto keep_cheapest = [&](std::size_t count, int fans) {
    if (rivals.size() <= count) return;
    for (Rival& rival : rivals) rival.cost = cost_of(rival.center, fans);
    std::ranges::sort(rivals);
    rivals.resize(count);
  };

  for (std::size_t drawn = 0; drawn < order.size() && !is_cancelled(options);) {
    rivals.clear();
    for (const std::uint32_t center : walk.promising(static_cast<std::size_t>(effort.candidates), effort.margin)) {
      rivals.push_back({0, rivals.size(), center});
    }
    keep_cheapest(finalists, 0);
    keep_cheapest(1, effort.depth);
    drawn += walk.draw(rivals[0].center);
  }
}

std::uint64_t misses_of(std::span<const std::uint32_t> order, std::span<const std::uint32_t> indices,
                        std::size_t vertex_count, const BatchModel& cache, std::pmr::memory_resource& memory) {
  std::pmr::vector<std::uint32_t> ordered(&memory);
  ordered.reserve(indices.size());
  for (const std::uint32_t triangle : order) {
    for (std::size_t c = 0; c < 3; ++c) ordered.push_back(indices[3 * std::size_t{triangle} + c]);
  }
  return batch_misses(ordered, vertex_count, cache);
}

}  // namespace

BatchModel cache_of(const LookaheadOptions& options) {
  switch (options.target) {
    case LookaheadTarget::nvidia: return batch_models[0];
    case LookaheadTarget::amd: return batch_models[1];
    case LookaheadTarget::intel: return batch_models[2];
    default: return {"fifo", static_cast<std::uint32_t>(options.cache_size), 0, 0};
  }
}

void lookahead(std::span<std::uint32_t> order, std::span<const std::uint32_t> indices, std::size_t vertex_count,
               const LookaheadOptions& options, std::pmr::memory_resource& memory) {
  if (!lookahead_takes(indices.size())) return std::iota(order.begin(), order.end(), 0u);
  walk_through(order, indices, vertex_count, options, memory);
  if (is_cancelled(options)) return std::iota(order.begin(), order.end(), 0u);
  if (options.quality != LookaheadQuality::high) return;

  // Deeper trials mostly find the better order, but not in every mesh: the plainer one is the measure.
  LookaheadOptions plainer = options;
  plainer.quality = LookaheadQuality::balanced;
  std::pmr::vector<std::uint32_t> other(order.size(), &memory);
  walk_through(other, indices, vertex_count, plainer, memory);
  const auto misses = [&](std::span<const std::uint32_t> of) {
    return misses_of(of, indices, vertex_count, cache_of(options), memory);
  };
  if (is_cancelled(options)) return std::iota(order.begin(), order.end(), 0u);
  if (misses(other) < misses(order)) std::ranges::copy(other, order.begin());
}

std::vector<std::uint32_t> lookahead(std::span<const std::uint32_t> indices, std::size_t vertex_count,
                                     const LookaheadOptions& options) {
  std::vector<std::uint32_t> order(indices.size() / 3);
  lookahead(order, indices, vertex_count, options, *std::pmr::get_default_resource());
  return order;
}

}  // namespace foredraw

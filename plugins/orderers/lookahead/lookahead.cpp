#include "lookahead.h"

#include "fan_walk.h"

#include <utility>

namespace foredraw {

namespace {

struct Effort {
  int candidates, depth;
  int margin;  ///< of promise, behind the most promising: who is further behind is not tried
};

constexpr int unopposed = 1 << 21;  // by anyone: more than all else that makes promising

Effort effort_of(const LookaheadOptions& options) {
  constexpr Effort efforts[] = {{3, 2, 100}, {8, 8, unopposed - 1}, {10, 20, unopposed - 1}};
  const Effort usual = efforts[static_cast<int>(options.quality)];
  return {options.candidates > 0 ? options.candidates : usual.candidates,
          options.depth > 0 ? options.depth : usual.depth, usual.margin};
}

/// Found by random search on four meshes.
FanWeights weights_of(const LookaheadOptions& options) {
  if (options.target == LookaheadTarget::nvidia) {  // the cache is emptied so often that ages hardly matter
    return {.done = 231,
            .waiting = 68,
            .waiting_old = 1002,
            .waiting_open = 575,
            .prefer_free = unopposed,
            .prefer_old = 5,
            .avoid_large = 14,
            .avoid_new = 3,
            .reserve = 0};
  }
  if (options.target != LookaheadTarget::robust) {
    return {.done = 24,
            .waiting = 18,
            .waiting_old = 870,
            .waiting_open = 52,
            .prefer_free = unopposed,
            .prefer_old = 37,
            .avoid_large = 18,
            .avoid_new = 50,
            .reserve = 2};
  }
  if (options.quality == LookaheadQuality::fast) {  // the first guess counts for more
    return {.done = 338,
            .waiting = 22,
            .waiting_old = 637,
            .waiting_open = 74,
            .prefer_free = unopposed,
            .prefer_old = 50,
            .avoid_large = 6,
            .avoid_new = 103,
            .reserve = 6};
  }
  return {.done = 1000,
          .waiting = -5,
          .waiting_old = 882,
          .waiting_open = 60,
          .prefer_free = 0,
          .prefer_old = 38,
          .avoid_large = 17,
          .avoid_new = 42,
          .reserve = 6};
}

/// What a trial came to. The cost is what was paid and how the outlook changed.
struct Outcome {
  std::uint32_t center = FanWalk::none;
  std::int64_t cost = 0, triangles = 0;

  bool is_cheaper_than(const Outcome& other) const {  // by triangle
    return other.triangles == 0 || cost * other.triangles < other.cost * triangles;
  }
};

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
  const Effort effort = effort_of(options);
  FanWalk walk(order, indices, vertex_count, cache_of(options), weights_of(options), memory);

  /// What becomes of the walk if it goes on around `center`, and then as far as `fans` wherever is most promising.
  const auto try_out = [&](std::uint32_t center, int fans) {
    const FanWalk::Trial trial(walk);
    Outcome outcome{.center = center, .cost = -walk.outlook()};
    for (; center != FanWalk::none && fans >= 0 && !trial.is_long(); --fans) {
      outcome.triangles += walk.draw(center);
      center = walk.most_promising();
    }
    outcome.cost += trial.cost() + walk.outlook();
    return outcome;
  };

  /// Short trials tell most of the candidates apart.
  const auto best_at_a_glance = [&](std::span<const std::uint32_t> centers) {
    Outcome best, second;
    for (const std::uint32_t center : centers) {
      const Outcome outcome = try_out(center, effort.depth / 4);
      if (outcome.is_cheaper_than(best)) {
        second = std::exchange(best, outcome);
      } else if (outcome.is_cheaper_than(second)) {
        second = outcome;
      }
    }
    return std::pair(best.center, second.center);
  };

  for (std::size_t drawn = 0; drawn < order.size();) {
    const auto centers = walk.promising(static_cast<std::size_t>(effort.candidates), effort.margin);
    std::uint32_t center = centers[0];
    if (centers.size() > 1) {
      const auto [one, other] = centers.size() > 2 ? best_at_a_glance(centers) : std::pair(centers[0], centers[1]);
      center = try_out(other, effort.depth).is_cheaper_than(try_out(one, effort.depth)) ? other : one;
    }
    drawn += walk.draw(center);
  }
}

std::vector<std::uint32_t> lookahead(std::span<const std::uint32_t> indices, std::size_t vertex_count,
                                     const LookaheadOptions& options) {
  std::vector<std::uint32_t> order(indices.size() / 3);
  lookahead(order, indices, vertex_count, options, *std::pmr::get_default_resource());
  return order;
}

}  // namespace foredraw

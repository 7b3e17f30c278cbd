#include "tipsify.h"

#include <foredraw/analysis/vertex_triangles.h>

namespace foredraw {

namespace {

constexpr std::uint32_t none = ~std::uint32_t{0};

/// Where the walk stands: what is still to be drawn, and what the cache holds.
struct Walk {
  std::pmr::vector<std::uint32_t> live;       // of each vertex: its triangles not yet drawn
  std::pmr::vector<std::uint32_t> cached_at;  // of each vertex: the time at which it last entered the cache
  std::pmr::vector<std::uint32_t> dead_ends;  // vertices of drawn triangles, the latest last
  std::uint32_t time;                         // how many vertices have entered the cache
  std::uint32_t cursor = 0;                   // all vertices before it are used up
  std::uint32_t cache_size;
};

/// Of the vertices around the last fan the one that entered the cache longest ago and would still be in it after its own
/// fan, which brings in two vertices a triangle at most.
std::uint32_t best_in_cache(const Walk& walk, std::span<const std::uint32_t> candidates) {
  std::uint32_t best = none;
  std::uint32_t best_age = 0;
  for (std::uint32_t v : candidates) {
    if (walk.live[v] == 0) continue;
    const std::uint32_t age = walk.time - walk.cached_at[v];
    const bool stays = age + 2 * walk.live[v] <= walk.cache_size;
    const std::uint32_t rank = stays ? age : 0;
    if (best == none || rank > best_age) {
      best = v;
      best_age = rank;
    }
  }
  return best;
}

/// Where the fan's neighbours are used up: the vertex seen last that still has triangles, else the next in input order.
std::uint32_t skip_dead_end(Walk& walk) {
  while (!walk.dead_ends.empty()) {
    const std::uint32_t v = walk.dead_ends.back();
    walk.dead_ends.pop_back();
    if (walk.live[v] > 0) return v;
  }
  for (; walk.cursor < walk.live.size(); ++walk.cursor) {
    if (walk.live[walk.cursor] > 0) return walk.cursor;
  }
  return none;
}

}  // namespace

void tipsify(std::span<std::uint32_t> order, std::span<const std::uint32_t> indices, std::size_t vertex_count,
             const TipsifyOptions& options, std::pmr::memory_resource& memory) {
  const VertexTriangles triangles_of(indices, vertex_count, &memory);
  const auto cache_size = static_cast<std::uint32_t>(options.cache_size);
  Walk walk{.live = std::pmr::vector<std::uint32_t>(vertex_count, &memory),
            .cached_at = std::pmr::vector<std::uint32_t>(vertex_count, 0, &memory),
            .dead_ends = std::pmr::vector<std::uint32_t>(&memory),
            .time = cache_size + 1,
            .cache_size = cache_size};
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    walk.live[v] = static_cast<std::uint32_t>(triangles_of.of(v).size());
  }
  walk.dead_ends.reserve(indices.size());
  std::pmr::vector<bool> drawn(order.size(), false, &memory);
  std::pmr::vector<std::uint32_t> candidates(&memory);

  std::size_t at = 0;
  for (std::uint32_t fan = skip_dead_end(walk); fan != none;) {
    candidates.clear();
    for (std::uint32_t triangle : triangles_of.of(fan)) {
      if (drawn[triangle]) continue;
      drawn[triangle] = true;
      order[at++] = triangle;
      for (std::uint32_t v : indices.subspan(3 * std::size_t{triangle}, 3)) {
        walk.dead_ends.push_back(v);
        candidates.push_back(v);
        --walk.live[v];
        if (walk.time - walk.cached_at[v] > cache_size) walk.cached_at[v] = walk.time++;
      }
    }
    fan = best_in_cache(walk, candidates);
    if (fan == none) fan = skip_dead_end(walk);
  }
}

std::vector<std::uint32_t> tipsify(std::span<const std::uint32_t> indices, std::size_t vertex_count,
                                   const TipsifyOptions& options) {
  std::vector<std::uint32_t> order(indices.size() / 3);
  tipsify(order, indices, vertex_count, options, *std::pmr::get_default_resource());
  return order;
}

}  // namespace foredraw

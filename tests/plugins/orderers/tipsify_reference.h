#pragma once
// Tipsify as the paper writes it down, with nothing done for speed: what the plugin's answer is held against.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace foredraw::testing {

inline std::vector<std::uint32_t> tipsify_reference(std::span<const std::uint32_t> indices, std::size_t vertex_count,
                                                    std::uint32_t cache_size) {
  std::vector<std::vector<std::uint32_t>> triangles_of(vertex_count);
  for (std::uint32_t corner = 0; corner < indices.size(); ++corner) {
    triangles_of[indices[corner]].push_back(corner / 3);
  }
  std::vector<std::size_t> live(vertex_count);
  for (std::size_t v = 0; v < vertex_count; ++v) live[v] = triangles_of[v].size();
  std::vector<std::uint64_t> cached_at(vertex_count, 0);
  std::uint64_t time = cache_size + 1;
  std::vector<bool> emitted(indices.size() / 3, false);
  std::vector<std::uint32_t> dead_ends;
  std::vector<std::uint32_t> order;

  const auto skip_dead_end = [&]() -> std::int64_t {
    for (; !dead_ends.empty(); dead_ends.pop_back()) {
      if (live[dead_ends.back()] > 0) return dead_ends.back();
    }
    const auto next = std::ranges::find_if(live, [](std::size_t count) { return count > 0; });
    return next == live.end() ? -1 : next - live.begin();
  };

  for (std::int64_t fan = skip_dead_end(); fan >= 0;) {
    std::vector<std::uint32_t> candidates;
    for (const std::uint32_t triangle : triangles_of[static_cast<std::size_t>(fan)]) {
      if (emitted[triangle]) continue;
      emitted[triangle] = true;
      order.push_back(triangle);
      for (const std::uint32_t v : indices.subspan(3 * std::size_t{triangle}, 3)) {
        dead_ends.push_back(v);
        candidates.push_back(v);
        --live[v];
        if (time - cached_at[v] > cache_size) cached_at[v] = time++;
      }
    }
    std::int64_t best = -1;
    std::uint64_t best_priority = 0;
    for (const std::uint32_t v : candidates) {
      if (live[v] == 0) continue;
      const std::uint64_t age = time - cached_at[v];
      const std::uint64_t priority = age + 2 * live[v] <= cache_size ? age : 0;
      if (best >= 0 && priority <= best_priority) continue;
      best = v;
      best_priority = priority;
    }
    fan = best >= 0 ? best : skip_dead_end();
  }
  return order;
}

}  // namespace foredraw::testing

// How long it takes to choose a tessellation level for each instance of a crowd within a budget: by
// foredraw_crowd_select(), without and with hysteresis; by bisection of the price over all instances; and by
// foredraw_lod_select(), for which each instance has ways of its own (made beforehand). Levels 1 to 15, off by
// 1 / level; distances from 2 to 40, evenly over a plane; budgets of so many triangles an instance. Medians of seven
// frames, in turn, of a crowd that moves; then what the best level of it all is, as the root mean square of what each
// method is off, beside bisection's.
//   crowd-select-bench

#include <benchmarks/timing.h>

#include <foredraw/base/random.h>
#include <foredraw/runtime/crowd_select.h>
#include <foredraw/runtime/tessellation_level.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace foredraw::bench {
namespace {

constexpr std::uint32_t t_max = 15;

struct Crowd {
  std::vector<foredraw_crowd_level> levels;
  std::vector<float> distances;
  foredraw_crowd_table table{};
  std::vector<std::uint8_t> chosen;
  std::vector<std::uint32_t> memory;
};

Crowd crowd_of(std::uint32_t n) {
  Crowd crowd;
  for (std::uint32_t t = 1; t <= t_max; ++t) {
    crowd.levels.push_back({foredraw_tessellation_triangles(t), 1.0f / static_cast<float>(t)});
  }
  foredraw_crowd_prepare(crowd.levels.data(), t_max, &crowd.table);
  Random random(7);
  for (std::uint32_t i = 0; i < n; ++i) {
    crowd.distances.push_back(static_cast<float>(std::sqrt(4 + 1596 * random.unit())));
  }
  crowd.chosen.assign(n, FOREDRAW_CROWD_NEW);
  crowd.memory.resize(foredraw_crowd_memory(&crowd.table) / sizeof(std::uint32_t));
  return crowd;
}

/// No histogram: each try of a price asks every instance.
void by_bisection(Crowd& crowd, std::uint64_t budget) {
  double low = 0, high = 1e30;
  const auto level_at = [&](float distance, double price) {
    std::uint32_t steps = 0;
    const double squared = static_cast<double>(distance) * static_cast<double>(distance);
    while (steps < crowd.table.steps && crowd.table.gain[steps] >= price * squared) ++steps;
    return steps;
  };
  for (int i = 0; i < 80; ++i) {
    const double price = low > 0 ? std::sqrt(low * high) : high * 1e-30;
    std::uint64_t triangles = 0;
    for (const float distance : crowd.distances) triangles += crowd.table.triangles[level_at(distance, price)];
    (triangles <= budget ? high : low) = price;
    if (low > 0 && high < low * 1.000001) break;
  }
  for (std::size_t i = 0; i < crowd.distances.size(); ++i) {
    crowd.chosen[i] = crowd.table.hull[level_at(crowd.distances[i], high)];
  }
}

double squares(const Crowd& crowd, const std::function<std::uint32_t(std::size_t)>& level) {
  double sum = 0;
  for (std::size_t i = 0; i < crowd.distances.size(); ++i) {
    const double off = static_cast<double>(crowd.levels[level(i)].error) / static_cast<double>(crowd.distances[i]);
    sum += off * off;
  }
  return sum;
}

void measure(std::uint32_t n, std::uint64_t budget) {
  Crowd crowd = crowd_of(n), kept = crowd, bisected = crowd;
  std::vector<std::uint32_t> first(n + 1), chosen(n);
  std::vector<foredraw_lod_way> ways(std::size_t{n} * t_max);
  for (std::uint32_t i = 0; i <= n; ++i) first[i] = i * t_max;
  const foredraw_lod_scene scene{n, first.data(), ways.data()};
  std::vector<std::uint64_t> memory(foredraw_lod_memory(&scene) / 8 + 1);
  constexpr std::size_t methods = 4;
  std::array<std::vector<double>, methods> times, off;
  Random random(8);
  const auto select = [&](Crowd& of, float hysteresis) {
    foredraw_crowd_select(&of.table, of.distances.data(), n, budget, hysteresis, of.chosen.data(), of.memory.data());
  };
  for (int round = 0; round < 8; ++round) {
    for (float& distance : crowd.distances) {
      distance = std::clamp(distance + 0.2f * (static_cast<float>(random.unit()) - 0.5f), 2.0f, 40.0f);
    }
    kept.distances = bisected.distances = crowd.distances;
    for (std::uint32_t i = 0; i < n; ++i) {
      for (std::uint32_t t = 0; t < t_max; ++t) {
        const double error = static_cast<double>(crowd.levels[t].error) / static_cast<double>(crowd.distances[i]);
        ways[i * t_max + t] = {crowd.levels[t].triangles, static_cast<std::uint32_t>((1 - error * error) * 4e9)};
      }
    }
    const std::array<std::function<void()>, methods> all{
        [&] { select(crowd, 0); },
        [&] { select(kept, 0.4f); },
        [&] { by_bisection(bisected, budget); },
        [&] { foredraw_lod_select(&scene, budget, chosen.data(), memory.data()); },
    };
    std::array<double, methods> sums{};
    for (std::size_t m = 0; m < methods; ++m) {
      const double time = 1000 * seconds_of(all[m]);
      const auto of = [](const Crowd& by) { return squares(by, [&](std::size_t i) { return by.chosen[i]; }); };
      sums[m] = m == 0   ? of(crowd)
                : m == 1 ? of(kept)
                : m == 2 ? of(bisected)
                         : squares(crowd, [&](std::size_t i) { return chosen[i]; });
      if (round > 0) times[m].push_back(time);  // the first one finds the memory
    }
    for (std::size_t m = 0; m < methods; ++m) off[m].push_back(std::sqrt(sums[m] / sums[2]));
  }
  fmt::print("| {} | {} |", n, budget);
  for (std::size_t m = 0; m < methods; ++m) fmt::print(" {:.3f} | {:.4f} |", median(times[m]), median(off[m]));
  fmt::print("\n");
}

}  // namespace
}  // namespace foredraw::bench

int main() {
  fmt::print(
      "| instances | budget | ours, ms | off | with hysteresis, ms | off | bisection, ms | off | for any ways, ms | "
      "off "
      "|\n");
  fmt::print("|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
  for (const std::uint32_t n : {200u, 1'000u, 10'000u, 100'000u, 1'000'000u}) {
    for (const std::uint32_t of_each : {3u, 17u, 67u}) foredraw::bench::measure(n, std::uint64_t{n} * of_each);
  }
  return 0;
}

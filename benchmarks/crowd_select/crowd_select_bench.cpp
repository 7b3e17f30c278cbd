// How long it takes to choose a tessellation level for each instance of a crowd within a budget: by
// foredraw_crowd_select(), without and with hysteresis; by bisection of the price over all instances; and by
// foredraw_lod_select(), for which each instance has ways of its own (made beforehand). Levels 1 to 15, off by
// 1 / level; distances from 2 to 40, evenly over a plane; budgets of so many triangles an instance. Medians of seven
// frames, in turn, of a crowd that moves; beside each its root mean square error, as a multiple of bisection's.
//
// Then what the crowd is off and takes by one level for all, as the paper has it and by square root (M = 10, means over
// the crowds of eight seeds); and how many levels change with hysteresis, along the path of crowd-cost.
//   crowd-select-bench

#include <benchmarks/timing.h>
#include <evaluators/crowd_cost/crowd_path.h>

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

/// `simplified`: triangles of further levels; then the cage has 5,160, else 1.
Crowd crowd_of(std::uint32_t n, std::uint64_t seed, const std::vector<std::uint32_t>& simplified = {}) {
  Crowd crowd;
  const std::uint32_t cage = simplified.empty() ? 1 : 5160;
  for (std::uint32_t t = 1; t <= t_max; ++t) {
    crowd.levels.push_back({cage * foredraw_tessellation_triangles(t), 1.0f / static_cast<float>(t)});
  }
  for (const std::uint32_t left : simplified) {
    crowd.levels.push_back({left, std::sqrt(static_cast<float>(cage) / static_cast<float>(left))});
  }
  foredraw_crowd_prepare(crowd.levels.data(), static_cast<std::uint32_t>(crowd.levels.size()), &crowd.table);
  Random random(seed);
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

foredraw_crowd_result select(Crowd& crowd, std::uint64_t budget, float hysteresis) {
  return foredraw_crowd_select(&crowd.table, crowd.distances.data(), static_cast<std::uint32_t>(crowd.distances.size()),
                               budget, hysteresis, crowd.chosen.data(), crowd.memory.data());
}

void measure(std::uint32_t n, std::uint64_t budget) {
  Crowd crowd = crowd_of(n, 7), kept = crowd, bisected = crowd;
  std::vector<std::uint32_t> first(n + 1), chosen(n);
  std::vector<foredraw_lod_way> ways(std::size_t{n} * t_max);
  for (std::uint32_t i = 0; i <= n; ++i) first[i] = i * t_max;
  const foredraw_lod_scene scene{n, first.data(), ways.data()};
  std::vector<std::uint64_t> memory(foredraw_lod_memory(&scene) / 8 + 1);
  constexpr std::size_t methods = 4;
  std::array<std::vector<double>, methods> times, off;
  Random random(8);
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
        [&] { select(crowd, budget, 0); },
        [&] { select(kept, budget, 0.35f); },
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

void measure_formulas(std::uint32_t n) {
  constexpr std::uint32_t characters = 10;
  constexpr std::uint64_t budget = characters * 337;
  double sums[3] = {0, 0, 0}, uses[3] = {0, 0, 0};
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Crowd crowd = crowd_of(n, seed);
    uses[2] += static_cast<double>(select(crowd, budget, 0).triangles) / static_cast<double>(budget) / 8;
    sums[2] += squares(crowd, [&](std::size_t i) { return crowd.chosen[i]; });
    const float levels[2] = {foredraw_tessellation_by_count(characters, t_max, n),
                             foredraw_tessellation_by_root(characters, t_max, n)};
    for (int f = 0; f < 2; ++f) {
      const std::uint32_t parts = foredraw_tessellation_floor(levels[f], FOREDRAW_SPACING_EQUAL);
      sums[f] += squares(crowd, [&](std::size_t) { return parts - 1; });
      uses[f] += static_cast<double>(n) * foredraw_tessellation_triangles(parts) / static_cast<double>(budget) / 8;
    }
  }
  fmt::print("| {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.4f} |\n", n, std::sqrt(sums[2] / sums[0]),
             std::sqrt(sums[2] / sums[1]), uses[0], uses[1], uses[2]);
}

struct Walked {
  double changes = 0, squares = 0;
};

Walked walked(std::uint32_t n, double speed, float hysteresis) {
  constexpr std::uint64_t budget = 10ull * 337 * 5160;
  Walked sum;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Crowd crowd = crowd_of(n, 0, {2580, 1290, 516, 200, 80, 20});
    CrowdPath path({.instances = n, .eye_speed = speed, .seed = seed});
    for (int frame = 0; frame < 300; ++frame) {
      if (frame > 0) path.step();
      crowd.distances = path.distances();
      for (std::uint32_t i = 0; i < n; ++i) {
        if (path.is_new()[i] != 0) crowd.chosen[i] = FOREDRAW_CROWD_NEW;
      }
      const std::vector<std::uint8_t> before = crowd.chosen;
      select(crowd, budget, hysteresis);
      for (std::uint32_t i = 0; i < n; ++i) {
        sum.changes += before[i] != FOREDRAW_CROWD_NEW && before[i] != crowd.chosen[i];
      }
      sum.squares += squares(crowd, [&](std::size_t i) { return crowd.chosen[i]; });
    }
  }
  return sum;
}

void measure_hysteresis(std::uint32_t n) {
  fmt::print("| {} |", n);
  for (const double speed : {1.4, 0.0, 4.0}) {
    const Walked without = walked(n, speed, 0), with = walked(n, speed, 0.35f);
    fmt::print(" {:.2f} | {:.4f} |", with.changes / without.changes, std::sqrt(with.squares / without.squares));
  }
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
  fmt::print("\n| instances | of the paper's rms | of the root's | paper uses | root uses | ours uses |\n");
  fmt::print("|---:|---:|---:|---:|---:|---:|\n");
  for (const std::uint32_t n : {10u, 20u, 50u, 200u, 1'000u, 2'000u, 5'000u}) foredraw::bench::measure_formulas(n);
  fmt::print("\n| instances | walks: changes | error | stands: changes | error | runs: changes | error |\n");
  fmt::print("|---:|---:|---:|---:|---:|---:|---:|\n");
  for (const std::uint32_t n : {50u, 200u, 1'000u, 3'000u, 10'000u}) foredraw::bench::measure_hysteresis(n);
  return 0;
}

// How long it takes to choose a level for each visible object, and how far the choice is from what no choice can
// exceed; beside the same by sorting all steps, and beside the first algorithm of Funkhouser and Sequin 1993 (all ways
// of all objects by their value, in turn). Six levels an object, of half the triangles each; costs as the larger of
// triangles and pixels, benefits by size and error. Costs and benefits are made beforehand. Medians of seven frames, in
// turn, of a camera that moves; budgets are shares of what full detail costs.
//   lod-select-bench

#include <benchmarks/lod_select/lod_methods.h>
#include <benchmarks/timing.h>

#include <foredraw/runtime/lod_select.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace foredraw::bench {
namespace {

constexpr std::uint32_t levels = 6;

struct Frame {
  std::vector<foredraw_lod_way> ways;
  std::vector<std::uint32_t> first;
  std::uint64_t most = 0;  ///< cost of full detail

  foredraw_lod_scene scene() const { return {static_cast<std::uint32_t>(first.size() - 1), first.data(), ways.data()}; }
};

/// Objects on a plain, looked at from a place that moves.
Frame frame_of(std::uint32_t objects, int number) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  Frame frame;
  frame.first.push_back(0);
  for (std::uint32_t i = 0; i < objects; ++i) {
    const double x = 2000 * unit(random) - 1000, z = 2000 * unit(random), radius = 0.5 + 10 * std::pow(unit(random), 4);
    const double triangles = std::exp(6 + 5 * unit(random));
    const double distance = std::max(std::hypot(x - 0.7 * number, z + 5), radius);
    const double pixels = std::pow(1000 * radius / distance, 2);
    for (std::uint32_t level = levels; level-- > 0;) {  // from the cheapest to the best
      const double left = triangles * std::pow(0.5, level);
      const double error = std::min(1.0, std::sqrt(pixels) / (2 * left));  // of a shape of so few triangles
      const double cost = std::max(3.0 * left, 0.8 * pixels);              // nanoseconds
      frame.ways.push_back({static_cast<std::uint32_t>(std::min(cost, 2e9)),
                            static_cast<std::uint32_t>(std::min(20 * pixels * (1 - error), 2e9))});
    }
    frame.most += frame.ways.back().cost;
    frame.first.push_back(static_cast<std::uint32_t>(frame.ways.size()));
  }
  return frame;
}

/// Hulls, and all steps sorted.
foredraw_lod_result by_sorting(const Frame& frame, std::uint64_t budget, std::vector<std::uint32_t>& chosen,
                               std::vector<foredraw_lod_step>& steps) {
  const foredraw_lod_scene scene = frame.scene();
  foredraw_lod_result result{};
  foredraw_lod_begin(&scene, chosen.data(), &result);
  const std::uint32_t count = foredraw_lod_steps(&scene, chosen.data(), budget - result.cost, steps.data());
  std::stable_sort(steps.begin(), steps.begin() + count, [](const auto& a, const auto& b) {
    return foredraw_lod_is_steeper(a.benefit, a.cost, b.benefit, b.cost) != 0;
  });
  for (std::uint32_t i = 0; i < count && result.cost + steps[i].cost <= budget; ++i) {
    chosen[steps[i].object] = steps[i].way;
    result.cost += steps[i].cost;
    result.benefit += steps[i].benefit;
  }
  return result;
}

void measure(std::uint32_t objects, double share) {
  constexpr std::size_t methods = 4;
  std::vector<double> times[methods], gaps[methods];
  std::vector<std::uint32_t> last(objects, 0);  // of the one method that begins there
  for (int round = 0; round < 7; ++round) {
    const Frame frame = frame_of(objects, round);
    const foredraw_lod_scene scene = frame.scene();
    const auto budget = static_cast<std::uint64_t>(share * static_cast<double>(frame.most));
    std::vector<std::uint64_t> memory(foredraw_lod_memory(&scene) / 8 + 1);
    std::vector<std::uint32_t> chosen(objects), more(2 * frame.ways.size() + 4 * objects);
    std::vector<foredraw_lod_step> steps(frame.ways.size());
    const std::function<foredraw_lod_result()> all[methods]{
        [&] { return foredraw_lod_select(&scene, budget, chosen.data(), memory.data()); },
        [&] { return by_sorting(frame, budget, chosen, steps); },
        [&] { return foredraw_lod_by_value(&scene, budget, chosen.data(), more.data()); },
        [&] { return foredraw_lod_from_last(&scene, budget, last.data(), more.data(), nullptr); },
    };
    const auto bound = static_cast<double>(all[0]().bound);  // and the loop's memory is at hand
    for (std::size_t i = 0; i < methods; ++i) {
      foredraw_lod_result result;
      times[i].push_back(1000 * seconds_of([&] { result = all[i](); }));
      gaps[i].push_back(100 * (bound - static_cast<double>(result.benefit)) / bound);
    }
  }
  fmt::print("| {} | {:g} % |", objects, 100 * share);
  for (std::size_t i = 0; i < methods; ++i) fmt::print(" {:.3f} | {:.4f} |", median(times[i]), median(gaps[i]));
  fmt::print("\n");
}

}  // namespace
}  // namespace foredraw::bench

int main() {
  fmt::print(
      "| objects | budget | ours, ms | below the bound, % | all sorted, ms | % | by value, ms | % | from the last "
      "frame, ms | % |\n");
  fmt::print("|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
  for (const std::uint32_t objects : {24u, 400u, 3'500u, 10'000u, 35'000u, 100'000u}) {
    for (const double share : {0.04, 0.07, 0.15}) foredraw::bench::measure(objects, share);
  }
  return 0;
}

#include "crowd_cost.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace foredraw {

namespace {

/// Of one frame; `before` is what was chosen in the frame before.
void tally(const Crowd& crowd, double size, const CrowdPath& path, std::span<const std::uint8_t> chosen,
           const std::vector<std::uint8_t>& before, CrowdMethodCost& cost) {
  std::uint64_t triangles = 0;
  std::uint32_t pops = 0;
  double squares = 0, largest = 0;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const CrowdLevel& level = crowd.levels[chosen[i]];
    const double distance = size * static_cast<double>(path.distances()[i]);
    const double off = static_cast<double>(level.rms) / distance;
    triangles += level.triangles;
    squares += off * off;
    largest = std::max(largest, static_cast<double>(level.largest) / distance);
    pops += path.is_new()[i] == 0 && chosen[i] != before[i];
  }
  cost.triangles.push_back(triangles);
  cost.rms.push_back(std::sqrt(squares / static_cast<double>(chosen.size())));
  cost.largest.push_back(largest);
  cost.pops.push_back(pops);
}

}  // namespace

double crowd_size(const CrowdLevels& levels, const Crowd& crowd) {
  constexpr double pi = 3.14159265358979323846;
  double area = 0;
  for (const CrowdLevels::OfDraw& draw : levels.draws) {
    const bool is_of_it = std::ranges::find(crowd.draws, draw.draw) != crowd.draws.end();
    if (is_of_it) area += static_cast<double>(draw.area);
  }
  return std::sqrt(area / pi);
}

std::optional<CrowdCost> crowd_cost(const Scene& scene, const CrowdLevels& levels, const Crowd& crowd,
                                    const CrowdCostOptions& options, const std::atomic<bool>* cancel) {
  CrowdCost cost;
  cost.size = crowd_size(levels, crowd);
  if (!(cost.size > 0)) throw std::invalid_argument("the character has no area, so it has no size");
  std::vector<CrowdChooser> choosers;
  for (const CrowdMethod method : all_crowd_methods) {
    if (!CrowdChooser::is_able(method, crowd)) continue;
    choosers.emplace_back(method, crowd, levels.characters, levels.spacing, static_cast<float>(options.hysteresis));
    cost.methods.push_back({.method = method});
  }
  const auto costs = pipeline_costs(scene, levels, crowd, options.fetching, options.passes);
  CrowdPath path({.instances = static_cast<std::uint32_t>(options.instances),
                  .near = options.near,
                  .far = options.far,
                  .eye_speed = options.eye_speed,
                  .seed = options.seed});
  for (int frame = 0; frame < options.frames; ++frame) {
    if (cancel != nullptr && cancel->load(std::memory_order_relaxed)) return std::nullopt;
    if (frame > 0) path.step();
    for (std::size_t m = 0; m < choosers.size(); ++m) {
      const std::vector<std::uint8_t> before(choosers[m].chosen().begin(), choosers[m].chosen().end());
      choosers[m].choose(path.distances(), path.is_new());
      tally(crowd, cost.size, path, choosers[m].chosen(), before, cost.methods[m]);
    }
    std::vector<std::uint64_t> at(crowd.levels.size(), 0);
    for (const std::uint8_t level : choosers.back().chosen()) ++at[level];
    for (std::size_t p = 0; p < costs.size(); ++p) {
      for (std::size_t l = 0; l < at.size(); ++l) cost.pipelines[p].add(costs[p][l], at[l]);
    }
  }
  return cost;
}

}  // namespace foredraw

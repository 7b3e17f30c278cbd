#include <foredraw/crowds/crowd_levels.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace foredraw {

namespace {

std::uint32_t sum(std::uint32_t a, std::uint32_t b) {
  constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
  return static_cast<std::uint32_t>(std::min(std::uint64_t{a} + b, most));
}

Crowd crowd_of(const std::vector<const CrowdLevels::OfDraw*>& draws, std::uint32_t characters) {
  Crowd crowd;
  crowd.levels = draws.front()->levels;
  std::vector<double> squares(crowd.levels.size(), 0);
  double area = 0;
  for (const CrowdLevels::OfDraw* draw : draws) {
    crowd.draws.push_back(draw->draw);
    area += static_cast<double>(draw->area);
    for (std::size_t l = 0; l < std::min(squares.size(), draw->levels.size()); ++l) {
      const CrowdLevel& of = draw->levels[l];
      squares[l] += static_cast<double>(draw->area) * static_cast<double>(of.rms) * static_cast<double>(of.rms);
      if (draw == draws.front()) continue;
      CrowdLevel& all = crowd.levels[l];
      all.triangles = sum(all.triangles, of.triangles);
      all.vertices = sum(all.vertices, of.vertices);
      all.largest = std::max(all.largest, of.largest);
    }
  }
  std::uint32_t finest = 0;
  for (std::size_t l = 0; l < squares.size(); ++l) {
    if (draws.size() > 1 && area > 0) crowd.levels[l].rms = static_cast<float>(std::sqrt(squares[l] / area));
    finest = std::max(finest, crowd.levels[l].triangles);
  }
  crowd.budget = std::uint64_t{characters} * finest;
  return crowd;
}

}  // namespace

std::vector<Crowd> crowds_of(const CrowdLevels& levels) {
  std::map<std::uint32_t, std::vector<const CrowdLevels::OfDraw*>> together;
  for (const CrowdLevels::OfDraw& draw : levels.draws) together[draw.crowd].push_back(&draw);
  std::vector<Crowd> crowds;
  for (const auto& [number, draws] : together) crowds.push_back(crowd_of(draws, levels.characters));
  return crowds;
}

}  // namespace foredraw

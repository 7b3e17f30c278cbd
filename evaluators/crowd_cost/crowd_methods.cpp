#include "crowd_methods.h"

#include <foredraw/runtime/tessellation_level.h>

#include <algorithm>
#include <stdexcept>

namespace foredraw {

CrowdChooser::CrowdChooser(CrowdMethod method, const Crowd& crowd, std::uint32_t characters, foredraw_spacing spacing,
                           float hysteresis)
    : method_(method), crowd_(crowd), characters_(characters), spacing_(spacing), hysteresis_(hysteresis) {
  std::vector<foredraw_crowd_level> levels;
  for (const CrowdLevel& level : crowd.levels) levels.push_back({level.triangles, level.rms});
  if (foredraw_crowd_prepare(levels.data(), static_cast<std::uint32_t>(levels.size()), &table_) == 0) {
    throw std::invalid_argument(
        "the levels of the crowd do not make a table for crowd_select.h; run crowd-levels again");
  }
  memory_.resize(foredraw_crowd_memory(&table_) / sizeof(std::uint32_t) + 1);
}

bool CrowdChooser::is_able(CrowdMethod method, const Crowd& crowd) {
  const bool is_formula = method == CrowdMethod::paper || method == CrowdMethod::root;
  return !is_formula || crowd.levels.front().kind == CrowdClass::tessellated;
}

std::uint8_t CrowdChooser::by_formula(std::uint32_t instances) const {
  if (method_ == CrowdMethod::constant) return 0;
  const std::uint32_t most = crowd_.levels.front().number;
  const float level = method_ == CrowdMethod::paper ? foredraw_tessellation_by_count(characters_, most, instances)
                                                    : foredraw_tessellation_by_root(characters_, most, instances);
  const std::uint32_t parts = foredraw_tessellation_floor(level, spacing_);
  const auto found = std::ranges::find_if(crowd_.levels, [&](const CrowdLevel& row) { return row.number <= parts; });
  return static_cast<std::uint8_t>(found - crowd_.levels.begin());
}

void CrowdChooser::choose(std::span<const float> distances, std::span<const std::uint8_t> is_new) {
  const auto instances = static_cast<std::uint32_t>(distances.size());
  chosen_.resize(distances.size(), FOREDRAW_CROWD_NEW);
  if (method_ != CrowdMethod::exact && method_ != CrowdMethod::hysteresis) {
    std::ranges::fill(chosen_, by_formula(instances));
    return;
  }
  for (std::size_t i = 0; i < distances.size(); ++i) {
    if (is_new[i] != 0) chosen_[i] = FOREDRAW_CROWD_NEW;
  }
  foredraw_crowd_select(&table_, distances.data(), instances, crowd_.budget,
                        method_ == CrowdMethod::hysteresis ? hysteresis_ : 0, chosen_.data(), memory_.data());
}

}  // namespace foredraw

#include "layout.h"

#include <foredraw/scene/turn.h>

#include <array>
#include <cmath>

namespace foredraw::bench {

namespace {

float rounded(double value) { return static_cast<float>(std::floor(value * 1024 + 0.5) / 1024); }

}  // namespace

void Layout::add(std::size_t model, glm::dvec2 place, double height, const glm::quat& rotation, glm::vec3 scale,
                 Random& random) {
  const bool is_mirrored = random.unit() < options_.mirrored;
  if (is_full()) return;
  if (is_mirrored) scale.x = -scale.x;
  Placement& placement = placements_.emplace_back();
  placement.model = model;
  placement.transform = {{rounded(place.x), rounded(height), rounded(place.y)}, rotation, scale};
  instances_ += kit_.models[model].primitives;
}

glm::quat quarter_turn(std::uint64_t quarters) {
  constexpr float half = 0.70710678f;
  constexpr std::array<std::array<float, 2>, 4> turns = {{{1, 0}, {half, half}, {0, 1}, {-half, half}}};
  const auto [w, y] = turns[quarters % 4];
  return glm::quat(w, 0, y, 0);
}

glm::quat turned(double angle) {
  const Turn half = turn_by(angle / 2);
  return glm::quat(static_cast<float>(half.cosine), 0, static_cast<float>(half.sine), 0);
}

}  // namespace foredraw::bench

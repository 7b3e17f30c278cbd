#include "solid_noise.h"
#include "surfaces.h"

#include <algorithm>
#include <cmath>

namespace foredraw::bench {

namespace {

/// How far a place is from the edge of its stone or plank, 0 to 0.5, where rows of them are shifted by half.
glm::dvec2 inside(const glm::dvec2& at, double columns, double rows) {
  const double y = at.y * rows, row = std::floor(y);
  const double x = at.x * columns + (std::fmod(row, 2) == 0 ? 0 : 0.5);
  return {0.5 - std::abs(x - std::floor(x) - 0.5), 0.5 - std::abs(y - row - 0.5)};
}

double bands(double value) { return std::abs(2 * (value - std::floor(value)) - 1); }

}  // namespace

Pattern bark_pattern() {
  return [](const glm::dvec2& at) {
    const double ridges = tiled_noise(at, {10, 2}, 4, 11);
    return std::clamp(1.4 * std::abs(2 * ridges - 1) + 0.2 * tiled_noise(at, {32, 32}, 2, 12), 0.0, 1.0);
  };
}

Pattern leaf_pattern() {
  return [](const glm::dvec2& at) { return bands(3 * tiled_noise(at, {12, 12}, 2, 21)); };
}

Pattern stone_pattern() {
  return [](const glm::dvec2& at) { return tiled_noise(at, {6, 6}, 5, 31); };
}

Pattern marble_pattern() {
  return [](const glm::dvec2& at) {
    const double vein = bands(at.x + 2 * at.y + 2 * tiled_noise(at, {3, 3}, 5, 41));
    return 1 - (1 - vein) * (1 - vein) * (1 - vein);
  };
}

Pattern plank_pattern() {
  return [](const glm::dvec2& at) {
    const glm::dvec2 edge = inside(at, 2, 6);
    const double joint = std::min(1.0, 25 * std::min(edge.x * 3, edge.y));
    return joint * (0.35 + 0.65 * bands(4 * tiled_noise(at, {2, 24}, 3, 51)));
  };
}

Pattern plaster_pattern() {
  return [](const glm::dvec2& at) { return 0.5 + 0.5 * (tiled_noise(at, {24, 24}, 3, 61) - 0.5); };
}

Pattern cloth_pattern() {
  return [](const glm::dvec2& at) {
    const double warp = bands(32 * at.x), weft = bands(32 * at.y);
    const bool is_above = (static_cast<int>(32 * at.x) + static_cast<int>(32 * at.y)) % 2 == 0;
    return 0.2 + 0.6 * (is_above ? 1 - warp : 1 - weft) + 0.2 * tiled_noise(at, {64, 64}, 1, 71);
  };
}

Pattern paving_pattern() {
  return [](const glm::dvec2& at) {
    const glm::dvec2 edge = inside(at, 4, 8);
    const double stone = std::min(1.0, 12 * std::min(edge.x, edge.y));
    return stone * (0.6 + 0.4 * tiled_noise(at, {8, 8}, 4, 81));
  };
}

Pattern soil_pattern() {
  return [](const glm::dvec2& at) {
    return std::clamp(0.5 * tiled_noise(at, {4, 4}, 4, 91) + 0.5 * bands(2 * tiled_noise(at, {40, 40}, 2, 92)), 0.0,
                      1.0);
  };
}

}  // namespace foredraw::bench

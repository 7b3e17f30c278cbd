#include "solid_noise.h"

#include <foredraw/base/random.h>

#include <cmath>

namespace foredraw::bench {

namespace {

double value_at(std::int64_t x, std::int64_t y, std::int64_t z, std::uint64_t seed) {
  const auto row = static_cast<std::uint64_t>(x) * 0x9e3779b1u + static_cast<std::uint64_t>(y);
  return 2 * Random(derive_seed(seed, row, static_cast<std::uint64_t>(z))).unit() - 1;
}

double smooth(double t) { return t * t * (3 - 2 * t); }

double between(double a, double b, double t) { return a + (b - a) * t; }

std::int64_t whole(double value) { return static_cast<std::int64_t>(std::floor(value)); }

}  // namespace

double noise(const glm::dvec3& place, std::uint64_t seed) {
  const std::int64_t x = whole(place.x), y = whole(place.y), z = whole(place.z);
  const double tx = smooth(place.x - static_cast<double>(x)), ty = smooth(place.y - static_cast<double>(y)),
               tz = smooth(place.z - static_cast<double>(z));
  double layers[2];
  for (int k = 0; k < 2; ++k) {
    const double near = between(value_at(x, y, z + k, seed), value_at(x + 1, y, z + k, seed), tx);
    const double far = between(value_at(x, y + 1, z + k, seed), value_at(x + 1, y + 1, z + k, seed), tx);
    layers[k] = between(near, far, ty);
  }
  return between(layers[0], layers[1], tz);
}

double rough_noise(const glm::dvec3& place, int octaves, std::uint64_t seed) {
  double sum = 0, most = 0, scale = 1, height = 1;
  for (int i = 0; i < octaves; ++i) {
    sum += height * noise(scale * place, seed + static_cast<std::uint64_t>(i));
    most += height;
    scale *= 2;
    height /= 2;
  }
  return sum / most;
}

double tiled_noise(const glm::dvec2& place, const glm::ivec2& cells, int octaves, std::uint64_t seed) {
  double sum = 0, most = 0, height = 1;
  std::int64_t wide = cells.x, high = cells.y;
  for (int i = 0; i < octaves; ++i) {
    const double x = place.x * static_cast<double>(wide), y = place.y * static_cast<double>(high);
    const std::int64_t left = whole(x), top = whole(y);
    const auto value = [&](std::int64_t column, std::int64_t row) {
      return value_at(((column % wide) + wide) % wide, ((row % high) + high) % high, i, seed);
    };
    const double tx = smooth(x - static_cast<double>(left)), ty = smooth(y - static_cast<double>(top));
    sum += height * between(between(value(left, top), value(left + 1, top), tx),
                            between(value(left, top + 1), value(left + 1, top + 1), tx), ty);
    most += height;
    height /= 2;
    wide *= 2;
    high *= 2;
  }
  return 0.5 + 0.5 * sum / most;
}

}  // namespace foredraw::bench

#include <foredraw/viewing/view_directions.h>

#include <foredraw/base/random.h>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

// Only + - * / and sqrt touch the directions: IEEE 754 rounds these alike everywhere, which it does not promise of
// sin and cos.

namespace foredraw {

namespace {

Directions turned(const glm::dmat3& by, std::span<const glm::dvec3> directions) {
  Directions result;
  for (const glm::dvec3& direction : directions) {
    result.push_back(normalised(by[0] * direction.x + by[1] * direction.y + by[2] * direction.z));
  }
  return result;
}

}  // namespace

glm::dvec3 normalised(const glm::dvec3& v) { return v / std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

double cosine_of_degrees(double angle) {
  // By its series at a 64th of the angle, doubled six times.
  const double x = angle * (3.141592653589793 / 180 / 64);
  const double square = x * x;
  double term = 1;
  double cosine = 1;
  for (int n = 2; n <= 10; n += 2) {
    term *= -square / (n * (n - 1));
    cosine += term;
  }
  for (int doubled = 0; doubled < 6; ++doubled) cosine = 2 * cosine * cosine - 1;
  return cosine;
}

Directions icosphere_directions(std::size_t count) {
  const double golden = (1 + std::sqrt(5.0)) / 2;
  Directions vertices;
  for (const glm::dvec3& v :
       {glm::dvec3(-1, golden, 0), glm::dvec3(1, golden, 0), glm::dvec3(-1, -golden, 0), glm::dvec3(1, -golden, 0),
        glm::dvec3(0, -1, golden), glm::dvec3(0, 1, golden), glm::dvec3(0, -1, -golden), glm::dvec3(0, 1, -golden),
        glm::dvec3(golden, 0, -1), glm::dvec3(golden, 0, 1), glm::dvec3(-golden, 0, -1), glm::dvec3(-golden, 0, 1)}) {
    vertices.push_back(normalised(v));
  }
  using Face = std::array<std::size_t, 3>;
  std::vector<Face> faces = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                             {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                             {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  while (vertices.size() < count) {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
    const auto middle = [&](std::size_t a, std::size_t b) {
      const auto [it, is_new] = middles.try_emplace(std::minmax(a, b), vertices.size());
      if (is_new) vertices.push_back(normalised(vertices[a] + vertices[b]));
      return it->second;
    };
    std::vector<Face> finer;
    for (const auto& [a, b, c] : faces) {
      const std::size_t ab = middle(a, b);
      const std::size_t bc = middle(b, c);
      const std::size_t ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    faces = std::move(finer);
  }
  return vertices;
}

Directions fibonacci_directions(std::size_t count, double angle) {
  // The golden angle, pi * (3 - sqrt(5)), is turned step by step as a complex number, brought back to length 1 each
  // time.
  constexpr double cos_golden_angle = -0.7373688780783199015;
  constexpr double sin_golden_angle = 0.6754902942615236423;
  const double half_height = angle == 180 ? 1 : (1 - cosine_of_degrees(angle)) / 2;
  Directions directions;
  double c = 1;
  double s = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double y = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(count) * half_height;
    const double r = std::sqrt(1 - y * y);
    directions.push_back(normalised({r * c, y, r * s}));
    const double turned_c = c * cos_golden_angle - s * sin_golden_angle;
    const double turned_s = c * sin_golden_angle + s * cos_golden_angle;
    const double length = std::sqrt(turned_c * turned_c + turned_s * turned_s);
    c = turned_c / length;
    s = turned_s / length;
  }
  return directions;
}

Directions axis_directions() { return {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}; }

Directions random_directions(std::size_t count, std::uint64_t seed) {
  // Points of the cube, those outside of the ball (and too near its centre to have a direction) thrown away.
  Random random(seed);
  Directions directions;
  while (directions.size() < count) {
    const double x = 2 * random.unit() - 1;
    const double y = 2 * random.unit() - 1;
    const double z = 2 * random.unit() - 1;
    const double square = x * x + y * y + z * z;
    if (square <= 1 && square >= 1e-6) directions.push_back(normalised({x, y, z}));
  }
  return directions;
}

Directions turned_to(const glm::dvec3& axis, std::span<const glm::dvec3> directions) {
  const glm::dvec3 beside = std::abs(axis.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
  const glm::dvec3 z = normalised(glm::cross(beside, axis));
  return turned({glm::cross(axis, z), axis, z}, directions);
}

Directions turned_at_random(std::span<const glm::dvec3> directions, std::uint64_t seed) {
  // A unit quaternion, uniform like random_directions() with one dimension more.
  Random random(seed);
  double w = 0, x = 0, y = 0, z = 0, square = 0;
  do {
    w = 2 * random.unit() - 1;
    x = 2 * random.unit() - 1;
    y = 2 * random.unit() - 1;
    z = 2 * random.unit() - 1;
    square = w * w + x * x + y * y + z * z;
  } while (square > 1 || square < 1e-6);
  const double s = 2 / square;
  return turned({{1 - s * (y * y + z * z), s * (x * y + w * z), s * (x * z - w * y)},
                 {s * (x * y - w * z), 1 - s * (x * x + z * z), s * (y * z + w * x)},
                 {s * (x * z + w * y), s * (y * z - w * x), 1 - s * (x * x + y * y)}},
                directions);
}

}  // namespace foredraw

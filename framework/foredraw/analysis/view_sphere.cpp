#include <foredraw/analysis/view_sphere.h>

#include <foredraw/base/diagnostics.h>
#include <foredraw/base/random.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <vector>

// Only + - * / and sqrt touch the directions: IEEE 754 rounds these alike everywhere, which it does not promise of
// sin and cos.

namespace foredraw {

namespace {

using Directions = std::vector<glm::dvec3>;

constexpr std::array icosphere_counts = {12, 42, 162, 642, 2562};
constexpr int default_icosphere = 162;
constexpr int default_count = 100;
constexpr int axis_count = 6;

glm::dvec3 normalised(const glm::dvec3& v) { return v / std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

std::optional<int> as_number(const std::string& text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

/// The number of views that an icosphere set asks for, spelled as a bare number or by its count.
int icosphere_count(const ViewSet& set) {
  if (const auto number = as_number(set.views)) return *number;
  return set.count.value_or(default_icosphere);
}

bool is_icosphere(const ViewSet& set) { return set.views == "icosphere" || as_number(set.views); }

/// The vertices of an icosahedron, then of its refinements: each step halves every edge and lifts the middle onto the
/// sphere, so that the coarser set is the beginning of the finer one.
Directions icosphere(std::size_t count) {
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

/// Points on a spiral from +Y to -Y, each in the middle of its own slice of equal area (Swinbank and Purser 2006). The
/// golden angle is turned step by step as a complex number, brought back to length 1 each time.
Directions fibonacci(std::size_t count) {
  constexpr double cos_golden_angle = -0.7373688780783199015;  // of pi * (3 - sqrt(5))
  constexpr double sin_golden_angle = 0.6754902942615236423;
  Directions directions;
  double c = 1;
  double s = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double y = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(count);
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

Directions axes() { return {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}; }

/// Uniform on the sphere: points of the cube, those outside of the ball (and too near its centre to have a direction)
/// thrown away.
Directions random_directions(std::size_t count, std::uint64_t seed) {
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

Directions directions_of(const ViewSet& set) {
  if (is_icosphere(set)) return icosphere(static_cast<std::size_t>(icosphere_count(set)));
  if (set.views == "axes") return axes();
  const auto count = static_cast<std::size_t>(set.count.value_or(default_count));
  if (set.views == "random") return random_directions(count, static_cast<std::uint64_t>(set.seed));
  return fibonacci(count);
}

}  // namespace

std::optional<std::string> mistake_in(const ViewSet& set) {
  static const std::vector<std::string> words = {"icosphere", "fibonacci", "axes", "random"};
  if (is_icosphere(set)) {
    const int count = icosphere_count(set);
    if (set.count && *set.count != count) {
      return "views is " + set.views + ", but count is " + std::to_string(*set.count) + "; leave one of them out";
    }
    if (std::find(icosphere_counts.begin(), icosphere_counts.end(), count) == icosphere_counts.end()) {
      return "an icosphere has 12, 42, 162, 642 or 2562 views, not " + std::to_string(count);
    }
  } else if (std::find(words.begin(), words.end(), set.views) == words.end()) {
    const std::string_view meant = nearest(set.views, words);
    return "there is no view set '" + set.views + "'; " +
           (meant.empty() ? "expected icosphere, fibonacci, axes, random or a number"
                          : "did you mean '" + std::string(meant) + "'?");
  } else if (set.views == "axes" && set.count.value_or(axis_count) != axis_count) {
    return "there are 6 views along the axes, not " + std::to_string(*set.count);
  } else if (set.count && *set.count < 1) {
    return "count is " + std::to_string(*set.count) + ", but there must be 1 view at least";
  }
  if (set.distance && !(*set.distance > 1 && std::isfinite(*set.distance))) {
    return "distance is " + std::to_string(*set.distance) +
           " bounding-sphere radii, but the camera must stand outside of the sphere (more than 1)";
  }
  if (set.size < 1) return "size is " + std::to_string(set.size) + ", but there must be 1 pixel at least";
  return std::nullopt;
}

Views make_views(const ViewSet& set) {
  Views views;
  views.size = set.size;
  for (const glm::dvec3& direction : directions_of(set)) views.views.push_back({direction, set.distance.value_or(0)});
  return views;
}

}  // namespace foredraw

#include <foredraw/analysis/surface_distance.h>

#include <foredraw/base/random.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace foredraw {

namespace {

using Point = glm::dvec3;
using Triangle = std::array<Point, 3>;

constexpr std::size_t most_in_leaf = 4;

bool is_finite(const Point& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

std::vector<Triangle> finite_triangles(const Surface& surface) {
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i + 3 <= surface.indices.size(); i += 3) {
    Triangle corners;
    for (std::size_t c = 0; c < 3; ++c) corners[c] = Point(surface.positions[surface.indices[i + c]]);
    if (std::ranges::all_of(corners, is_finite)) triangles.push_back(corners);
  }
  return triangles;
}

/// Of a point to a triangle, squared; after Ericson, Real-Time Collision Detection, section 5.1.5. Where the triangle
/// is a line or a point, the fractions of its edges decide.
double squared_distance(const Point& p, const Triangle& t) {
  const auto squared = [](const Point& v) { return glm::dot(v, v); };
  const auto to_edge = [&](const Point& from, const Point& to) {
    const Point edge = to - from;
    const double length = squared(edge);
    const double along = length > 0 ? std::clamp(glm::dot(p - from, edge) / length, 0.0, 1.0) : 0;
    return squared(p - (from + along * edge));
  };
  const Point normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double area = squared(normal);
  if (area > 0) {
    bool is_inside = true;
    for (std::size_t c = 0; c < 3; ++c) {
      const Point edge = t[(c + 1) % 3] - t[c];
      is_inside = is_inside && glm::dot(glm::cross(edge, p - t[c]), normal) >= 0;
    }
    if (is_inside) {
      const double height = glm::dot(p - t[0], normal);
      return height * height / area;
    }
  }
  return std::min({to_edge(t[0], t[1]), to_edge(t[1], t[2]), to_edge(t[2], t[0])});
}

struct Box {
  Point low{std::numeric_limits<double>::infinity()};
  Point high{-std::numeric_limits<double>::infinity()};

  void add(const Point& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  double squared_distance(const Point& p) const {
    const Point out = glm::max(glm::max(low - p, p - high), Point(0));
    return glm::dot(out, out);
  }
};

}  // namespace

struct ClosestPoints::Tree {
  struct Node {
    Box box;
    std::uint32_t first = 0;  ///< triangle
    std::uint32_t count = 0;  ///< 0: the two nodes at `child`
    std::uint32_t child = 0;
  };
  std::vector<Triangle> triangles;
  std::vector<Node> nodes;

  explicit Tree(std::vector<Triangle> of) : triangles(std::move(of)) {
    if (triangles.empty()) return;
    nodes.emplace_back();
    split(0, 0, static_cast<std::uint32_t>(triangles.size()));
  }

  /// By halves at the middle of the longest side, so no deeper than the triangles' number has bits.
  void split(std::size_t at, std::uint32_t first, std::uint32_t count) {
    Box box, middles;
    for (std::uint32_t i = first; i < first + count; ++i) {
      for (const Point& corner : triangles[i]) box.add(corner);
      middles.add(middle(triangles[i]));
    }
    nodes[at].box = box;
    nodes[at].first = first;
    nodes[at].count = count;
    if (count <= most_in_leaf) return;
    const Point size = middles.high - middles.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto begin = triangles.begin() + first;
    std::nth_element(begin, begin + count / 2, begin + count,
                     [axis](const Triangle& a, const Triangle& b) { return middle(a)[axis] < middle(b)[axis]; });
    const auto child = static_cast<std::uint32_t>(nodes.size());
    nodes[at].count = 0;
    nodes[at].child = child;
    nodes.resize(nodes.size() + 2);
    split(child, first, count / 2);
    split(child + 1, first + count / 2, count - count / 2);
  }

  static Point middle(const Triangle& t) { return (t[0] + t[1] + t[2]) / 3.0; }

  double squared_distance(const Point& p) const {
    double nearest = std::numeric_limits<double>::infinity();
    if (nodes.empty()) return nearest;
    std::array<std::uint32_t, 128> open;
    std::size_t size = 0;
    open[size++] = 0;
    while (size > 0) {
      const Node& node = nodes[open[--size]];
      if (node.box.squared_distance(p) >= nearest) continue;
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        nearest = std::min(nearest, foredraw::squared_distance(p, triangles[i]));
      }
      if (node.count > 0) continue;
      const bool second_first =
          nodes[node.child + 1].box.squared_distance(p) < nodes[node.child].box.squared_distance(p);
      open[size++] = node.child + (second_first ? 0 : 1);
      open[size++] = node.child + (second_first ? 1 : 0);
    }
    return nearest;
  }
};

ClosestPoints::ClosestPoints(const Surface& surface) : tree_(std::make_unique<const Tree>(finite_triangles(surface))) {}
ClosestPoints::~ClosestPoints() = default;

double ClosestPoints::distance(glm::dvec3 point) const { return std::sqrt(tree_->squared_distance(point)); }

namespace {

struct OneWay {
  double largest = 0;
  double mean_square = 0;
  double variance = 0;  ///< of that mean
};

/// Evenly by area: each of as many equal parts of the area gives a point.
std::vector<Point> points_on(const std::vector<Triangle>& triangles, std::size_t count, Random random) {
  std::vector<double> sums;
  double sum = 0;
  for (const Triangle& t : triangles) sums.push_back(sum += glm::length(glm::cross(t[1] - t[0], t[2] - t[0])));
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double at = sum * (static_cast<double>(i) + random.unit()) / static_cast<double>(count);
    const auto chosen = static_cast<std::size_t>(std::upper_bound(sums.begin(), sums.end(), at) - sums.begin());
    const Triangle& t = triangles[std::min(chosen, triangles.size() - 1)];
    const double root = std::sqrt(random.unit());
    const double along = random.unit();
    points.push_back((1 - root) * t[0] + root * (1 - along) * t[1] + root * along * t[2]);
  }
  return points;
}

std::vector<double> distances(const std::vector<Point>& points, const ClosestPoints& to, const Executor& executor) {
  constexpr std::size_t at_a_time = 256;
  std::vector<double> result(points.size());
  executor.for_each((points.size() + at_a_time - 1) / at_a_time, [&](std::size_t part) {
    const std::size_t end = std::min(points.size(), (part + 1) * at_a_time);
    for (std::size_t i = part * at_a_time; i < end; ++i) result[i] = to.distance(points[i]);
  });
  return result;
}

OneWay one_way(const std::vector<Triangle>& from, const ClosestPoints& to, std::size_t samples, std::uint64_t seed,
               const Executor& executor) {
  OneWay result;
  const std::vector<double> sampled = distances(points_on(from, samples, Random(seed)), to, executor);
  const auto count = static_cast<double>(sampled.size());
  for (const double d : sampled) {
    result.largest = std::max(result.largest, d);
    result.mean_square += d * d / count;
  }
  for (const double d : sampled) {
    const double deviation = d * d - result.mean_square;
    if (count > 1) result.variance += deviation * deviation / (count * (count - 1));
  }
  std::vector<Point> corners;
  for (const Triangle& t : from) corners.insert(corners.end(), t.begin(), t.end());
  for (const double d : distances(corners, to, executor)) result.largest = std::max(result.largest, d);
  return result;
}

}  // namespace

std::optional<SurfaceDistance> surface_distance(const Surface& a, const Surface& b,
                                                const SurfaceDistanceOptions& options, const Executor& executor) {
  const std::vector<Triangle> of_a = finite_triangles(a);
  const std::vector<Triangle> of_b = finite_triangles(b);
  if (of_a.empty() && of_b.empty()) return SurfaceDistance{};
  if (of_a.empty() || of_b.empty()) return std::nullopt;
  const std::size_t samples = std::max<std::size_t>(options.samples, 1);
  const OneWay there = one_way(of_a, ClosestPoints(b), samples, derive_seed(options.seed, 0, 0), executor);
  const OneWay back = one_way(of_b, ClosestPoints(a), samples, derive_seed(options.seed, 1, 0), executor);
  SurfaceDistance result;
  result.largest = std::max(there.largest, back.largest);
  result.rms = std::sqrt((there.mean_square + back.mean_square) / 2);
  if (result.rms > 0) result.rms_error = std::sqrt(there.variance + back.variance) / (4 * result.rms);
  return result;
}

}  // namespace foredraw

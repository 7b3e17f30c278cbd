#include "shells.h"

#include <foredraw/analysis/ray_tree.h>
#include <foredraw/geometry/finite.h>
#include <foredraw/geometry/joined_sets.h>
#include <foredraw/geometry/triangle_area.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace foredraw::processors::second_depth {

namespace {

/// An edge as one triangle has it.
struct Side {
  std::uint32_t low, high, triangle;
  std::int32_t way;  ///< 1: from low to high
};

std::vector<Side> sides_of(std::span<const std::uint32_t> points, std::span<const std::uint32_t> indices) {
  std::vector<Side> sides;
  sides.reserve(indices.size());
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const std::uint32_t from = points[indices[i]], to = points[indices[i % 3 == 2 ? i - 2 : i + 1]];
    if (from == to) continue;
    sides.push_back({std::min(from, to), std::max(from, to), static_cast<std::uint32_t>(i / 3), from < to ? 1 : -1});
  }
  std::ranges::sort(sides, {}, [](const Side& s) { return std::tuple(s.low, s.high, s.triangle, s.way); });
  return sides;
}

/// Calls each(the sides at one edge).
template <class Each>
void each_edge(std::span<const Side> sides, Each each) {
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high) ++end;
    each(sides.subspan(i, end - i));
    i = end;
  }
}

/// Calls unbalanced(shell) for each shell that has the edge more often one way than the other.
template <class Unbalanced>
void each_unbalanced(std::span<const Side> edge, JoinedSets& shells, Unbalanced unbalanced) {
  if (edge.size() == 2 && edge[0].way + edge[1].way == 0 && shells.of(edge[0].triangle) == shells.of(edge[1].triangle))
    return;  // nearly all are so
  std::vector<std::pair<std::uint32_t, std::int32_t>> ways;
  for (const Side& side : edge) ways.emplace_back(shells.of(side.triangle), side.way);
  std::ranges::sort(ways);
  for (std::size_t i = 0; i < ways.size();) {
    const std::uint32_t shell = ways[i].first;
    std::int32_t sum = 0;
    for (; i < ways.size() && ways[i].first == shell; ++i) sum += ways[i].second;
    if (sum != 0) unbalanced(shell);
  }
}

/// Sets of triangles; a shell is known by its first one.
JoinedSets joined(std::span<const Side> sides, std::size_t triangles) {
  JoinedSets shells(triangles);
  each_edge(sides, [&](std::span<const Side> edge) {
    if (edge.size() == 2 && edge[0].way + edge[1].way == 0) shells.join(edge[0].triangle, edge[1].triangle);
  });
  std::vector<std::pair<std::uint32_t, std::uint32_t>> together;  // not yet: an edge is asked of what it was found with
  each_edge(sides, [&](std::span<const Side> edge) {
    const std::uint32_t nobody = static_cast<std::uint32_t>(triangles);
    std::uint32_t first = nobody;
    each_unbalanced(edge, shells, [&](std::uint32_t shell) {
      if (first != nobody) together.emplace_back(first, shell);
      first = shell;
    });
  });
  for (const auto& [a, b] : together) shells.join(a, b);
  return shells;
}

/// From one of its own vertices, so that a shell far from the origin loses nothing.
Kind kind_by_volume(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                    std::span<const std::uint32_t> triangles) {
  constexpr double flat = 1e-6;  // of the volume that a cube of the same area has, about
  const glm::dvec3 origin(positions[indices[3 * std::size_t{triangles.front()}]]);
  double volume = 0, area = 0;
  for (const std::uint32_t t : triangles) {
    const auto corner = [&](std::size_t c) { return glm::dvec3(positions[indices[3 * std::size_t{t} + c]]) - origin; };
    const glm::dvec3 a = corner(0), b = corner(1), c = corner(2);
    volume += glm::dot(a, glm::cross(b, c)) / 6;
    area += triangle_area(a, b, c);
  }
  if (!(std::abs(volume) > flat * area * std::sqrt(area))) return Kind::flat;
  return volume > 0 ? Kind::closed : Kind::inside_out;
}

/// Whether the shell winds less than 0 times around a point in front of a triangle: two rays must say so.
bool is_turned(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
               std::span<const std::uint32_t> triangles, const Executor& executor, const std::atomic<bool>* cancel) {
  std::vector<std::uint32_t> corners;
  for (const std::uint32_t t : triangles) {
    for (std::size_t c = 0; c < 3; ++c) corners.push_back(indices[3 * std::size_t{t} + c]);
  }
  const RayTree tree(positions, corners, std::vector<Blocks>(triangles.size(), Blocks::both));
  // Of no plain ratio, so that no ray runs along what was built at right angles.
  const glm::dvec3 ways[] = {{0.5411961, 0.8191725, 0.3073}, {-0.7071, 0.2937, 0.6432}};
  const auto is_turned_at = [&](std::uint32_t i) {
    const auto corner = [&](std::size_t c) { return glm::dvec3(positions[corners[3 * std::size_t{i} + c]]); };
    const glm::dvec3 a = corner(0), b = corner(1), c = corner(2), normal = glm::cross(b - a, c - a);
    return std::ranges::all_of(ways, [&](const glm::dvec3& way) {
      const double side = glm::dot(normal, way);
      return side != 0 && tree.winding({(a + b + c) / 3.0, side > 0 ? way : -way, 0, i}) < 0;
    });
  };
  constexpr std::size_t at_once = 4096;
  std::atomic<bool> is_found = false;
  executor.for_each((triangles.size() + at_once - 1) / at_once, [&](std::size_t chunk) {
    const std::size_t end = std::min(triangles.size(), (chunk + 1) * at_once);
    for (std::size_t i = chunk * at_once; i < end && !is_found; ++i) {
      if (cancel != nullptr && cancel->load(std::memory_order_relaxed)) return;
      if (is_turned_at(static_cast<std::uint32_t>(i))) is_found = true;
    }
  });
  return is_found;
}

}  // namespace

std::vector<Kind> kinds_of(std::span<const glm::vec3> positions, std::span<const std::uint32_t> points,
                           std::span<const std::uint32_t> indices, const Limits& limits) {
  const std::size_t count = indices.size() / 3;
  const std::vector<Side> sides = sides_of(points, indices.first(3 * count));
  JoinedSets shells = joined(sides, count);
  std::vector<bool> is_open(count, false);  // [shell]
  each_edge(sides, [&](std::span<const Side> edge) {
    each_unbalanced(edge, shells, [&](std::uint32_t shell) { is_open[shell] = true; });
  });
  std::vector<std::vector<std::uint32_t>> triangles(count);  // [shell]
  for (std::uint32_t t = 0; t < count; ++t) {
    const std::uint32_t shell = shells.of(t);
    triangles[shell].push_back(t);
    for (std::size_t c = 0; c < 3; ++c) {
      if (!is_finite(positions[indices[3 * std::size_t{t} + c]])) is_open[shell] = true;
    }
  }
  std::vector<Kind> kinds(count, Kind::open);
  std::vector<std::uint32_t> closed;
  for (std::uint32_t shell = 0; shell < count; ++shell) {
    if (!triangles[shell].empty() && !is_open[shell]) closed.push_back(shell);
  }
  const Executor one_thread(1);
  const Executor& executor = limits.executor != nullptr ? *limits.executor : one_thread;
  std::atomic<std::size_t> done = 0;
  const auto judge = [&](std::size_t i) {
    const std::vector<std::uint32_t>& its = triangles[closed[i]];
    Kind kind = kind_by_volume(positions, indices, its);
    if (kind == Kind::closed && is_turned(positions, indices, its, executor, limits.cancel)) kind = Kind::turned;
    for (const std::uint32_t t : its) kinds[t] = kind;
    const std::size_t judged = done += its.size();
    if (limits.progress) limits.progress(static_cast<double>(judged) / static_cast<double>(count));
  };
  executor.for_each(closed.size(), judge);
  return kinds;
}

}  // namespace foredraw::processors::second_depth

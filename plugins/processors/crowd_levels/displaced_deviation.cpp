#include "displaced_deviation.h"

#include <foredraw/geometry/finite.h>
#include <foredraw/geometry/triangle_area.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace foredraw {

namespace {

/// Where a point of the finest pattern lies in a coarser one.
struct Between {
  std::array<std::uint32_t, 3> points{};
  std::array<double, 3> weights{};
};

struct Pattern {
  std::vector<TessellationPoint> points;
  std::vector<Between> finest;  ///< [point of the finest pattern]
};

TessellationPattern pattern_of(std::uint32_t parts) {
  const auto level = static_cast<float>(parts);
  return tessellation_pattern({{level, level, level}, level}, TessellationSpacing::equal);
}

/// Twice the area, in units of the pattern.
double area(const TessellationPoint& a, const TessellationPoint& b, const TessellationPoint& c) {
  const auto across = [](std::uint32_t x, std::uint32_t y) { return double(x) - double(y); };
  return across(b.u, a.u) * across(c.v, a.v) - across(b.v, a.v) * across(c.u, a.u);
}

/// In the triangle of the pattern in which the point lies most; weights of whole numbers, so that none is lost between
/// two.
Between between(const TessellationPattern& pattern, const TessellationPoint& point) {
  Between best;
  double least = -2;
  for (const auto& corners : pattern.triangles) {
    const TessellationPoint &a = pattern.points[corners[0]], &b = pattern.points[corners[1]],
                            &c = pattern.points[corners[2]];
    const double whole = area(a, b, c);
    if (whole == 0) continue;
    const std::array<double, 3> weights{area(point, b, c) / whole, area(a, point, c) / whole,
                                        area(a, b, point) / whole};
    const double inside = *std::ranges::min_element(weights);
    if (inside <= least) continue;
    least = inside;
    best = {{corners[0], corners[1], corners[2]}, weights};
    if (inside >= 0) break;
  }
  return best;
}

double area_of(const MovedSurface& surface, std::size_t triangle) {
  const std::uint32_t* v = &surface.indices[3 * triangle];
  return triangle_area(surface.positions[v[0]], surface.positions[v[1]], surface.positions[v[2]]);
}

/// Points of the pattern on some triangles, moved: [triangle - first][point].
std::vector<glm::vec3> moved(const MovedSurface& surface, const std::vector<TessellationPoint>& points,
                             std::uint32_t first, std::uint32_t end, bool is_moved = true) {
  TessellatedMesh mesh;
  for (std::uint32_t t = first; t < end; ++t) {
    for (const TessellationPoint& at : points) mesh.samples.push_back({t, at});
  }
  const std::vector<float> by =
      is_moved ? displacements(mesh, surface.indices, surface.places, surface.map, surface.factor, surface.offset)
               : std::vector<float>(mesh.samples.size(), 0);
  return displaced_positions(mesh, surface.indices, surface.positions, surface.directions, by);
}

struct Sums {
  double largest = 0, squares = 0, area = 0;

  void add(const Sums& other) {
    largest = std::max(largest, other.largest);
    squares += other.squares;
    area += other.area;
  }
};

/// The same weight for all points of a triangle.
void add(Sums& sums, double area, std::span<const glm::vec3> finest, const auto& coarser) {
  double squares = 0;
  for (std::size_t i = 0; i < finest.size(); ++i) {
    const glm::dvec3 off = glm::dvec3(finest[i]) - coarser(i);
    const double squared = glm::dot(off, off);
    squares += squared;
    sums.largest = std::max(sums.largest, std::sqrt(squared));
  }
  sums.squares += area * squares / static_cast<double>(finest.size());
  sums.area += area;
}

}  // namespace

double area_of(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices) {
  double sum = 0;
  for (std::size_t t = 0; 3 * t + 2 < indices.size(); ++t) {
    const std::uint32_t* v = &indices[3 * t];
    const double area = triangle_area(positions[v[0]], positions[v[1]], positions[v[2]]);
    if (std::isfinite(area)) sum += area;
  }
  return sum;
}

std::vector<Deviation> displaced_deviations(const MovedSurface& surface, std::span<const std::uint32_t> parts,
                                            std::uint32_t finest, const Executor& executor) {
  constexpr std::uint32_t chunk = 64;
  const TessellationPattern fine = pattern_of(finest);
  std::vector<Pattern> patterns;
  for (const std::uint32_t of : parts) {
    const TessellationPattern made = pattern_of(of);
    Pattern& pattern = patterns.emplace_back();
    pattern.points = made.points;
    for (const TessellationPoint& point : fine.points) pattern.finest.push_back(between(made, point));
  }
  const auto triangles = static_cast<std::uint32_t>(surface.indices.size() / 3);
  const std::uint32_t chunks = (triangles + chunk - 1) / chunk;
  std::vector<std::vector<Sums>> sums(chunks, std::vector<Sums>(1 + parts.size()));
  executor.for_each(chunks, [&](std::size_t number) {
    const auto first = static_cast<std::uint32_t>(number) * chunk, end = std::min(first + chunk, triangles);
    const std::vector<glm::vec3> there = moved(surface, fine.points, first, end);
    const std::vector<glm::vec3> flat = moved(surface, fine.points, first, end, false);
    const auto on = [&](std::uint32_t t) {
      return std::span(there).subspan((t - first) * fine.points.size(), fine.points.size());
    };
    std::vector<std::uint32_t> finite;
    for (std::uint32_t t = first; t < end; ++t) {
      if (std::isfinite(area_of(surface, t)) &&
          std::ranges::all_of(on(t), [](const glm::vec3& p) { return is_finite(p); }))
        finite.push_back(t);
    }
    for (const std::uint32_t t : finite) {
      const glm::vec3* own = flat.data() + (t - first) * fine.points.size();
      add(sums[number][0], area_of(surface, t), on(t), [&](std::size_t i) { return glm::dvec3(own[i]); });
    }
    for (std::size_t p = 0; p < patterns.size(); ++p) {
      const Pattern& pattern = patterns[p];
      const std::vector<glm::vec3> corners = moved(surface, pattern.points, first, end);
      for (const std::uint32_t t : finite) {
        const glm::vec3* own = corners.data() + (t - first) * pattern.points.size();
        add(sums[number][1 + p], area_of(surface, t), on(t), [&](std::size_t i) {
          const Between& at = pattern.finest[i];
          return at.weights[0] * glm::dvec3(own[at.points[0]]) + at.weights[1] * glm::dvec3(own[at.points[1]]) +
                 at.weights[2] * glm::dvec3(own[at.points[2]]);
        });
      }
    }
  });
  std::vector<Deviation> found(1 + parts.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    Sums all;
    for (const auto& of : sums) all.add(of[i]);
    found[i] = {all.largest, all.area > 0 ? std::sqrt(all.squares / all.area) : 0};
  }
  return found;
}

}  // namespace foredraw

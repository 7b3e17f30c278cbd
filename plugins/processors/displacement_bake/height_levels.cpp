#include "height_levels.h"

#include <foredraw/geometry/triangle_area.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

namespace foredraw::processors::displacement_bake {

namespace {

constexpr TessellationSpacing spacing = TessellationSpacing::equal;

TessellationPattern pattern_of(std::size_t log) {
  const auto level = static_cast<float>(1u << log);
  return tessellation_pattern({{level, level, level}, level}, spacing);
}

/// Where a point of the finest pattern lies on a coarser one: between which points, and how much each counts.
struct Between {
  std::array<std::uint16_t, 3> points{};
  std::array<double, 3> weights{};
};

/// The corner of a 2-D triangle's area that lies across from each corner, over the whole.
std::array<double, 3> weights_in(const std::array<TessellationPoint, 3>& corners, const TessellationPoint& at) {
  const auto area = [](const TessellationPoint& a, const TessellationPoint& b, const TessellationPoint& c) {
    return (double(b.u) - a.u) * (double(c.v) - a.v) - (double(c.u) - a.u) * (double(b.v) - a.v);
  };
  const double whole = area(corners[0], corners[1], corners[2]);
  return {area(at, corners[1], corners[2]) / whole, area(corners[0], at, corners[2]) / whole,
          area(corners[0], corners[1], at) / whole};
}

/// [point of `fine`] on `coarse`.
std::vector<Between> laid_on(const TessellationPattern& fine, const TessellationPattern& coarse) {
  std::vector<Between> result;
  for (const TessellationPoint& at : fine.points) {
    Between best;
    double least = -std::numeric_limits<double>::infinity();
    for (const auto& triangle : coarse.triangles) {
      const auto weights =
          weights_in({coarse.points[triangle[0]], coarse.points[triangle[1]], coarse.points[triangle[2]]}, at);
      const double inside = std::min({weights[0], weights[1], weights[2]});
      if (!(inside > least)) continue;
      least = inside;
      best = {triangle, weights};
    }
    result.push_back(best);
  }
  return result;
}

/// [triangle][point of its pattern] the vertex of the mesh: as tessellated_mesh() emits triangles, pattern by pattern.
std::vector<std::uint32_t> pattern_vertices(const UniformHeights& heights, const TessellationPattern& pattern,
                                            std::size_t triangle) {
  std::vector<std::uint32_t> vertices(pattern.points.size());
  const std::uint32_t* corners = &heights.mesh.indices[3 * pattern.triangles.size() * triangle];
  for (std::size_t t = 0; t < pattern.triangles.size(); ++t) {
    for (std::size_t c = 0; c < 3; ++c) vertices[pattern.triangles[t][c]] = corners[3 * t + c];
  }
  return vertices;
}

double area_of(const Cage& cage, std::size_t triangle) {
  const std::uint32_t* v = &cage.indices[3 * triangle];
  return triangle_area(cage.positions[v[0]], cage.positions[v[1]], cage.positions[v[2]]);
}

/// From one level of a triangle to a finer one on its hull.
struct Step {
  double saved = 0;  ///< squared deviation times area
  double cost = 0;   ///< heights
  std::uint32_t triangle = 0;
  std::uint8_t to = 0;
};

/// Heights inside and on half of the edges, roughly: L^2 / 2.
double heights_at(std::size_t log) { return 0.5 * static_cast<double>(std::uint64_t{1} << (2 * log)); }

/// The steps along the lower hull of (heights, error), each less worth than the one before.
void add_steps(std::span<const double> errors, std::uint32_t triangle, std::vector<Step>& steps) {
  for (std::size_t at = 0; at + 1 < errors.size();) {
    std::size_t best = 0;
    double most = 0;
    for (std::size_t to = at + 1; to < errors.size(); ++to) {
      const double worth = (errors[at] - errors[to]) / (heights_at(to) - heights_at(at));
      if (worth > most) {
        most = worth;
        best = to;
      }
    }
    if (best == 0) return;
    steps.push_back(
        {errors[at] - errors[best], heights_at(best) - heights_at(at), triangle, static_cast<std::uint8_t>(best)});
    at = best;
  }
}

}  // namespace

std::vector<UniformHeights> uniform_heights(const Cage& cage, const Target& target, std::uint32_t finest,
                                            const Executor& executor) {
  std::vector<UniformHeights> result;
  const auto vertices = static_cast<std::uint32_t>(cage.positions.size());
  for (std::uint32_t level = 1; level <= finest; level *= 2) {
    const auto as = static_cast<float>(level);
    const std::vector<TessellationLevels> levels(cage.indices.size() / 3, {{as, as, as}, as});
    UniformHeights at{tessellated_mesh(cage.indices, vertices, levels, spacing), {}};
    at.heights = cast_heights(cage, at.mesh, target, executor);
    result.push_back(std::move(at));
  }
  return result;
}

std::vector<std::uint8_t> levels_for(const Cage& cage, std::span<const UniformHeights> heights, double rms) {
  const std::size_t triangles = cage.indices.size() / 3, finest = heights.size() - 1;
  std::vector<TessellationPattern> patterns;
  std::vector<std::vector<Between>> places;
  for (std::size_t log = 0; log <= finest; ++log) patterns.push_back(pattern_of(log));
  for (std::size_t log = 0; log < finest; ++log) places.push_back(laid_on(patterns[finest], patterns[log]));

  std::vector<Step> steps;
  double area = 0, error = 0;
  for (std::uint32_t t = 0; t < triangles; ++t) {
    const double of_triangle = area_of(cage, t);
    area += of_triangle;
    const auto fine = pattern_vertices(heights[finest], patterns[finest], t);
    std::vector<double> errors(finest + 1, 0);
    for (std::size_t log = 0; log < finest; ++log) {
      const auto coarse = pattern_vertices(heights[log], patterns[log], t);
      double sum = 0;
      for (std::size_t p = 0; p < fine.size(); ++p) {
        const Between& at = places[log][p];
        double between = 0;
        for (std::size_t c = 0; c < 3; ++c) between += at.weights[c] * heights[log].heights[coarse[at.points[c]]];
        const double off = heights[finest].heights[fine[p]] - between;
        sum += off * off;
      }
      errors[log] = of_triangle * sum / static_cast<double>(fine.size());
    }
    error += errors[0];
    add_steps(errors, t, steps);
  }
  std::ranges::sort(steps, [](const Step& a, const Step& b) {
    const double x = a.saved * b.cost, y = b.saved * a.cost;
    return x != y ? x > y : std::tie(a.triangle, a.to) < std::tie(b.triangle, b.to);
  });
  std::vector<std::uint8_t> levels(triangles, 0);
  const double wanted = rms * rms * area;
  for (const Step& step : steps) {
    if (error <= wanted) break;
    levels[step.triangle] = std::max(levels[step.triangle], step.to);
    error -= step.saved;
  }
  return levels;
}

}  // namespace foredraw::processors::displacement_bake

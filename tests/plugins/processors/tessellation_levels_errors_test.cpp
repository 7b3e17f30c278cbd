// Patterns of levels, and how far they are off.

#include "plugins/processors/tessellation_levels/pattern_samples.h"
#include "support/noisy_levels.h"

#include <foredraw/displaced/displaced_mesh.h>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace foredraw::tessellation_levels_errors_test {
namespace {

using testing::chosen;
using testing::noisy_grid;
using testing::NoisyMesh;
using testing::parts_of;

/// Calls visit with every combination there is.
template <class Visit>
void each_combination(std::uint8_t most, const Visit& visit) {
  for (std::uint8_t a = 0; a <= most; ++a) {
    for (std::uint8_t b = 0; b <= most; ++b) {
      for (std::uint8_t c = 0; c <= most; ++c) {
        for (std::uint8_t inner = 0; inner <= most; ++inner) visit(LogLevels{a, b, c, inner});
      }
    }
  }
}

TEST(TessellationLevels, CountTrianglesAsTheTessellatorDoes) {
  each_combination(6, [](const LogLevels& levels) {
    EXPECT_EQ(triangles_of(levels), tessellation_counts(parts_of(levels), TessellationSpacing::equal).triangles);
  });
}

TEST(TessellationLevels, FindTheirSamplesInEveryPattern) {
  for (const std::uint32_t parts : {4u, 16u, 64u}) {
    const auto samples = sample_points(parts);
    ASSERT_EQ(samples.size(), std::size_t{parts} * parts);
    each_combination(parts == 64 ? 2 : 6, [&](const LogLevels& levels) {
      if (parts == 16 && levels[1] > levels[0]) return;
      const TessellationPattern pattern = tessellation_pattern(parts_of(levels), TessellationSpacing::equal);
      const auto located = located_samples(pattern, parts);
      for (std::size_t s = 0; s < samples.size(); ++s) {
        double u = 0, v = 0;
        for (std::size_t c = 0; c < 3; ++c) {
          ASSERT_GE(located[s].weights[c], 0);
          u += double{located[s].weights[c]} * pattern.points[located[s].corners[c]].u;
          v += double{located[s].weights[c]} * pattern.points[located[s].corners[c]].v;
        }
        ASSERT_NEAR(u, samples[s].u, 0.05);
        ASSERT_NEAR(v, samples[s].v, 0.05);
      }
    });
  }
}

/// Of each triangle, over random points, by the tessellated mesh itself: which of its triangles has the point, and what
/// is linear between that one's corners.
double deviation_by_search(const NoisyMesh& mesh, std::span<const LogLevels> levels, std::size_t points) {
  std::vector<TessellationLevels> parts;
  for (const LogLevels& of : levels) parts.push_back(parts_of(of));
  const auto vertices = static_cast<std::uint32_t>(mesh.mesh.positions.size());
  const TessellatedMesh fine = tessellated_mesh(mesh.mesh.indices, vertices, parts, TessellationSpacing::equal);
  const std::vector<float> by = displacements(fine, mesh.mesh.indices, mesh.places, mesh.sampled, 1, 0);
  Random random(1);
  double squared = 0, areas = 0;
  std::size_t first = 0;
  for (std::size_t t = 0; t < levels.size(); ++t) {
    const std::uint32_t* corner = &mesh.mesh.indices[3 * t];
    const auto& at = mesh.mesh.positions;
    const double area = glm::length(glm::cross(at[corner[1]] - at[corner[0]], at[corner[2]] - at[corner[0]]));
    const std::size_t count = triangles_of(levels[t]);
    const auto place_of = [&](std::uint32_t v) -> std::array<double, 2> {
      for (std::size_t c = 0; c < 3; ++c) {
        if (corner[c] == v) return {c == 0 ? 1.0 : 0.0, c == 1 ? 1.0 : 0.0};
      }
      const SurfaceSample& sample = fine.samples[v - fine.kept];
      std::array<double, 3> weights{};
      for (std::size_t c = 0; c < 3; ++c) {  // on an edge it may be the neighbour's
        const std::uint32_t of = mesh.mesh.indices[3 * sample.triangle + c];
        for (std::size_t own = 0; own < 3; ++own) {
          if (corner[own] == of) weights[own] = sample.at.weights()[c] / 65536.0;
        }
      }
      return {weights[0], weights[1]};
    };
    double sum = 0;
    for (std::size_t i = 0; i < points; ++i) {
      double u = random.unit(), v = random.unit();
      if (u + v > 1) u = 1 - u, v = 1 - v;
      const TessellationPoint point{static_cast<std::uint32_t>(65536 * u), static_cast<std::uint32_t>(65536 * v)};
      u = point.u / 65536.0, v = point.v / 65536.0;
      double best = -1e9, linear = 0;
      for (std::size_t f = first; f < first + count; ++f) {
        std::array<std::array<double, 2>, 3> p;
        for (std::size_t c = 0; c < 3; ++c) p[c] = place_of(fine.indices[3 * f + c]);
        const auto cross = [&](const auto& a, const auto& b, double x, double y) {
          return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
        };
        const double whole = cross(p[0], p[1], p[2][0], p[2][1]);
        const std::array<double, 3> weight{cross(p[1], p[2], u, v) / whole, cross(p[2], p[0], u, v) / whole,
                                           cross(p[0], p[1], u, v) / whole};
        const double inside = std::min({weight[0], weight[1], weight[2]});
        if (inside <= best) continue;
        best = inside, linear = 0;
        for (std::size_t c = 0; c < 3; ++c) linear += weight[c] * by[fine.indices[3 * f + c]];
      }
      std::int32_t place[2];
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const std::int32_t along[3] = {mesh.places[corner[0]][axis], mesh.places[corner[1]][axis],
                                       mesh.places[corner[2]][axis]};
        place[axis] = foredraw_height_between(along, point.weights().data());
      }
      const double height = foredraw_height_sum(&mesh.sampled, place[0], place[1]) / 65536.0 / 65535;
      sum += (height - linear) * (height - linear);
    }
    squared += area * sum / static_cast<double>(points), areas += area;
    first += count;
  }
  return std::sqrt(squared / areas);
}

TEST(TessellationLevels, HaveTheErrorOfTheTessellatedMesh) {
  const NoisyMesh mesh = noisy_grid(4, 256);
  for (const std::uint64_t budget : {32u, 100u, 800u}) {
    for (const LevelGoal goal : {LevelGoal::rms, LevelGoal::largest}) {
      const ChosenLevels levels = chosen(mesh, {.triangles = budget, .goal = goal});
      const double found = deviation_by_search(mesh, levels.levels, 4000);
      EXPECT_NEAR(levels.chosen.rms, found, 0.03 * found) << budget;
    }
  }
}

/// u^2 over a square: what is linear over a length n is off by at most n^2 / 4.
TEST(TessellationLevels, OfAParabolaHaveTheErrorThatItHas) {
  testing::TestMesh square = testing::grid(1, 1);
  const auto uv = testing::square_uv(square, 1, 1);
  HeightMap map{4096, 1, {}};
  for (int x = 0; x < 4096; ++x)
    map.texels.push_back(static_cast<std::uint16_t>(std::lround(65535 * std::pow((x + 0.5) / 4096, 2))));
  NoisyMesh mesh(std::move(square), uv, std::move(map));
  mesh.sampled.wrap[0] = FOREDRAW_HEIGHT_CLAMPED;
  const ChosenLevels plain = chosen(mesh, {.triangles = 2});
  // Of u^2 - u over the unit interval: mean square 1/30, largest 1/4.
  EXPECT_NEAR(plain.plain.rms, std::sqrt(1.0 / 30), 0.002);
  EXPECT_NEAR(plain.plain.largest, 0.25, 0.002);
  const ChosenLevels eighths = chosen(mesh, {.triangles = 2 * 96}, LevelMethod::constant);
  EXPECT_EQ(eighths.chosen.triangles, 2u * 96);
  // Points are 1/8 apart, and rings 1/12 of the way across: a triangle between rings reaches over 1/6.
  EXPECT_NEAR(eighths.chosen.largest, 0.25 / 36, 0.0002);
  ASSERT_EQ(eighths.scales[0].size(), 4u);
  EXPECT_EQ(eighths.scales[0][3].triangles, 2u);
  EXPECT_FLOAT_EQ(eighths.scales[0][3].rms, static_cast<float>(plain.plain.rms));
}

}  // namespace
}  // namespace foredraw::tessellation_levels_errors_test

#include "plugins/processors/tessellation_levels/tessellation_levels.h"

#include "support/noisy_levels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

namespace foredraw::tessellation_levels_test {
namespace {

using testing::chosen;
using testing::noisy_grid;
using testing::noisy_sphere;
using testing::NoisyMesh;
using testing::part_of;

/// All ways to divide triangles that share nothing: none with as few triangles is better.
TEST(TessellationLevels, AreTheBestForTheirTriangles) {
  testing::TestMesh soup = testing::soup(5, 4);
  std::vector<glm::vec2> uv;
  Random random(8);
  for (std::size_t v = 0; v < soup.positions.size(); ++v)
    uv.emplace_back(static_cast<float>(0.2 * random.unit() + 0.15 * static_cast<double>(v / 3)),
                    static_cast<float>(0.2 * random.unit()));
  const NoisyMesh mesh(std::move(soup), uv, {128, 128, testing::noise(128, 21)});
  const HeightPart part = part_of(mesh);
  const Executor executor(1);
  const HeightDeviations deviations({&part, 1}, executor);
  const auto of_equal_levels = deviations.of_equal_levels();
  std::map<std::uint64_t, double> best;  // by triangles
  for (std::uint32_t way = 0; way < 4 * 4 * 4 * 4 * 4; ++way) {
    std::uint64_t triangles = 0;
    double squared = 0;
    bool is_there = true;
    for (std::size_t t = 0; t < 5; ++t) {
      const auto level = static_cast<std::uint8_t>(way >> (2 * t) & 3u);
      is_there = is_there && level <= deviations.finest()[t];
      triangles += triangles_of({level, level, level, level});
      squared += of_equal_levels[t][level].squared;
    }
    if (!is_there) continue;
    const auto [found, is_new] = best.try_emplace(triangles, squared);
    if (!is_new) found->second = std::min(found->second, squared);
  }
  int tried = 0;
  for (std::uint64_t budget = 5; budget < 480; budget += 7) {
    const ChosenLevels levels = chosen(mesh, {.triangles = budget});
    EXPECT_LE(levels.chosen.triangles, budget);
    const double squared = std::pow(levels.chosen.rms, 2);
    for (const auto& [triangles, least] : best) {
      if (triangles > levels.chosen.triangles) break;
      EXPECT_LE(squared, least * 1.00001) << budget << ' ' << triangles;
    }
    ++tried;
  }
  EXPECT_GT(tried, 60);
  EXPECT_GT(best.size(), 50u);
}

using Point = std::tuple<float, float, float>;
Point point(const glm::vec3& p) { return {p.x + 0.f, p.y + 0.f, p.z + 0.f}; }

struct Side {
  int outer = 0, inner = 0;
  bool has_area = true;
};

/// [edge by its ends] the levels that triangles give it.
std::map<std::pair<Point, Point>, std::vector<Side>> edges_of(const testing::TestMesh& mesh,
                                                              std::span<const LogLevels> levels) {
  std::map<std::pair<Point, Point>, std::vector<Side>> edges;
  for (std::size_t t = 0; t < levels.size(); ++t) {
    for (std::size_t e = 0; e < 3; ++e) {
      const Point a = point(mesh.positions[mesh.indices[3 * t + (e + 1) % 3]]);
      const Point b = point(mesh.positions[mesh.indices[3 * t + (e + 2) % 3]]);
      const Point across = point(mesh.positions[mesh.indices[3 * t + e]]);
      const bool has_area = a != b && b != across && across != a;
      edges[std::minmax(a, b)].push_back({levels[t][e], levels[t][3], has_area});
    }
  }
  return edges;
}

TEST(TessellationLevels, AgreeOnEdgesAlsoAlongSeams) {
  const NoisyMesh mesh = noisy_sphere();
  for (const LevelMethod method : {LevelMethod::content, LevelMethod::edge_length, LevelMethod::constant}) {
    for (const LevelGoal goal : {LevelGoal::rms, LevelGoal::largest}) {
      const ChosenLevels levels = chosen(mesh, {.triangles = 9000, .goal = goal}, method);
      int mixed = 0;
      for (const auto& [edge, sides] : edges_of(mesh.mesh, levels.levels)) {
        int least = 99, most = 0;
        for (const Side& side : sides) {
          EXPECT_EQ(side.outer, sides[0].outer);
          if (side.has_area || goal == LevelGoal::largest) least = std::min(least, side.inner);
          most = std::max(most, side.inner);
        }
        if (method != LevelMethod::content || least == 99) continue;
        EXPECT_EQ(sides[0].outer, std::min(goal == LevelGoal::rms ? least : most, 4)) << "texels allow 16 parts";
        mixed += least != most;
      }
      EXPECT_TRUE(method != LevelMethod::content || mixed > 50) << mixed;
    }
  }
}

/// Both sides of a seam are equal at as many parts as are 1.5 texels long on the shorter one, and no more.
TEST(TessellationLevels, KeepToWhatSeamsAreEqualAt) {
  testing::TestMesh mesh = testing::joined(testing::grid(1, 1), testing::grid(1, 1));
  for (std::size_t v = 4; v < 8; ++v) mesh.positions[v].x += 1;
  std::vector<glm::vec2> uv = testing::square_uv(mesh, 2, 2);
  for (std::size_t v = 4; v < 8; ++v) uv[v] = 0.5f + 0.05f * uv[v];  // 6.4 texels of 256 to an edge
  const NoisyMesh noisy(std::move(mesh), uv, {256, 256, testing::noise(256, 9)});
  for (const LevelGoal goal : {LevelGoal::rms, LevelGoal::largest}) {
    const ChosenLevels levels = chosen(noisy, {.error = 0, .goal = goal});
    int seams = 0;
    for (const auto& [edge, sides] : edges_of(noisy.mesh, levels.levels)) {
      const bool is_seam = std::get<0>(edge.first) == 1 && std::get<0>(edge.second) == 1;
      for (const Side& side : sides) {
        EXPECT_LE(side.outer, is_seam || std::get<0>(edge.second) > 1 ? 2 : 6);
        seams += is_seam;
      }
    }
    EXPECT_EQ(seams, 2);
    EXPECT_GE(std::ranges::max(levels.levels, {}, [](const LogLevels& of) { return of[3]; })[3], 5);
  }
}

TEST(TessellationLevels, DoNotDependOnTheSequenceOfTriangles) {
  const NoisyMesh mesh = noisy_sphere();
  std::vector<std::uint32_t> order(mesh.mesh.indices.size() / 3);
  std::iota(order.begin(), order.end(), 0u);
  Random random(5);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  NoisyMesh shuffled(mesh.mesh, {}, mesh.map);
  shuffled.places = mesh.places;
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) shuffled.mesh.indices[3 * i + c] = mesh.mesh.indices[3 * order[i] + c];
  }
  const TessellationLimits all[] = {{.error = 0.01},
                                    {.error = 0.05, .goal = LevelGoal::largest},
                                    {.triangles = 6000},
                                    {.triangles = 6000, .goal = LevelGoal::largest}};
  for (const TessellationLimits& limits : all) {
    const ChosenLevels a = chosen(mesh, limits), b = chosen(shuffled, limits);
    for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(b.levels[i], a.levels[order[i]]);
    EXPECT_EQ(a.chosen.triangles, b.chosen.triangles);
  }
}

TEST(TessellationLevels, AreTheSameWithAnyNumberOfThreads) {
  const NoisyMesh mesh = noisy_sphere(48, 32);
  for (const LevelGoal goal : {LevelGoal::rms, LevelGoal::largest}) {
    const TessellationLimits limits{.triangles = 40'000, .error = 0.01, .goal = goal};
    const ChosenLevels one = chosen(mesh, limits, LevelMethod::content, 1);
    for (const int threads : {2, 8}) {
      const ChosenLevels many = chosen(mesh, limits, LevelMethod::content, threads);
      EXPECT_EQ(many.levels, one.levels);
      EXPECT_EQ(many.scales, one.scales);
      EXPECT_EQ(many.chosen.rms, one.chosen.rms);
    }
  }
}

TEST(TessellationLevels, KeepTheBudgetAndUseIt) {
  const NoisyMesh mesh = noisy_sphere();
  const std::uint64_t source = mesh.mesh.indices.size() / 3;
  for (const LevelMethod method : {LevelMethod::content, LevelMethod::edge_length, LevelMethod::constant}) {
    double rms = 1e9;
    std::uint64_t used = 0;
    for (std::uint64_t budget = source; budget < 100 * source; budget *= 2) {
      const ChosenLevels levels = chosen(mesh, {.triangles = budget}, method);
      EXPECT_LE(levels.chosen.triangles, budget);
      EXPECT_LE(levels.chosen.rms, rms) << "twice the triangles, and worse: " << budget;
      EXPECT_GE(levels.chosen.triangles, used);
      rms = levels.chosen.rms;
      used = levels.chosen.triangles;
      EXPECT_TRUE(method != LevelMethod::content || budget > 10 * source || used > budget - 400) << budget;
    }
  }
  EXPECT_EQ(chosen(mesh, {.triangles = 1}).chosen.triangles, source) << "there are no fewer";
}

TEST(TessellationLevels, ReachTheErrorWithFewTriangles) {
  const NoisyMesh mesh = noisy_sphere();
  for (const LevelGoal goal : {LevelGoal::rms, LevelGoal::largest}) {
    const auto error = [&](const MeshTessellation& of) { return goal == LevelGoal::rms ? of.rms : of.largest; };
    const ChosenLevels finest = chosen(mesh, {.error = 0, .goal = goal});
    const double most = error(finest.plain), least = error(finest.chosen);
    EXPECT_LT(least, 0.2 * most);
    std::uint64_t before = finest.plain.triangles;
    for (const double wanted : {1.1 * most, 0.5 * most, 0.25 * most, 1.1 * least}) {
      const ChosenLevels levels = chosen(mesh, {.error = wanted, .goal = goal});
      EXPECT_LE(error(levels.chosen), wanted);
      EXPECT_GE(levels.chosen.triangles, before);
      EXPECT_TRUE(goal == LevelGoal::largest || wanted > most || error(levels.chosen) > 0.97 * wanted)
          << "finer than it need be: " << error(levels.chosen) << " for " << wanted;
      EXPECT_EQ(wanted > most, levels.chosen.triangles == finest.plain.triangles);
      before = levels.chosen.triangles;
    }
    EXPECT_LE(before, finest.chosen.triangles);
    EXPECT_LE(chosen(mesh, {.triangles = 2000, .error = 0, .goal = goal}).chosen.triangles, 2000u);
  }
}

TEST(TessellationLevels, NeedFewerTrianglesByContent) {
  const NoisyMesh mesh = noisy_grid(8, 256);
  const double rms = 0.25 * chosen(mesh, {.triangles = 1}).plain.rms;
  const ChosenLevels content = chosen(mesh, {.error = rms});
  EXPECT_LT(3 * content.chosen.triangles, chosen(mesh, {.error = rms}, LevelMethod::edge_length).chosen.triangles);
  EXPECT_LT(3 * content.chosen.triangles, chosen(mesh, {.error = rms}, LevelMethod::constant).chosen.triangles);
}

TEST(TessellationLevels, HaveATableOfRisingErrors) {
  const NoisyMesh mesh = noisy_sphere();
  const ChosenLevels levels = chosen(mesh, {.triangles = 20'000});
  const auto& scales = levels.scales[0];
  ASSERT_GT(scales.size(), 3u);
  for (std::size_t s = 0; s < scales.size(); ++s) {
    std::uint64_t triangles = 0;
    for (const LogLevels& of : levels.levels) triangles += triangles_of(scaled(of, static_cast<std::uint32_t>(s)));
    EXPECT_EQ(scales[s].triangles, triangles);
    if (s == 0) continue;
    EXPECT_GE(scales[s].rms, scales[s - 1].rms);
    EXPECT_GE(scales[s].largest, scales[s - 1].largest);
    EXPECT_LT(scales[s].triangles, scales[s - 1].triangles);
  }
  EXPECT_EQ(scales.back().triangles, levels.plain.triangles);
  EXPECT_FLOAT_EQ(scales.front().rms, static_cast<float>(levels.chosen.rms));
}

/// Parts of a mesh with maps and factors of their own: one multiplier for all, and edges agree between them.
TEST(TessellationLevels, ShareABudgetBetweenTheDrawsOfAMesh) {
  const NoisyMesh rough = noisy_grid(4, 256);
  NoisyMesh gentle = noisy_grid(4, 256, 4);
  for (glm::vec3& p : gentle.mesh.positions) p.x += 4;  // beside it
  const HeightPart parts[] = {part_of(rough, 1), part_of(gentle, 0.05f)};
  const ChosenLevels levels = tessellation_levels(parts, LevelMethod::content, {.triangles = 2000}, Executor(2));
  EXPECT_LE(levels.chosen.triangles, 2000u);
  ASSERT_EQ(levels.scales.size(), 2u);
  EXPECT_GT(levels.scales[0][0].triangles, 3 * levels.scales[1][0].triangles);
  const testing::TestMesh both = testing::joined(rough.mesh, gentle.mesh);
  for (const auto& [edge, sides] : edges_of(both, levels.levels)) {
    for (const Side& side : sides) EXPECT_EQ(side.outer, sides[0].outer);
  }
}

}  // namespace
}  // namespace foredraw::tessellation_levels_test

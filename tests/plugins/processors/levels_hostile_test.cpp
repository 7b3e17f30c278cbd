// Levels of meshes that nobody would make on purpose: whatever they are, levels draw what is there, and no farther from
// full detail than they tell.

#include "plugins/processors/levels/levels.h"

#include "plugins/processors/quadric_collapse/quadric_collapse.h"
#include "support/collapses.h"

#include <foredraw/analysis/analyses.h>
#include <foredraw/analysis/surface_distance.h>
#include <foredraw/collapses/collapse_sequences.h>
#include <foredraw/technique/plugin.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace foredraw::levels_hostile_test {
namespace {

using testing::TestMesh;

/// With levels; nothing where none is worth its bytes.
Draw with_levels(const TestMesh& mesh, const QuadricCollapseOptions& options, const Settings& settings) {
  Scene scene = testing::scene_of(mesh);
  auto sequence = quadric_collapse(mesh.positions, mesh.indices, options);
  EXPECT_EQ(replay(sequence, mesh.positions, mesh.indices).mistake, "");
  scene.draws[0].full().made.add(traits::progressive);
  scene.products.set(CollapseSequences{{{{0}, std::make_shared<const CollapseSequence>(std::move(sequence))}}});
  testing::RunFixture fixture;
  const Technique technique = levels_plugin().create(settings);
  std::get<std::unique_ptr<Processor>>(technique)->process(scene, {0}, fixture.run);
  for (const Note& note : fixture.findings.notes) {
    EXPECT_TRUE(note.code == "level-left-out" || note.code == "nothing-to-gain") << note.message;
  }
  return scene.draws[0];
}

TestMesh drawn(const Level& level) {
  Analyses analyses;
  const auto indices = level.stream().indices.view();
  return {positions_of(analyses, *level.vertices)->values, {indices.begin(), indices.end()}};
}

double measured(const TestMesh& full, const Level& level, std::size_t samples) {
  const TestMesh coarse = drawn(level);
  const auto distance = surface_distance({full.positions, full.indices}, {coarse.positions, coarse.indices},
                                         {.samples = samples, .seed = 3}, Executor(1));
  return distance ? distance->largest : 0;
}

/// What each level tells, beside what is found and the last bit of coordinates.
void expect_claims_hold(const char* name, const TestMesh& mesh, const Draw& draw, std::size_t samples = 5'000) {
  double largest = 0;
  for (const std::uint32_t v : mesh.indices) {
    for (int k = 0; k < 3; ++k) {
      if (std::isfinite(mesh.positions[v][k])) largest = std::max(largest, std::abs(double{mesh.positions[v][k]}));
    }
  }
  for (std::size_t l = 1; l < draw.levels.size(); ++l) {
    const Level &level = draw.levels[l], &before = draw.levels[l - 1];
    EXPECT_TRUE(std::isfinite(level.error)) << name;
    EXPECT_GE(level.error, before.error) << name;
    EXPECT_GE(level.error + largest * 1e-7, measured(mesh, level, samples)) << name << ", level " << l;
    EXPECT_EQ(level.stream().indices.empty(), mesh.indices.empty()) << name;
    EXPECT_LE(level.stream().indices.size(), before.stream().indices.size()) << name;
    for (const std::uint32_t v : level.stream().indices.view()) ASSERT_LT(v, level.vertices->count) << name;
  }
}

TestMesh scaled(TestMesh mesh, float scale, glm::vec3 by = glm::vec3(0)) {
  for (glm::vec3& p : mesh.positions) p = p * scale + by;
  return mesh;
}

struct Shape {
  const char* name;
  TestMesh mesh;
  double extent =
      0;  ///< 0: nothing is known of what should be left; else a tenth of the triangles lies within three tenths of it
};

std::vector<Shape> shapes() {
  const TestMesh torus = testing::closed_torus(32, 16);
  return {{"extents of 1e-30", scaled(torus, 1e-30f), 1e-30},
          {"extents of 1e30", scaled(torus, 1e30f), 1e30},
          {"extents of 1e-38", scaled(torus, 1e-38f), 1e-38},
          {"a million from the origin", scaled(torus, 1, glm::vec3(1e6f, -1e6f, 1e6f)), 1},
          {"1e7 from the origin", scaled(torus, 1000, glm::vec3(1e7f, 1e7f, -1e7f)), 1000},
          {"1e7 from the origin, of few places", scaled(torus, 3, glm::vec3(1e7f))}};
}

TEST(HostileLevels, TellNoLessThanIsMeasured) {
  for (const Shape& shape : shapes()) {
    for (const CollapsePlacement placement : {CollapsePlacement::optimal, CollapsePlacement::endpoint}) {
      SCOPED_TRACE(shape.name);
      const Draw draw = with_levels(shape.mesh, {.placement = placement}, {{"ratios", "0.5, 0.1, 0.03"}});
      expect_claims_hold(shape.name, shape.mesh, draw);
      if (shape.extent == 0) continue;
      ASSERT_EQ(draw.levels.size(), 4u) << shape.name;
      EXPECT_LE(draw.levels[2].stream().triangle_count(), shape.mesh.indices.size() / 30 + 1) << shape.name;
      EXPECT_LT(draw.levels[2].error, 0.3 * shape.extent) << shape.name;
    }
  }
}

/// Looking for what is near its tip is a look at nearly all triangles.
TEST(HostileLevels, OfAHubTellNoLessThanIsMeasured) {
  const TestMesh hub = testing::spokes(10'000);
  const Draw draw = with_levels(hub, {}, {{"ratios", "0.01"}});
  ASSERT_EQ(draw.levels.size(), 2u);
  expect_claims_hold("a hub", hub, draw, 200);
  EXPECT_LE(draw.levels[1].stream().triangle_count(), 100u);
  EXPECT_LT(draw.levels[1].error, 0.01f);
}

TEST(HostileLevels, OfOddMeshesTellNoLessThanIsMeasured) {
  std::size_t levels = 0;
  for (const TestMesh& mesh : testing::odd_meshes()) {
    const bool is_finite = std::ranges::all_of(mesh.indices, [&](std::uint32_t v) {
      const glm::vec3& p = mesh.positions[v];
      return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    });
    const Draw draw = with_levels(mesh, {.parts = 0}, {{"ratios", "0.5, 0.1"}});
    if (is_finite) expect_claims_hold("an odd mesh", mesh, draw);
    levels += draw.levels.size() - 1;
  }
  EXPECT_GT(levels, 20u);
}

/// Thirteen cubed. They are two per cent of the whole's size: small pieces, which `parts` lets go.
TestMesh tetrahedra() {
  TestMesh all;
  for (int i = 0; i < 13 * 13 * 13; ++i) {
    const glm::vec3 at(8 * (i % 13), 8 * (i / 13 % 13), 8 * (i / 169));
    const auto first = static_cast<std::uint32_t>(all.positions.size());
    for (const glm::vec3 corner : {glm::vec3(0, 0, 0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)}) {
      all.positions.push_back(at + corner);
    }
    for (const std::uint32_t v : {0u, 2u, 1u, 0u, 1u, 3u, 1u, 2u, 3u, 2u, 0u, 3u}) all.indices.push_back(first + v);
  }
  return all;
}

/// None goes without a word: it stays, or the level says how far away what is left lies.
TEST(HostileLevels, ThousandsOfTetrahedraDoNotVanishSilently) {
  const TestMesh all = tetrahedra();
  const Draw kept = with_levels(all, {.parts = 0}, {{"ratios", "0.5, 0.1"}, {"saving", 0.0}});
  for (const Level& level : kept.levels) EXPECT_EQ(level.stream().triangle_count(), all.indices.size() / 3);
  const Draw fewer = with_levels(all, {}, {{"ratios", "0.5, 0.1"}});
  ASSERT_EQ(fewer.levels.size(), 3u);
  expect_claims_hold("tetrahedra", all, fewer);
  EXPECT_GE(fewer.levels[1].error, 7) << "as far as the next one is";
  const Draw near = with_levels(all, {}, {{"errors", "1, 6"}, {"saving", 0.0}});
  for (const Level& level : near.levels) {  // one may be flat, on its way to nothing
    EXPECT_GE(level.stream().triangle_count() + 2, all.indices.size() / 3);
  }
}

}  // namespace
}  // namespace foredraw::levels_hostile_test

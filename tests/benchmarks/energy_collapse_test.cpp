#include "benchmarks/peers/energy_collapse/energy_collapse.h"

#include "support/collapses.h"
#include "support/meshes.h"
#include "support/other_units.h"

#include <foredraw/analysis/closest_points.h>
#include <foredraw/collapses/collapse_sequences.h>
#include <foredraw/technique/plugin.h>

#include <gtest/gtest.h>

#include <cmath>

namespace foredraw::energy_collapse_test {
namespace {

using testing::TestMesh;

testing::Simplify with(EnergyCollapseOptions options) {
  return [options](const TestMesh& mesh, std::size_t least) mutable {
    options.least = least;
    return energy_collapse(mesh.positions, mesh.indices, {}, options);
  };
}

TestMesh coarse(const TestMesh& mesh, std::size_t triangles, const EnergyCollapseOptions& options = {}) {
  return testing::coarse(mesh, with(options)(mesh, triangles), triangles);
}

TEST(EnergyCollapse, ASphereStaysClosedAndRound) {
  const TestMesh sphere = testing::sphere(32, 16);
  const TestMesh left = coarse(sphere, sphere.indices.size() / 12);
  EXPECT_LE(left.indices.size(), sphere.indices.size() / 4);
  EXPECT_LT(testing::distance(sphere, left), 0.05);
}

/// The topology of sharp edges is kept, and Edisc holds them where they are.
TEST(EnergyCollapse, SeamsStayClosedAndInPlace) {
  const TestMesh box = testing::box_of_sides(6);
  const TestMesh left = coarse(box, 40);
  EXPECT_LE(left.indices.size() / 3, 40u);
  EXPECT_EQ(testing::edges(left).size(), 1u);
  EXPECT_EQ(testing::euler(left), 2);
  EXPECT_LT(testing::distance(box, left), 0.05);
}

/// A flat plate with a step in its colour: without Escalar all places are alike.
TEST(EnergyCollapse, ScalarsKeepWhatIsPainted) {
  const TestMesh plate = testing::grid(16, 16);
  std::vector<float> paint;
  glm::vec3 most(0);
  for (const glm::vec3& p : plate.positions) most = glm::max(most, p);
  for (const glm::vec3& p : plate.positions) paint.push_back(p.x < 0.6f * most.x ? 0.0f : 1.0f);
  const auto difference = [&](double weight) {
    const CollapseSequence sequence =
        energy_collapse(plate.positions, plate.indices, {paint, 1}, {.scalar = weight, .least = 100});
    std::vector<float> painted = paint;  // as the sequence blends it
    for (std::size_t k = 0; k < sequence.collapses.size(); ++k) {
      for (std::uint32_t i = sequence.first_pair[k]; i < sequence.first_pair[k + 1]; ++i) {
        const VertexPair& pair = sequence.pairs[i];
        painted[pair.kept] += sequence.collapses[k].blend * (painted[pair.removed] - painted[pair.kept]);
      }
    }
    const Collapsed left = collapsed(sequence, sequence.collapses.size(), plate.positions, plate.indices);
    const ClosestPoints surface(Surface{left.places, left.indices});
    double sum = 0;
    for (std::size_t v = 0; v < plate.positions.size(); ++v) {
      const Closest at = surface.nearest(plate.positions[v]);
      double there = 0;
      for (int k = 0; k < 3; ++k) {
        there +=
            at.weights[k] * static_cast<double>(painted[left.indices[3 * at.triangle + static_cast<std::size_t>(k)]]);
      }
      sum += (there - static_cast<double>(paint[v])) * (there - static_cast<double>(paint[v]));
    }
    return std::sqrt(sum / static_cast<double>(plate.positions.size()));
  };
  EXPECT_LT(difference(1e-2), 0.5 * difference(0));
}

/// More points of the original than ends of edges: places follow the surface between them.
TEST(EnergyCollapse, RoundsOfTheFitMakeItBetter) {
  const TestMesh sphere = testing::sphere(24, 12);
  const auto mean = [&](std::uint32_t rounds) {
    const TestMesh left = coarse(sphere, 80, {.rounds = rounds});
    const ClosestPoints surface(Surface{left.positions, left.indices});
    double sum = 0;
    for (const glm::vec3& p : sphere.positions) sum += surface.distance(p);
    return sum / static_cast<double>(sphere.positions.size());
  };
  EXPECT_LT(mean(3), 0.8 * mean(0));
}

TEST(EnergyCollapse, TheSeedDecidesLong) {
  const TestMesh torus = testing::closed_torus(16, 8);
  const auto made = [&](std::uint64_t seed) {
    return energy_collapse(torus.positions, torus.indices, {}, {.seed = seed});
  };
  EXPECT_EQ(made(1), made(1));
  EXPECT_NE(made(1), made(2));
}

TEST(EnergyCollapse, TopologyStaysLong) { testing::expect_topology_stays(with({})); }

TEST(EnergyCollapse, SeamsStay) { testing::expect_seams_stay(with({})); }

TEST(EnergyCollapse, TakesWhateverItIsGivenLong) { testing::expect_odd_meshes_run(with({.samples = 2})); }

/// Numbers whose differences are no floats.
TEST(EnergyCollapse, TakesWhateverVerticesCarry) {
  const testing::TestMesh mesh = testing::torus(16, 8);
  std::vector<float> scalars;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    scalars.push_back(v % 2 == 0 ? 3e38f : v % 3 == 0 ? NAN : -3e38f);
  const CollapseSequence sequence = energy_collapse(mesh.positions, mesh.indices, {scalars, 1}, {.samples = 2});
  EXPECT_EQ(replay(sequence, mesh.positions, mesh.indices).mistake, "");
  EXPECT_GT(sequence.collapses.size(), 50u);
}

TEST(EnergyCollapse, StopsWhereItIsToldTo) {
  testing::expect_it_stops(with({}));
  const TestMesh torus = testing::closed_torus(16, 8);
  const std::atomic<bool> cancel = true;
  EXPECT_TRUE(energy_collapse(torus.positions, torus.indices, {}, {.cancel = &cancel}).collapses.empty());
}

CollapseSequence sequence_of(const Scene& scene) {
  testing::RunFixture fixture;
  Scene changed = scene;
  const Technique technique = energy_collapse_plugin().create({});
  std::get<std::unique_ptr<Processor>>(technique)->process(changed, {0}, fixture.run);
  return *changed.products.find<CollapseSequences>()->meshes.at(0).sequence;
}

/// A wave whose texture runs faster on one side.
Scene textured_wave() {
  TestMesh wave = testing::grid(12, 12);
  std::vector<glm::vec2> uvs;
  for (glm::vec3& p : wave.positions) {
    uvs.emplace_back(0x1p-7f * std::floor(p.x * p.x), 0x1p-7f * p.y);
    p.z = 0.1f * std::sin(p.x + p.y);
  }
  Draw draw = testing::draw_of(wave);
  VertexStreams streams = *draw.full().vertices;
  streams.base.push_back(float_stream("TEXCOORD_0", uvs));
  draw.full().vertices = std::make_shared<const VertexStreams>(std::move(streams));
  return testing::scene_of({std::move(draw)});
}

TEST(EnergyCollapse, TextureCoordinatesCountInWidthsOfTheTextureLong) {
  const Scene plain = textured_wave();
  EXPECT_EQ(sequence_of(testing::in_other_units(plain, {.set = 0, .scale = glm::dvec2(0x1p-12)})), sequence_of(plain));
  Scene tiled = plain;
  tiled.materials = {{.base_colour = Texture{.scale = glm::dvec2(100)}}};
  tiled.draws[0].material = 0;
  EXPECT_NE(sequence_of(tiled), sequence_of(plain)) << "a hundred times as much of the texture slides";
}

}  // namespace
}  // namespace foredraw::energy_collapse_test

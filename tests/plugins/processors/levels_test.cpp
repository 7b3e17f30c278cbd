#include "plugins/processors/levels/levels.h"

#include "plugins/processors/quadric_collapse/quadric_collapse.h"
#include "support/meshes.h"

#include <foredraw/analysis/analyses.h>
#include <foredraw/analysis/surface_distance.h>
#include <foredraw/analysis/welded_positions.h>
#include <foredraw/collapses/collapse_sequences.h>
#include <foredraw/geometry/joined_sets.h>
#include <foredraw/scene/levels.h>
#include <foredraw/technique/plugin.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

namespace foredraw::levels_test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::Ge;
using ::testing::HasSubstr;
using ::testing::Le;

/// All draws as one mesh, with its sequence.
void collapse(Scene& scene, std::vector<DrawId> draws, CollapsePlacement placement = CollapsePlacement::optimal) {
  Analyses analyses;
  const JoinedMesh mesh = *joined_mesh(scene, draws, analyses);
  auto sequence = quadric_collapse(mesh.positions, mesh.indices, {.placement = placement});
  CollapseSequences sequences;
  if (const auto* before = scene.products.find<CollapseSequences>()) sequences = *before;
  for (const DrawId id : draws) scene.draws[id].full().made.add(traits::progressive);
  sequences.meshes.push_back({std::move(draws), std::make_shared<const CollapseSequence>(std::move(sequence))});
  scene.products.set(std::move(sequences));
}

Scene collapsing(const testing::TestMesh& mesh, CollapsePlacement placement = CollapsePlacement::optimal) {
  Scene scene = testing::scene_of(mesh);
  collapse(scene, {0}, placement);
  return scene;
}

/// One mesh of two draws.
Scene of_two(Draw a, Draw b) {
  Scene scene = testing::scene_of({std::move(a), std::move(b)});
  scene.meshes[0].draws = {0, 1};
  scene.meshes.resize(1);
  scene.nodes.resize(1);
  return scene;
}

testing::TestMesh drawn(const Level& level) {
  Analyses analyses;
  const auto indices = level.stream().indices.view();
  return {positions_of(analyses, *level.vertices)->values, {indices.begin(), indices.end()}};
}

/// Far more points than the proof asks for.
double measured(const Level& a, const Level& b) {
  const testing::TestMesh first = drawn(a), second = drawn(b);
  return surface_distance({first.positions, first.indices}, {second.positions, second.indices},
                          {.samples = 20'000, .seed = 7}, Executor(1))
      ->largest;
}

/// Edges between points, by the triangles on both sides: [edge] = the vertices that triangles have at its ends.
std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::pair<std::uint32_t, std::uint32_t>>>
edges_between_points(const testing::TestMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::pair<std::uint32_t, std::uint32_t>>> all;
  const std::vector<std::uint32_t> point = welded(mesh.positions);
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t a = mesh.indices[i + k], b = mesh.indices[i + (k + 1) % 3];
      if (point[a] > point[b]) std::swap(a, b);
      all[{point[a], point[b]}].emplace_back(a, b);
    }
  }
  return all;
}

/// Connected sets of edges whose triangles have different vertices, or of which one side has none.
std::size_t seam_loops(const testing::TestMesh& mesh) {
  JoinedSets sets(mesh.positions.size());
  std::set<std::uint32_t> points;
  for (const auto& [edge, sides] : edges_between_points(mesh)) {
    if (sides.size() == 2 && sides[0] == sides[1]) continue;
    sets.join(edge.first, edge.second);
    points.insert({edge.first, edge.second});
  }
  std::set<std::uint32_t> loops;
  for (const std::uint32_t point : points) loops.insert(sets.of(point));
  return loops.size();
}

class Levels : public ::testing::Test {
 protected:
  std::vector<DrawId> process(Scene& scene, const Settings& settings = {}, unsigned threads = 2) {
    fixture_ = std::make_unique<testing::RunFixture>();
    const Executor executor(threads);
    foredraw::Run run{fixture_->analyses, executor, fixture_->findings, fixture_->views};
    std::vector<DrawId> all;
    for (DrawId id = 0; id < scene.draws.size(); ++id) all.push_back(id);
    const Technique technique = levels_plugin().create(settings);
    return std::get<std::unique_ptr<Processor>>(technique)->process(scene, all, run);
  }

  std::vector<std::string> notes() const {
    std::vector<std::string> found;
    for (const Note& note : fixture_->findings.notes) found.push_back(note.message);
    return found;
  }

  std::unique_ptr<testing::RunFixture> fixture_;
};

std::vector<std::size_t> triangles(const Draw& draw) {
  std::vector<std::size_t> counts;
  for (const Level& level : draw.levels) counts.push_back(level.stream().triangle_count());
  return counts;
}

TEST_F(Levels, AreCutByShareAndUseTheSequenceUp) {
  Scene scene = collapsing(testing::torus(48, 24));
  const std::size_t full = triangles(scene.draws[0])[0];
  const auto at_most = [](std::size_t count) { return AllOf(Le(count), Ge(count - 1)); };  // an edge takes two
  EXPECT_THAT(process(scene), ElementsAre(0u));
  EXPECT_THAT(triangles(scene.draws[0]),
              ElementsAre(full, at_most(full / 2), at_most(full / 4), at_most(full / 10 + 1)));
  EXPECT_EQ(scene.products.find<CollapseSequences>(), nullptr);
  EXPECT_FALSE(traits_of(scene.draws[0]).has(traits::progressive));
  EXPECT_THAT(notes(), ElementsAre());
}

TEST_F(Levels, LeaveTheSequenceToLaterStagesIfAskedTo) {
  Scene scene = collapsing(testing::torus(24, 12));
  process(scene, {{"keep-sequences", true}});
  ASSERT_NE(scene.products.find<CollapseSequences>(), nullptr);
  EXPECT_TRUE(traits_of(scene.draws[0]).has(traits::progressive));
}

TEST_F(Levels, ErrorsNeverFallAndAreNeverExceeded) {
  for (const float scale : {1e-6f, 1.0f, 1e6f}) {
    for (const CollapsePlacement placement : {CollapsePlacement::optimal, CollapsePlacement::endpoint}) {
      testing::TestMesh mesh = testing::torus(32, 16);
      for (glm::vec3& p : mesh.positions) p *= scale;
      Scene scene = collapsing(mesh, placement);
      process(scene, {{"ratios", "0.7, 0.3, 0.08, 0.02"}});
      const Draw& draw = scene.draws[0];
      ASSERT_EQ(draw.levels.size(), 5u);
      for (std::size_t l = 1; l < draw.levels.size(); ++l) {
        EXPECT_GE(draw.levels[l].error, draw.levels[l - 1].error);
        EXPECT_GE(draw.levels[l].error, measured(draw.full(), draw.levels[l]));
        EXPECT_LE(draw.levels[l].error, 1.1 * measured(draw.full(), draw.levels[l]));
      }
    }
  }
}

/// What is asked for is the error that the level tells: neither the search nor the proof adds its slack.
TEST_F(Levels, StayWithinTheErrorsThatAreAskedFor) {
  Scene scene = collapsing(testing::torus(48, 24));
  process(scene, {{"errors", "0.01, 0.03, 0.1"}});
  const Draw& draw = scene.draws[0];
  ASSERT_EQ(draw.levels.size(), 4u);
  EXPECT_FLOAT_EQ(draw.levels[1].error, 0.01f);
  EXPECT_FLOAT_EQ(draw.levels[2].error, 0.03f);
  EXPECT_FLOAT_EQ(draw.levels[3].error, 0.1f);
  for (std::size_t l = 1; l < 4; ++l) EXPECT_LE(measured(draw.full(), draw.levels[l]), draw.levels[l].error);
  EXPECT_THAT(notes(), ElementsAre());
}

/// A pixel of a picture of 1,080 is 0.00107 of the distance.
TEST_F(Levels, StayWithinPixelsFromTheirDistances) {
  Scene by_distances = collapsing(testing::torus(48, 24)), by_errors = collapsing(testing::torus(48, 24));
  process(by_distances, {{"distances", "10, 50"}, {"pixels", 2.0}});
  process(by_errors, {{"errors", "0.0213833, 0.1069167"}});
  ASSERT_EQ(by_distances.draws[0].levels.size(), 3u);
  for (std::size_t l = 1; l < 3; ++l) {
    EXPECT_NEAR(by_distances.draws[0].levels[l].error, by_errors.draws[0].levels[l].error, 1e-6);
  }
}

/// Positions of 16 bits: what rounding adds counts.
TEST_F(Levels, ErrorsHoldWherePositionsAreIntegers) {
  const testing::TestMesh torus = testing::torus(48, 24);
  std::vector<std::int16_t> stored;
  for (const glm::vec3& p : torus.positions) {
    for (int c = 0; c < 3; ++c) stored.push_back(static_cast<std::int16_t>(std::lround(p[c] * 100)));
  }
  Draw draw = testing::draw_of(torus);
  VertexStreams vertices{.count = static_cast<std::uint32_t>(torus.positions.size())};
  const auto bytes = std::as_bytes(std::span(stored));
  vertices.base = {{"POSITION", {Component::int16, 3, false, 6}, Shared<std::byte>({bytes.begin(), bytes.end()})}};
  draw.full().vertices = std::make_shared<const VertexStreams>(std::move(vertices));
  Scene scene = testing::scene_of({draw});
  collapse(scene, {0});
  process(scene, {{"errors", "2, 5"}});
  ASSERT_EQ(scene.draws[0].levels.size(), 3u);
  EXPECT_FLOAT_EQ(scene.draws[0].levels[1].error, 2);
  EXPECT_LE(measured(scene.draws[0].full(), scene.draws[0].levels[1]), 2);
  EXPECT_LE(measured(scene.draws[0].full(), scene.draws[0].levels[2]), 5);
  EXPECT_THAT(notes(), ElementsAre());
}

TEST_F(Levels, ShareVerticesWhereNoneMoves) {
  Scene shared = collapsing(testing::torus(48, 24), CollapsePlacement::endpoint);
  Scene own = collapsing(testing::torus(48, 24), CollapsePlacement::optimal);
  process(shared);
  process(own);
  ASSERT_EQ(shared.draws[0].levels.size(), 4u);
  for (std::size_t l = 1; l < 4; ++l) {
    EXPECT_EQ(shared.draws[0].levels[l].vertices, shared.draws[0].full().vertices);
    EXPECT_LT(own.draws[0].levels[l].vertices->count, own.draws[0].levels[l - 1].vertices->count);
    EXPECT_LT(own.draws[0].levels[l].error, shared.draws[0].levels[l].error);
  }
}

/// A cylinder with a seam along its side and one rim at each end; the seam joins the rims. And apart from it an island
/// within a sheet: another loop.
TEST_F(Levels, SeamLoopsStay) {
  testing::TestMesh mesh = testing::grid(40, 40);
  std::vector<std::uint32_t> twin(mesh.positions.size());
  for (std::uint32_t v = 0; v < twin.size(); ++v) {
    twin[v] = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back(mesh.positions[v]);
  }
  const auto is_inside = [&](std::size_t triangle) {  // a square of 16 in the middle has vertices of its own
    glm::vec3 centre(0), most(0);
    for (std::size_t k = 0; k < 3; ++k) centre += mesh.positions[mesh.indices[3 * triangle + k]] / 3.0f;
    for (const glm::vec3& p : mesh.positions) most = glm::max(most, p);
    const glm::vec3 from = glm::abs(centre / most.x - glm::vec3(0.5f, 0.5f * most.y / most.x, 0));
    return std::max(from.x, from.y) < 0.2f;
  };
  std::vector<bool> inside;
  for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t) inside.push_back(is_inside(t));
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    if (inside[i / 3]) mesh.indices[i] = twin[mesh.indices[i]];
  }
  for (glm::vec3& p : mesh.positions) p.z = std::sin(p.x * 3) * 0.1f;
  ASSERT_EQ(seam_loops(mesh), 2u);
  for (const CollapsePlacement placement : {CollapsePlacement::optimal, CollapsePlacement::endpoint}) {
    Scene scene = collapsing(mesh, placement);
    process(scene, {{"ratios", "0.5, 0.1, 0.03"}});
    ASSERT_EQ(scene.draws[0].levels.size(), 4u);
    for (const Level& level : scene.draws[0].levels) EXPECT_EQ(seam_loops(drawn(level)), 2u);
  }
}

/// A torus of two draws, each with vertices of its own: no gap between them at any level.
TEST_F(Levels, MeshesOfSeveralDrawsStayWatertight) {
  constexpr std::uint32_t slices = 48, sides = 24;
  testing::TestMesh torus = testing::torus(slices, sides);  // its last row and column lie a rounding beside the first
  for (std::uint32_t& v : torus.indices) v = v / (slices + 1) % sides * (slices + 1) + v % (slices + 1) % slices;
  const auto half = torus.indices.begin() + torus.indices.size() / 6 * 3;
  const testing::TestMesh left{torus.positions, {torus.indices.begin(), half}};
  const testing::TestMesh right{torus.positions, {half, torus.indices.end()}};
  Scene scene = of_two(testing::draw_of(left, "Left"), testing::draw_of(right, "Right"));
  collapse(scene, {0, 1});
  process(scene, {{"ratios", "0.5, 0.25, 0.1, 0.03"}});
  ASSERT_EQ(scene.draws[0].levels.size(), 5u);
  for (std::size_t level = 0; level < 5; ++level) {
    const testing::TestMesh whole =
        testing::joined(drawn(scene.draws[0].levels[level]), drawn(scene.draws[1].levels[level]));
    for (const auto& [edge, at] : edges_between_points(whole)) EXPECT_EQ(at.size(), 2u) << level;
  }
}

TEST_F(Levels, AreTheSameAtAnyNumberOfThreads) {
  const Scene scene = collapsing(testing::sphere(64, 32));  // of many equal triangles
  for (const Settings& settings : {Settings{}, Settings{{"errors", "0.003, 0.02, 0.1"}}}) {
    Scene one = scene, two = scene;
    process(one, settings, 1);
    process(two, settings, 2);
    ASSERT_EQ(one.draws[0].levels.size(), 4u);
    ASSERT_EQ(two.draws[0].levels.size(), 4u);
    for (std::size_t l = 0; l < 4; ++l) {
      EXPECT_EQ(one.draws[0].levels[l].stream().indices, two.draws[0].levels[l].stream().indices);
      EXPECT_EQ(one.draws[0].levels[l].vertices->stamp(), two.draws[0].levels[l].vertices->stamp());
      EXPECT_EQ(one.draws[0].levels[l].error, two.draws[0].levels[l].error);
    }
  }
}

TEST_F(Levels, ThatSaveLittleAreLeftOut) {
  Scene scene = collapsing(testing::torus(48, 24));
  process(scene, {{"ratios", "0.9, 0.5, 0.45"}});
  EXPECT_EQ(scene.draws[0].levels.size(), 2u);
  EXPECT_THAT(notes(), ElementsAre("the levels of 0.9, 0.45 are left out: less than 20 % of the triangles of the level "
                                   "before would be saved"));
  Scene all = collapsing(testing::torus(48, 24));
  process(all, {{"ratios", "0.9, 0.5, 0.45"}, {"saving", 0.0}});
  EXPECT_EQ(all.draws[0].levels.size(), 4u);
  Scene none = collapsing(testing::torus(48, 24));
  EXPECT_THAT(process(none, {{"ratios", "0.9"}}), ElementsAre());
  EXPECT_EQ(none.draws[0].levels.size(), 1u);
  EXPECT_EQ(none.products.find<CollapseSequences>(), nullptr) << "it is used up, whatever came of it";
  Scene kept = collapsing(testing::torus(48, 24));
  process(kept, {{"ratios", "0.9"}, {"keep-sequences", true}});
  EXPECT_TRUE(fixture_->run.keeps());
}

/// A draw of a single triangle within a mesh keeps it: nothing to measure from would be left.
TEST_F(Levels, NoDrawVanishes) {
  testing::TestMesh sphere = testing::sphere(32, 16), patch{sphere.positions, {}};
  const auto first = sphere.indices.begin() + 3 * 400;
  patch.indices.assign(first, first + 3);
  sphere.indices.erase(first, first + 3);
  Draw shell = testing::draw_of(sphere, "Shell"), other = testing::draw_of(patch, "Patch");
  other.full().vertices = shell.full().vertices;  // so no seam holds it
  Scene scene = of_two(std::move(shell), std::move(other));
  collapse(scene, {0, 1}, CollapsePlacement::endpoint);
  process(scene, {{"ratios", "0.3, 0.0001"}});
  ASSERT_GE(scene.draws[1].levels.size(), 2u);
  for (const Level& level : scene.draws[1].levels) EXPECT_EQ(level.stream().triangle_count(), 1u);
}

TEST_F(Levels, DrawsWithoutSequencesAreStillDrawn) {
  Scene scene = of_two(testing::draw_of(testing::sphere(32, 16), "Body"), testing::draw_of(testing::grid(2, 2), "Eye"));
  collapse(scene, {0});
  scene.draws.push_back(testing::draw_of(testing::TestMesh{{glm::vec3(0)}, {}}, "Nothing"));
  scene.meshes[0].draws.push_back(2);
  process(scene);
  EXPECT_EQ(scene.draws[0].levels.size(), scene.draws[1].levels.size());
  for (const Level& level : scene.draws[1].levels) {
    EXPECT_EQ(level.stream().indices, scene.draws[1].full().stream().indices);
    EXPECT_EQ(level.error, 0);
  }
}

TEST_F(Levels, WithoutAnySequenceTheSceneStays) {
  Scene scene = testing::scene_of(testing::sphere(16, 8));
  EXPECT_THAT(process(scene), ElementsAre());
  EXPECT_THAT(*fixture_->findings.nothing_to_gain, HasSubstr("such as `quadric-collapse` finds before"));
}

}  // namespace
}  // namespace foredraw::levels_test

#include "evaluators/seam_gap/seam_gap.h"

#include "evaluators/seam_gap/direction_gap.h"
#include "evaluators/seam_gap/influence_gap.h"

#include "support/displaced.h"
#include "support/uv_charts.h"

#include <foredraw/technique/plugin.h>

#include <gtest/gtest.h>

namespace foredraw::seam_gap_test {
namespace {

using namespace testing;

/// Two triangles whose shared edge lies in the left and in the right half of the map.
Charts two_halves() {
  Charts charts;
  charts.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0, -1, 0}};
  charts.uvs = {{.1f, .2f}, {.4f, .2f}, {.1f, .5f}, {.6f, .2f}, {.9f, .2f}, {.6f, .5f}};
  charts.indices = {0, 1, 2, 4, 3, 5};
  return charts;
}

testing::Map halves(std::uint16_t left, std::uint16_t right) {
  testing::Map map{200, 100, {}};
  for (std::uint32_t i = 0; i < 20000; ++i) map.texels.push_back(i % 200 < 100 ? left : right);
  return map;
}

TEST(SeamGap, OfTwoHeightsIsTheirDifference) {
  const SeamGap gap = seam_gap(two_halves().seams(), halves(13107, 52428).view());
  EXPECT_EQ(gap.edges, 1u);
  EXPECT_EQ(gap.samples, 201u);
  EXPECT_NEAR(gap.largest, 0.6, 1e-12);
  EXPECT_NEAR(std::sqrt(gap.squares / 201), 0.6, 1e-12);
  EXPECT_EQ(gap.points, 2 + 31u) << "60 texels: 32 parts";
  EXPECT_EQ(gap.unequal, gap.points);
  EXPECT_EQ(gap.below, 1u);
  EXPECT_EQ(gap.torn, 1u);
}

/// Two squares that meet at a right angle, with vertices of their own along the edge.
TEST(DirectionGap, IsHalfOfTheAngleBetweenTwoNormals) {
  const std::vector<glm::vec3> positions = {{0, 0, 0}, {1, 0, 0},  {0, 1, 0}, {1, 1, 0},
                                            {1, 0, 0}, {1, 0, -1}, {1, 1, 0}, {1, 1, -1}};
  const std::vector<std::uint32_t> indices = {0, 1, 2, 1, 3, 2, 4, 5, 6, 5, 7, 6};
  std::vector<glm::vec3> normals(8, glm::vec3(0, 0, 1));
  const DirectedPart part{positions, normals, indices};
  const DirectionGap same = direction_gap(std::span(&part, 1));
  EXPECT_EQ(same.shared, 2u);
  EXPECT_EQ(same.split, 0u);
  EXPECT_EQ(same.largest, 0);
  std::fill(normals.begin() + 4, normals.end(), glm::vec3(2, 0, 0));
  const DirectionGap split = direction_gap(std::span(&part, 1));
  EXPECT_EQ(split.split, 2u);
  EXPECT_NEAR(split.largest, 45, 20) << "of directions that weigh both faces' angles";
  normals[4] = normals[6] = glm::vec3(0);
  EXPECT_EQ(direction_gap(std::span(&part, 1)).shared, 0u) << "one of two points nowhere";
}

TEST(DirectionGap, OfPartsIsTheSameAsOfOne) {
  const Charts charts = cube_sphere(3, turned_places());
  std::vector<glm::vec3> normals;
  for (std::size_t v = 0; v < charts.positions.size(); ++v)
    normals.push_back(glm::normalize(charts.positions[v] + glm::vec3(v < charts.positions.size() / 2 ? 0.2f : 0.0f)));
  const DirectedPart whole{charts.positions, normals, charts.indices};
  const std::size_t half = charts.indices.size() / 2;
  const std::span all(charts.indices);
  const std::array halves = {DirectedPart{charts.positions, normals, all.first(half)},
                             DirectedPart{charts.positions, {}, all.subspan(half)}};
  const DirectionGap gap = direction_gap(std::span(&whole, 1));
  EXPECT_GT(gap.shared, 20u);
  EXPECT_GT(gap.split, 0u);
  EXPECT_LT(gap.split, gap.shared) << "charts of one half have equal normals";
  EXPECT_EQ(direction_gap(halves).shared, gap.shared) << "what has no normals is asked for none";
}

/// Two halves whose shared edge has vertices of its own on both sides, which follow two joints.
VertexStreams skinned(const std::vector<glm::vec4>& joints, const std::vector<glm::vec4>& weights) {
  VertexStreams streams = *vertex_streams(two_halves().positions);
  streams.base.push_back(float_stream("JOINTS_0", joints));
  streams.base.push_back(float_stream("WEIGHTS_0", weights));
  return streams;
}

TEST(InfluenceGap, CountsPositionsWhoseVerticesFollowJointsDifferently) {
  std::vector<glm::vec4> joints(6, glm::vec4(0, 1, 0, 0)), weights(6, glm::vec4(0.75f, 0.25f, 0, 0));
  const auto gap = [&] {
    const VertexStreams streams = skinned(joints, weights);
    const VertexStreams* part = &streams;
    return influence_gap(std::span(&part, 1));
  };
  EXPECT_EQ(gap().shared, 2u);
  EXPECT_EQ(gap().unequal, 0u);
  joints[3] = {1, 0, 5, 0};
  weights[3] = {1, 1.5f, 0, 1.5f};
  EXPECT_EQ(gap().unequal, 0u) << "the same shares in another sequence, twice, and not of 1 in sum";
  weights[4] = {0.75f, 0.2500005f, 0, 0};
  EXPECT_EQ(gap().unequal, 0u) << "rounding";
  weights[4] = {0.7f, 0.3f, 0, 0};
  EXPECT_EQ(gap().unequal, 1u);
  joints[0] = {0, 2, 0, 0};
  EXPECT_EQ(gap().unequal, 2u);
  weights[2] = {0, 0, 0, 1};
  EXPECT_EQ(gap().unequal, 2u) << "one vertex alone tears nothing";
  const VertexStreams plain = *vertex_streams(two_halves().positions);
  const VertexStreams* part = &plain;
  EXPECT_EQ(influence_gap(std::span(&part, 1)).shared, 0u);
}

TEST(SeamGap, OfEqualHeightsIsNone) {
  const SeamGap gap = seam_gap(two_halves().seams(), halves(777, 777).view());
  EXPECT_EQ(gap.largest, 0);
  EXPECT_EQ(gap.unequal, 0u);
  EXPECT_EQ(gap.below, 0u);
  EXPECT_EQ(gap.torn, 0u);
}

/// Heights that differ less than they are told apart are equal.
TEST(SeamGap, CountsInBits) {
  const SeamEdges seams = two_halves().seams();
  const testing::Map map = halves(1028, 1031);
  EXPECT_EQ(seam_gap(seams, map.view(), {.bits = 14}).unequal, 0u);
  EXPECT_EQ(seam_gap(seams, map.view(), {.bits = 16}).unequal, 33u);
  EXPECT_NEAR(seam_gap(seams, map.view()).largest, 3 / 65535.0, 1e-12);
}

TEST(SeamGap, IsWhatASecondOpinionSays) {
  for (const bool is_nearest : {false, true}) {
    const Charts charts = cube_sphere(4, turned_places());
    testing::Map map = noise_map(100, 77, 9);
    map.is_nearest = is_nearest;
    map.wrap = {FOREDRAW_HEIGHT_MIRRORED, FOREDRAW_HEIGHT_CLAMPED};
    const SeamGap gap = seam_gap(charts.seams(), map.view());
    const Opinion wanted = opinion(charts.mesh(), map);
    EXPECT_EQ(gap.edges, wanted.edges);
    EXPECT_NEAR(gap.largest, wanted.largest, is_nearest ? 0.02 : 1e-9);
    EXPECT_NEAR(std::sqrt(gap.squares / static_cast<double>(gap.samples)), wanted.rms, is_nearest ? 1e-3 : 1e-9);
  }
}

TEST(SeamGap, BearsAnything) {
  EXPECT_EQ(seam_gap({}, noise_map(1, 1, 1).view()).points, 0u);
  Charts charts = two_halves();
  charts.uvs[0].x = 1e30f;
  charts.uvs[1].y = -1e30f;
  const SeamGap gap = seam_gap(charts.seams(), halves(0, 65535).view());
  EXPECT_LE(gap.largest, 1);
  EXPECT_EQ(gap.samples, 201u);
}

double figure(const Findings& findings, const std::string& metric) {
  for (const Measured& one : findings.measured) {
    if (one.metric == metric) return one.numerator / one.denominator.value_or(1);
  }
  return -1;
}

TEST(SeamGapEvaluator, MeasuresDisplacedDrawsAndNamesEdges) {
  const Charts charts = two_halves();
  const testing::Map map = halves(13107, 52428);
  Scene scene = displaced_scene({charts.positions, charts.indices}, charts.uvs,
                                height_image(200, 100, [&](auto x, auto y) { return map.texels[200 * y + x]; }));
  RunFixture fixture;
  const Plugin plugin = seam_gap_plugin();
  const auto technique = plugin.create({{"samples", std::int64_t{201}}, {"bits", std::int64_t{14}}});
  std::get<std::unique_ptr<Evaluator>>(technique)->evaluate(scene, fixture.run);
  EXPECT_EQ(figure(fixture.findings, "edges"), 1);
  EXPECT_NEAR(figure(fixture.findings, "largest"), 60, 1e-9);
  EXPECT_NEAR(figure(fixture.findings, "rms"), 60, 1e-9);
  EXPECT_EQ(figure(fixture.findings, "unequal"), 100);
  EXPECT_EQ(figure(fixture.findings, "torn"), 100);
  ASSERT_EQ(fixture.findings.notes.size(), 1u);
  EXPECT_NE(fixture.findings.notes[0].message.find("triangle 0, edge 0"), std::string::npos);
  EXPECT_NE(fixture.findings.notes[0].message.find("differ by 0.6 of the map's range"), std::string::npos);
  EXPECT_EQ(figure(fixture.findings, "weights"), -1) << "nothing follows joints";
}

TEST(SeamGapEvaluator, TellsOfWeightsThatTearTheSurfaceInPoses) {
  const Charts charts = two_halves();
  Scene scene = displaced_scene({charts.positions, charts.indices}, charts.uvs,
                                height_image(4, 4, [](auto, auto) { return std::uint16_t{9}; }));
  VertexStreams streams = *scene.draws[0].full().vertices;
  std::vector<glm::vec4> weights(6, glm::vec4(1, 0, 0, 0));
  weights[3] = {0.5f, 0.5f, 0, 0};
  streams.base.push_back(float_stream("JOINTS_0", std::vector<glm::vec4>(6, glm::vec4(0, 1, 0, 0))));
  streams.base.push_back(float_stream("WEIGHTS_0", weights));
  scene.draws[0].full().vertices = std::make_shared<const VertexStreams>(std::move(streams));
  RunFixture fixture;
  const auto technique = seam_gap_plugin().create({});
  std::get<std::unique_ptr<Evaluator>>(technique)->evaluate(scene, fixture.run);
  EXPECT_EQ(figure(fixture.findings, "weights"), 50);
  const auto note = std::ranges::find(fixture.findings.notes, "weights-differ", &Note::code);
  ASSERT_NE(note, fixture.findings.notes.end());
  EXPECT_NE(note->message.find("at 1 of 2 positions"), std::string::npos) << note->message;
}

}  // namespace
}  // namespace foredraw::seam_gap_test

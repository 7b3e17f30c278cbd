// The stage: what it leaves with a scene, and what becomes of that.

#include "plugins/processors/tessellation_levels/tessellation_levels.h"
#include "plugins/processors/tessellation_levels/tessellation_levels_product.h"
#include "support/noisy.h"
#include "support/staged.h"

#include <foredraw/displaced/displaced_mesh.h>
#include <foredraw/displaced/scene_displacement.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <string>

namespace foredraw::tessellation_levels_stage_test {
namespace {

using ::testing::HasSubstr;

Scene noisy(std::uint32_t cells = 12, float factor = 0.5f, float offset = 0) {
  return testing::displaced_grid(cells, cells, testing::noise_image(256, 3), factor, offset);
}

const DrawTessellation& levels_in(const Scene& scene, DrawId draw = 0) {
  const DrawTessellation* of = tessellation_of(scene, draw);
  if (of == nullptr) throw std::runtime_error("the scene has no tessellation levels");
  return *of;
}

/// The reason that a stage kept things for, or all it said.
std::string said(const StageRecord& stage) {
  std::string text;
  for (const SkipRecord& skip : stage.skipped) text += skip.reason + '\n';
  for (const NoteRecord& note : stage.notes) text += note.code + ": " + note.message + '\n';
  return text;
}

TEST(TessellationLevelsStage, StoresLevelsThatTessellateTakes) {
  const Result stored = testing::run("tessellation-levels(triangles=3000)", noisy());
  ASSERT_EQ(stored.report.stages[0].notes.size(), 1u) << "the product's line alone: " << said(stored.report.stages[0]);
  EXPECT_THAT(stored.report.stages[0].notes[0].message, HasSubstr("triangles from 288, error rms "));
  const Scene& scene = stored.scene;
  const DrawTessellation& levels = levels_in(scene);
  EXPECT_EQ(levels.levels.size(), 288u);
  EXPECT_LE(levels.scales[0].triangles, 3000u);
  EXPECT_GT(levels.scales[0].triangles, 2500u);
  EXPECT_EQ(levels.ranges.size(), 3u);
  const Scene made = testing::run("tessellate", scene).scene;
  EXPECT_EQ(made.draws[0].full().stream().triangle_count(), levels.scales[0].triangles);
  EXPECT_EQ(tessellation_of(made, 0), nullptr) << "nothing is displaced any more";
  EXPECT_EQ(testing::run("tessellate(parts=2)", scene).scene.draws[0].full().stream().triangle_count(), 288u * 6);
  EXPECT_GT(testing::run("tessellate(texels=1)", scene).scene.draws[0].full().stream().triangle_count(), 50'000u);
}

TEST(TessellationLevelsStage, TakesFourTimesTheTrianglesWithoutALimit) {
  const Scene scene = testing::run("tessellation-levels", noisy()).scene;
  EXPECT_LE(levels_in(scene).scales[0].triangles, 4u * 288);
  EXPECT_GT(levels_in(scene).scales[0].triangles, 3u * 288);
}

TEST(TessellationLevelsStage, KeepsWhatGainsNothingAndSaysTheError) {
  for (const Scene& scene : {noisy(4, 0), testing::displaced_grid(4, 4, testing::noise_image(1, 3))}) {
    const Result result = testing::run("tessellation-levels", scene);
    EXPECT_FALSE(result.failed);
    EXPECT_EQ(tessellation_of(result.scene, 0), nullptr);
    EXPECT_THAT(said(result.report.stages[0]), HasSubstr("with an error of 0 units rms"));
  }
  const Result fine = testing::run("tessellation-levels(error=10)", noisy());
  EXPECT_EQ(tessellation_of(fine.scene, 0), nullptr);
}

TEST(TessellationLevelsStage, SaysWhyADrawHasNone) {
  Scene scene = noisy();
  scene.materials[0].displacement->texture.image.reset();
  const Result result = testing::run("tessellation-levels", scene);
  EXPECT_FALSE(result.failed);
  EXPECT_EQ(tessellation_of(result.scene, 0), nullptr);
  EXPECT_THAT(said(result.report.stages[0]), HasSubstr("its map is of a kind that is not known here"));
  const Result far = testing::run("tessellation-levels(error=0.000001)", noisy());
  EXPECT_THAT(said(far.report.stages[0]), HasSubstr("error-not-reached"));
}

/// Uvs and positions that are no numbers, uvs far away, triangles without an area, borders and an edge of three.
TEST(TessellationLevelsStage, BearsWhatIsBroken) {
  testing::TestMesh mesh = testing::grid(8, 8);
  std::vector<glm::vec2> uv = testing::square_uv(mesh, 8, 8);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  uv[3] = {nan, 0.5f}, uv[20] = {1e30f, -1e30f}, uv[40] = {-7.25f, 3.5f};
  mesh.positions[60].x = nan, mesh.positions[61].y = std::numeric_limits<float>::infinity();
  mesh.indices.insert(mesh.indices.end(), {30, 30, 31, 30, 31, 31, 32, 32, 32, 30, 31, 70, 0, 1, 2});
  for (const char* options : {"", "(goal='max')", "(error=0.001)", "(error=0.001, goal='max')",
                              "(method='edge-length')", "(method='constant', triangles=5000)"}) {
    const Scene scene = testing::displaced_scene(mesh, uv, testing::noise_image(64, 3), 0.5f);
    const Result result = testing::run("tessellation-levels" + std::string(options), scene);
    EXPECT_FALSE(result.failed) << options << said(result.report.stages[0]);
    ASSERT_NE(tessellation_of(result.scene, 0), nullptr) << options;
    EXPECT_EQ(tessellation_levels_product()->difference(result.scene), "");
    EXPECT_FALSE(testing::run("tessellate", result.scene).failed);
  }
}

/// A triangle without an area beside others does not hold them back.
TEST(TessellationLevelsStage, ThinTrianglesHaveNoSay) {
  testing::TestMesh mesh = testing::grid(8, 8);
  const std::vector<glm::vec2> uv = testing::square_uv(mesh, 8, 8);
  const Scene plain = testing::displaced_scene(mesh, uv, testing::noise_image(256, 3), 0.5f);
  const std::vector<std::uint32_t> before = mesh.indices;
  for (std::size_t i = 0; i < before.size(); i += 3)
    mesh.indices.insert(mesh.indices.end(), {before[i], before[i + 1], before[i]});
  const Scene thin = testing::displaced_scene(mesh, uv, testing::noise_image(256, 3), 0.5f);
  const Scene a = testing::run("tessellation-levels(error=0.01)", plain).scene;
  const Scene b = testing::run("tessellation-levels(error=0.01)", thin).scene;
  for (std::size_t t = 0; t < 128; ++t) EXPECT_EQ(levels_in(a).levels.view()[t], levels_in(b).levels.view()[t]);
}

using Corners = std::array<std::array<float, 3>, 3>;
std::map<Corners, LogLevels> by_place(const Scene& scene) {
  const Level& level = scene.draws[0].full();
  const auto at = decode_vec3(*level.vertices->find("POSITION"));
  const auto indices = level.stream().indices.view();
  std::map<Corners, LogLevels> all;
  for (std::size_t t = 0; t < indices.size() / 3; ++t) {
    Corners corners;
    for (std::size_t c = 0; c < 3; ++c) {
      const glm::vec3& p = at[indices[3 * t + c]];
      corners[c] = {p.x, p.y, p.z};
    }
    all[corners] = levels_in(scene).levels.view()[t];
  }
  return all;
}

/// All displacements of a draw lie in the range of their triangle.
void expect_covered(const Scene& scene, double most_slack = 0.6) {
  Analyses analyses;
  const auto map = std::get<LaidOutMap>(laid_out_map(scene, 0, analyses));
  const DrawTessellation& of = levels_in(scene);
  const auto indices = scene.draws[0].full().stream().indices.view();
  const std::vector<TessellationLevels> fine(of.levels.size(), {{16, 16, 16}, 16});
  const TessellatedMesh mesh =
      tessellated_mesh(indices, scene.draws[0].full().vertices->count, fine, TessellationSpacing::equal);
  const auto by =
      displacements(mesh, indices, map.places, map.sampled(), map.displacement.factor, map.displacement.offset);
  double slack = 0;
  for (std::size_t r = 0; r < of.ranges.size(); ++r) {
    const std::size_t begin = of.range_begins.view()[r];
    const std::size_t end = r + 1 < of.ranges.size() ? of.range_begins.view()[r + 1] : of.levels.size();
    float least = INFINITY, most = -INFINITY;
    for (std::size_t i = 3 * 384 * begin; i < 3 * 384 * end; ++i)
      least = std::min(least, by[mesh.indices[i]]), most = std::max(most, by[mesh.indices[i]]);
    EXPECT_LE(of.ranges.view()[r].least, least);
    EXPECT_GE(of.ranges.view()[r].most, most);
    slack = std::max<double>(slack, (least - of.ranges.view()[r].least) + (of.ranges.view()[r].most - most));
  }
  EXPECT_LT(slack, most_slack * std::abs(map.displacement.factor)) << "a bound that always holds is no bound";
}

TEST(TessellationLevelsStage, BoundsDisplacementsOfRanges) {
  expect_covered(testing::run("tessellation-levels(triangles=3000)", noisy(24)).scene);
  expect_covered(testing::run("tessellation-levels(triangles=3000)", noisy(24, -0.5f, 3)).scene);
  const Scene clustered =
      testing::run("tipsify, linear-clusters, tessellation-levels(triangles=3000)", noisy(24)).scene;
  const IndexStream& stream = clustered.draws[0].full().stream();
  ASSERT_TRUE(stream.clusters);
  EXPECT_EQ(levels_in(clustered).ranges.size(), stream.clusters->count());
  expect_covered(clustered);
}

TEST(TessellationLevelsStage, FollowsTriangles) {
  const Scene before = testing::run("tessellation-levels(triangles=3000)", noisy(24)).scene;
  for (const char* stages : {"tipsify", "tipsify, vertex-fetch", "tipsify, linear-clusters, dot-rule"}) {
    const Result after = testing::run(stages, before);
    ASSERT_FALSE(after.scene.draws[0].full().stream().indices == before.draws[0].full().stream().indices);
    EXPECT_EQ(by_place(after.scene), by_place(before)) << stages;
    EXPECT_EQ(levels_in(after.scene).scales, levels_in(before).scales);
    EXPECT_EQ(tessellation_levels_product()->difference(after.scene), "");
    expect_covered(after.scene, 1.01);  // of all ranges that a new one has triangles of
  }
}

TEST(TessellationLevelsStage, AreLeftOutWithTheReasonWhereTheyDoNotHold) {
  const Scene before = testing::run("tessellation-levels(triangles=3000)", noisy(24)).scene;
  const Result moved = testing::run("displacement(factor=2)", before);
  EXPECT_EQ(tessellation_of(moved.scene, 0), nullptr);
  EXPECT_THAT(said(moved.report.stages[0]), HasSubstr("are left out: its displacement has changed"));
  const Result fewer = testing::run("weld, quadric-collapse, simplify(ratio=0.5)", before);
  EXPECT_EQ(tessellation_of(fewer.scene, 0), nullptr);
  EXPECT_THAT(said(fewer.report.stages[2]), HasSubstr("are left out: its triangles were replaced"));
}

/// Two draws of a mesh, one of which moves hardly: a level at their common edge, and a table of its own for each.
TEST(TessellationLevelsStage, AgreesBetweenTheDrawsOfAMesh) {
  Scene scene = noisy();
  Draw beside = noisy().draws[0];
  VertexStreams vertices = *beside.full().vertices;
  std::vector<glm::vec3> at = decode_vec3(*vertices.find("POSITION"));
  for (glm::vec3& p : at) p.x += 12;
  for (VertexStream& stream : vertices.base) {
    if (stream.semantic == "POSITION") stream = testing::float_stream("POSITION", at);
  }
  beside.full().vertices = std::make_shared<const VertexStreams>(std::move(vertices));
  scene.materials.push_back(scene.materials[0]);
  scene.materials[1].displacement->factor = 0.01f;
  beside.material = 1;
  scene.draws.push_back(std::move(beside));
  scene.meshes[0].draws.push_back(1);
  for (const char* options : {"(triangles=4000)", "(triangles=4000, goal='max')"}) {
    const Result result = testing::run("tessellation-levels" + std::string(options), scene);
    ASSERT_FALSE(result.failed) << said(result.report.stages[0]);
    EXPECT_EQ(tessellation_levels_product()->difference(result.scene), "");
    EXPECT_LE(levels_in(result.scene, 0).scales[0].triangles + levels_in(result.scene, 1).scales[0].triangles, 4000u);
    EXPECT_GT(levels_in(result.scene, 0).scales.size(), levels_in(result.scene, 1).scales.size());
    StoredTessellations torn = *result.scene.products.find<StoredTessellations>();
    std::vector<LogLevels> levels(torn.draws[1].levels.size(), LogLevels{3, 3, 3, 3});
    torn.draws[1].levels = Shared(std::move(levels));
    EXPECT_NE(tessellation_disagreement(torn, result.scene), "");
  }
}

TEST(TessellationLevelsStage, ReplacesWhatThereWas) {
  const Scene coarse = testing::run("tessellation-levels(triangles=1000)", noisy()).scene;
  const Scene fine = testing::run("tessellation-levels(triangles=9000)", coarse).scene;
  EXPECT_GT(levels_in(fine).scales[0].triangles, 8000u);
  EXPECT_EQ(fine.products.find<StoredTessellations>()->draws.size(), 1u);
}

}  // namespace
}  // namespace foredraw::tessellation_levels_stage_test

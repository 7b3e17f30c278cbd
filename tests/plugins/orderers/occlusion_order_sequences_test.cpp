// occlusion-order with several orders of a subject that has several draws: a sequence for each order.

#include "framework/io/gltf/edits.h"
#include "support/overdraw.h"

#include "../../../evaluators/overdraw_raster/overdraw_raster.h"

#include <foredraw/io/image/images.h>
#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/runner.h>
#include <foredraw/scene/order_table.h>
#include <foredraw/technique/built_in_plugins.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace foredraw::occlusion_order_sequences_test {
namespace {

using namespace testing;
using ::testing::HasSubstr;

/// Spheres beside one another, each a draw of one mesh: which one hides which hangs on the side.
Scene row_of_balls(std::size_t count, std::optional<std::size_t> blended = {}) {
  GltfBuilder made;
  std::vector<GltfJson> primitives;
  for (std::size_t i = 0; i < count; ++i) {
    TestMesh ball = sphere(16, 8, 0.5f, {static_cast<float>(i % 2), 0, static_cast<float>(i / 2)});
    std::vector<float> positions;
    for (const glm::vec3& p : ball.positions) positions.insert(positions.end(), {p.x, p.y, p.z});
    const std::size_t position = made.add_values(positions, "VEC3");
    const float x = static_cast<float>(i % 2), z = static_cast<float>(i / 2);
    made.json["accessors"][position]["min"] = {x - 0.5f, -0.5f, z - 0.5f};
    made.json["accessors"][position]["max"] = {x + 0.5f, 0.5f, z + 0.5f};
    made.add("materials", {{"alphaMode", i == blended ? "BLEND" : "OPAQUE"}});
    primitives.push_back({{"attributes", {{"POSITION", position}}},
                          {"indices", made.add_values(ball.indices, "SCALAR")},
                          {"material", i}});
  }
  made.add_mesh(primitives[0]);
  for (std::size_t i = 1; i < count; ++i) made.json["meshes"][0]["primitives"].push_back(primitives[i]);
  made.json["scenes"] = {{{"nodes", {0}}}};
  made.json["scene"] = 0;
  return read(made);
}

Result run(const Scene& scene, const std::string& stages, int threads = 2) {
  Registry registry;
  add_built_in_plugins(registry);
  Diagnostics diagnostics;
  const auto pipeline =
      parse_file("pipeline = 1\nstages = [" + stages + "]\n[views]\nviews = \"fibonacci\"\ncount = 120\nsize = 48\n",
                 "test.toml", diagnostics);
  const auto plan = pipeline ? foredraw::plan(*pipeline, registry, scene, diagnostics) : std::nullopt;
  if (!plan) throw std::runtime_error(to_text(diagnostics));
  const Executor executor(threads);
  Analyses analyses(image_decoder({}));
  return optimize(*plan, scene, {executor, analyses});
}

/// What a run says of itself, for who wonders why a test fails.
std::string told(const Result& result) {
  std::string all;
  for (const Diagnostic& diagnostic : result.report.diagnostics) all += to_text(diagnostic);
  for (const SkipRecord& skip : result.report.stages.at(0).skipped) all += skip.reason + "; ";
  for (const NoteRecord& note : result.report.stages.at(0).notes) all += note.message + "; ";
  return all;
}

constexpr const char* four = "{ use = \"occlusion-order\", k = 4 }";

double ratio(const Scene& scene, const std::string& sequence) {
  const Findings findings =
      testing::evaluate(overdraw_raster_plugin(), scene,
                        {{"count", std::int64_t{60}}, {"size", std::int64_t{64}}, {"sequence", sequence}});
  const Measured& ratio = *testing::find(findings, "ratio", {});
  return ratio.numerator / *ratio.denominator;
}

TEST(OcclusionOrderSequences, StandInTheTableAndLowerOverdrawFromOtherSides) {
  const Scene scene = row_of_balls(6);
  const Result result = run(scene, four);
  ASSERT_EQ(order_tables(result.scene).size(), 1u) << told(result);
  const OrderTable& table = order_tables(result.scene)[0];
  EXPECT_EQ(table.parts, subjects_of(scene)[0].parts);
  EXPECT_EQ(table.sequences.size(), 24u);
  EXPECT_THAT(told(result), HasSubstr("6 draws in a sequence of their own"));
  const Scene without = run(scene, "{ use = \"occlusion-order\", k = 4, sequences = false }").scene;
  const double input = ratio(scene, "table");
  EXPECT_LT(ratio(result.scene, "table") - 1, 0.5 * (input - 1));
  EXPECT_EQ(ratio(without, "table"), ratio(without, "file"));
  EXPECT_LT(ratio(result.scene, "table") - 1, 0.6 * (ratio(without, "table") - 1));
  EXPECT_LE(ratio(result.scene, "file"), input) << "an engine that keeps to the file";
}

TEST(OcclusionOrderSequences, ComeBackFromTheFileAndThroughStagesThatKeepTriangles) {
  const Result result = run(row_of_balls(6), std::string(four) + ", \"vertex-fetch\"");
  const auto& table = order_tables(result.scene)[0];
  ASSERT_FALSE(table.parts.empty());
  const Scene again = read(write(result.scene));
  ASSERT_EQ(order_tables(again).size(), 1u);
  EXPECT_EQ(order_tables(again)[0], table);
  const Scene welded = run(again, "\"weld\"").scene;
  ASSERT_EQ(order_tables(welded).size(), 1u);
  EXPECT_EQ(order_tables(welded)[0], table);
  const Result sequenced = run(again, "\"draw-sequence\"");
  EXPECT_EQ(order_tables(sequenced.scene)[0], table);
  EXPECT_EQ(sequenced.scene.meshes[0].draws, again.meshes[0].draws);
  EXPECT_TRUE(order_tables(run(again, "{ use = \"tipsify\", only = \"" + again.draws[2].name + "\" }").scene).empty());
}

TEST(OcclusionOrderSequences, LeaveWhatIsBlendedInItsPlace) {
  const Result result = run(row_of_balls(7, 3), four);
  ASSERT_EQ(order_tables(result.scene).size(), 1u);
  const OrderTable& table = order_tables(result.scene)[0];
  ASSERT_EQ(table.parts.size(), 7u);
  bool any_moved = false;
  for (std::size_t order = 0; order < 4; ++order) {
    const auto sequence = table.sequence(order);
    EXPECT_EQ(sequence[3], 3);
    for (std::size_t rank = 0; rank < 3; ++rank) EXPECT_LT(sequence[rank], 3) << "nothing passes it";
    any_moved = any_moved || !std::ranges::is_sorted(sequence);
  }
  EXPECT_TRUE(any_moved);
}

TEST(OcclusionOrderSequences, AreNotMadeWhereNobodyCouldUseThem) {
  EXPECT_TRUE(order_tables(run(row_of_balls(6), "\"occlusion-order\"").scene).empty()) << "of a single order";
  for (const OrderTable& table : order_tables(run(row_of_balls(1), four).scene)) EXPECT_TRUE(table.parts.empty());
}

TEST(OcclusionOrderSequences, AreTheSameBytesAtAnyThreadCount) {
  const Scene scene = row_of_balls(6);
  EXPECT_EQ(write(run(scene, four, 1).scene), write(run(scene, four, 3).scene));
}

}  // namespace
}  // namespace foredraw::occlusion_order_sequences_test

// A product from its making through stages, files, inspection and the command line; no file outside of this folder
// names it.

#include "landmarks.h"
#include "support/meshes.h"
#include "support/program.h"

#include <foredraw/io/gltf/gltf.h>
#include <foredraw/io/side_files.h>
#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/runner.h>
#include <foredraw/report/inspection.h>
#include <foredraw/scene/order_table.h>
#include <foredraw/scene/reorder.h>
#include <foredraw/technique/built_in_plugins.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <numeric>
#include <set>

namespace foredraw::product_test {
namespace {

using testing::Landmarks;

/// Changes nothing, and says where ranges begin.
class TellsBounds final : public Processor {
 public:
  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    for (const DrawId draw : draws) {
      for (const std::uint32_t bound : run.bounds(scene, {draw, 0}, "none of these")) {
        run.keep("a range begins at " + std::to_string(bound));
      }
    }
    return draws;
  }
};

struct NoOptions {};

Plugin tells_bounds_plugin() {
  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {.name = "tells-bounds", .summary = "Says where ranges begin", .reference = "own"};
  bind_options(plugin, OptionTable<NoOptions>(), [](const NoOptions&) { return std::make_unique<TellsBounds>(); });
  return plugin;
}

Registry registry() {
  Registry made;
  add_built_in_plugins(made);
  made.add(testing::landmarks_plugin());
  made.add(tells_bounds_plugin());
  return made;
}

std::shared_ptr<const ProductRow> landmarks_row() {
  for (const auto& row : registry().products()) {
    if (row->card().name == Landmarks::product) return row;
  }
  throw std::runtime_error("there are no landmarks");
}

/// A grid whose vertices are there twice, its triangles in random order.
Scene doubled() {
  testing::TestMesh mesh = testing::shuffled(testing::joined(testing::grid(4, 4), testing::grid(4, 4)), 3);
  return testing::scene_of({testing::draw_of(mesh, "field")});
}

Result run(const std::string& stages, Scene scene) {
  static const Registry all = registry();
  Diagnostics diagnostics;
  const auto parsed = parse_stages(stages, "test", diagnostics);
  Pipeline pipeline;
  pipeline.stages = *parsed;
  const auto planned = plan(pipeline, all, scene, diagnostics);
  EXPECT_TRUE(planned) << to_text(diagnostics);
  const Executor executor(2);
  Analyses analyses;
  return optimize(*planned, std::move(scene), {executor, analyses});
}

/// What the numbers mean: positions of vertices, and of triangles' corners.
std::vector<glm::vec3> meant(const Scene& scene) {
  std::vector<glm::vec3> places;
  for (const Landmarks::OfDraw& of : scene.products.find<Landmarks>()->draws) {
    const Level& level = scene.draws[of.draw].levels[0];
    const auto positions = decode_vec3(*level.vertices->find("POSITION"));
    for (const std::uint32_t v : of.vertices) places.push_back(positions[v]);
    for (const std::uint32_t t : of.triangles) {
      for (std::size_t c = 0; c < 3; ++c)
        places.push_back(positions[level.orders[0].indices.view()[3 * std::size_t{t} + c]]);
    }
  }
  return places;
}

TEST(Product, FollowsReorderedTrianglesAndRenumberedAndWeldedVertices) {
  const Result made = run("landmarks", doubled());
  ASSERT_FALSE(made.failed);
  const auto wanted = meant(made.scene);
  bool has_changed = false;
  for (const std::string stages : {"tipsify", "vertex-fetch", "weld", "weld, tipsify, occlusion-order, vertex-fetch"}) {
    const Result moved = run("landmarks, " + stages, doubled());
    EXPECT_FALSE(moved.failed);
    has_changed = has_changed || !moved.scene.products.same(Landmarks::product, made.scene.products);
    EXPECT_EQ(meant(moved.scene), wanted) << stages;
  }
  EXPECT_TRUE(has_changed);
}

/// The triangles that lie in [first, end), by their corners' positions, in no order.
std::multiset<std::array<float, 9>> triangles_in(const Level& level, const IndexStream& stream, std::size_t first,
                                                 std::size_t end) {
  const auto positions = decode_vec3(*level.vertices->find("POSITION"));
  std::multiset<std::array<float, 9>> triangles;
  for (std::size_t t = first; t < end; ++t) {
    std::array<float, 9> corners;
    for (std::size_t c = 0; c < 9; ++c) {
      corners[c] = positions[stream.indices.view()[3 * t + c / 3]][static_cast<int>(c % 3)];
    }
    triangles.insert(corners);
  }
  return triangles;
}

/// That each order of each level has the triangles of each half in that half still.
void expect_parts_stay(const Draw& before, const Draw& after, const std::string& what) {
  for (std::size_t i = 0; i < before.levels.size(); ++i) {
    const Level& old = before.levels[i];
    const std::size_t count = old.stream().triangle_count();
    const std::size_t bound = count / (i == 0 ? 3 : 2);
    for (const IndexStream& stream : after.levels[i].orders) {
      ASSERT_EQ(stream.triangle_count(), count) << what;
      EXPECT_EQ(triangles_in(after.levels[i], stream, 0, bound), triangles_in(old, old.stream(), 0, bound)) << what;
    }
  }
}

TEST(Product, WithRangesHasEveryOrderWithinThem) {
  Scene scene = doubled();
  Level coarser = scene.draws[0].full();  // the same triangles backwards
  std::vector<std::uint32_t> backwards(coarser.stream().indices.view().rbegin(),
                                       coarser.stream().indices.view().rend());
  coarser.stream().indices = Shared<std::uint32_t>(std::move(backwards));
  coarser.origin.reset();
  scene.draws[0].levels.push_back(coarser);
  std::size_t changed = 0;
  const Registry plugins = registry();
  for (const Plugin* plugin : plugins.all()) {
    const bool orders = plugin->kind == Kind::orderer || plugin->kind == Kind::clusterer;
    if (!orders) continue;
    const std::string alone = plugin->card.needs.has(traits::clustered) ? "linear-clusters, " : "";
    for (const std::string& stages : {alone + plugin->card.name, "tipsify, linear-clusters, " + plugin->card.name,
                                      "linear-clusters, " + plugin->card.name + ", weld, tipsify"}) {
      const Result result = run("landmarks(parts=true), " + stages, scene);
      EXPECT_FALSE(result.failed) << stages;
      expect_parts_stay(scene.draws[0], result.scene.draws[0], stages);
      EXPECT_TRUE(result.scene.products.has(Landmarks::product)) << stages;
      const IndexStream& stream = result.scene.draws[0].full().stream();
      changed += !std::ranges::equal(stream.indices.view(), scene.draws[0].full().stream().indices.view());
      if (stream.clusters) {
        EXPECT_TRUE(std::ranges::binary_search(stream.clusters->offsets,
                                               static_cast<std::uint32_t>(stream.triangle_count() / 3)))
            << stages << ": no cluster crosses a bound";
      }
    }
  }
  EXPECT_GE(changed, 10u);
}

/// Who makes a product anew is not bound by the one that it takes the place of.
TEST(Product, WithRangesTellsThemToProcessorsThatOrder) {
  const Scene scene = run("landmarks(parts=true)", doubled()).scene;
  const auto rows = registry().products();
  const auto third = static_cast<std::uint32_t>(scene.draws[0].full().stream().triangle_count() / 3);
  EXPECT_EQ(bounds_of(scene, {0, 0}, rows), (std::vector<std::uint32_t>{third}));
  EXPECT_TRUE(bounds_of(scene, {0, 0}, rows, Landmarks::product).empty());
  EXPECT_TRUE(bounds_of(doubled(), {0, 0}, rows).empty()) << "a scene without landmarks";
  const Result asked = run("landmarks(parts=true), tells-bounds", doubled());
  ASSERT_EQ(asked.report.stages.at(1).skipped.size(), 1u);
  EXPECT_EQ(asked.report.stages[1].skipped[0].reason, "a range begins at " + std::to_string(third));
}

TEST(Product, WithRangesCutsTheClustersThatThereWere) {
  const Result result = run("linear-clusters(lambda=3, growth=4), landmarks(parts=true), dot-rule", doubled());
  ASSERT_FALSE(result.failed);
  const IndexStream& stream = result.scene.draws[0].full().stream();
  ASSERT_TRUE(stream.clusters);
  EXPECT_TRUE(
      std::ranges::binary_search(stream.clusters->offsets, static_cast<std::uint32_t>(stream.triangle_count() / 3)));
}

TEST(Product, WithRangesHasATableOfOrdersWithinThem) {
  Scene scene = testing::scene_of({testing::draw_of(
      testing::shuffled(testing::joined(testing::sphere(12, 16, 1), testing::sphere(12, 16, 0.7f)), 5), "shells")});
  const Result result = run("landmarks(parts=true), occlusion-order(k=3)", scene);
  ASSERT_FALSE(result.failed);
  EXPECT_GT(result.scene.draws[0].full().orders.size(), 1u);
  expect_parts_stay(scene.draws[0], result.scene.draws[0], "k=3");
  const auto* tables = result.scene.products.find<DrawOrders>();
  ASSERT_NE(tables, nullptr);
  EXPECT_EQ(tables->tables.at(0).draws, (std::vector<DrawId>{0}));
}

TEST(Product, WhoseRangesAreCrossedIsLeftOut) {
  Scene scene = run("landmarks(parts=true)", doubled()).scene;
  const Scene before = scene;
  std::vector<std::uint32_t> order(scene.draws[0].full().stream().triangle_count());
  std::iota(order.rbegin(), order.rend(), 0u);
  scene.draws[0] = with_triangle_order(scene.draws[0], order);
  EXPECT_EQ(landmarks_row()->follow(before, scene).size(), 1u);
  EXPECT_FALSE(scene.products.has(Landmarks::product));
}

TEST(Product, GoesStaleWhereADrawIsMadeAnewAndTheReportSaysSo) {
  Scene scene = run("landmarks", doubled()).scene;
  const Scene before = scene;
  scene.draws[0] = testing::draw_of(testing::grid(1, 1), "field");
  const auto told = landmarks_row()->follow(before, scene);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_NE(told[0].find("was made anew"), std::string::npos);
  EXPECT_FALSE(scene.products.has(Landmarks::product));
}

TEST(Product, ThatIsWrongFailsTheStageThatMadeIt) {
  const Result result = run("landmarks(wrong=true)", doubled());
  EXPECT_TRUE(result.failed);
  EXPECT_FALSE(result.scene.products.has(Landmarks::product));
  EXPECT_NE(result.report.diagnostics.at(0).message.find("its landmarks differ from the scene: field has no vertex 50"),
            std::string::npos)
      << result.report.diagnostics.at(0).message;
}

TEST(Product, ComesBackFromAFileAndIsAForeignExtensionToWhoHasNoRow) {
  const ProductRows rows = registry().products();
  const Scene scene = run("landmarks", doubled()).scene;
  Diagnostics diagnostics;
  const auto files = encode_gltf(scene, "out.glb", diagnostics, {.products = rows});
  ASSERT_TRUE(files) << to_text(diagnostics);
  const auto again = read_gltf(files->front().bytes, "again", {}, diagnostics, {.products = rows});
  ASSERT_TRUE(again) << to_text(diagnostics);
  EXPECT_TRUE(again->products.same(Landmarks::product, scene.products));
  const auto unchanged = encode_gltf(*again, "out.glb", diagnostics);
  EXPECT_EQ(unchanged->front().bytes, files->front().bytes);

  const auto foreign = read_gltf(files->front().bytes, "foreign", {}, diagnostics);
  ASSERT_TRUE(foreign);
  EXPECT_TRUE(foreign->products.empty());
  EXPECT_EQ(encode_gltf(*foreign, "out.glb", diagnostics)->front().bytes, files->front().bytes)
      << "it stays as it came";
}

TEST(Product, ThatDoesNotHoldIsLeftOutWhenReadAndWhenWritten) {
  const ProductRows rows = registry().products();
  Scene scene = run("landmarks", doubled()).scene;
  Landmarks landmarks = *scene.products.find<Landmarks>();
  landmarks.draws[0].vertices[0] = 1000;
  scene.products.set(landmarks);
  Diagnostics diagnostics;
  const auto files = encode_gltf(scene, "out.glb", diagnostics, {.products = rows});
  ASSERT_EQ(diagnostics.all().size(), 1u);
  EXPECT_EQ(diagnostics.all()[0].code, "landmarks-left-out");
  const auto again = read_gltf(files->front().bytes, "again", {}, diagnostics, {.products = rows});
  EXPECT_FALSE(again->products.has(Landmarks::product));
}

TEST(Product, IsInspectedAndWrittenBesideByItsRow) {
  const Scene scene = run("landmarks", doubled()).scene;
  const ProductRows rows = registry().products();
  Analyses analyses;
  EXPECT_NE(
      inspection_text(scene, rows, analyses, Executor(1)).find("landmarks (known places):\n  field: 2 vertices\n"),
      std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(
                inspection_json(scene, rows, {}, analyses, Executor(1)))["products"]["landmarks"][0]["draw"],
            "field");
  const auto row = *std::ranges::find_if(rows, [](const auto& one) { return one->card().name == "landmarks"; });
  Diagnostics diagnostics;
  const auto files = encode_side_file(scene, *row, "folder/x.json", diagnostics);
  ASSERT_EQ(files->size(), 2u);
  EXPECT_EQ(files->at(1).path, "folder/x.json.bin");
  EXPECT_EQ(files->at(1).bytes.size(), 4u);
}

class ProductProgram : public testing::InFolder {};

TEST_F(ProductProgram, WritesKindsAndSaysWhichWhereSeveralFit) {
  const std::string model = testing::project_file("benchmarks/corpus/static/spot.glb").string();
  const auto made = testing::run_program(
      folder_,
      "optimize '" + model + "' -o out.glb -o marks.csv -o landmarks:m.json -o remap:r.json -p 'landmarks, tipsify'");
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_EQ(testing::content(folder_ / "marks.csv"), "draw,vertices\n0,2\n");
  EXPECT_TRUE(std::filesystem::exists(folder_ / "m.json.bin"));
  EXPECT_NE(testing::content(folder_ / "r.json").find("new-to-old"), std::string::npos);
  const auto which = testing::run_program(folder_, "optimize '" + model + "' -o x.json -p landmarks");
  EXPECT_EQ(which.code, 1);
  EXPECT_NE(which.err.find("-o landmarks:x.json"), std::string::npos) << which.err;
  EXPECT_NE(which.err.find("-o remap:x.json"), std::string::npos) << which.err;
  const auto inspected = testing::run_program(folder_, "inspect out.glb");
  EXPECT_NE(inspected.out.find("landmarks (known places)"), std::string::npos);
  const auto schema = testing::run_program(folder_, "schema landmarks");
  EXPECT_TRUE(nlohmann::json::accept(schema.out)) << schema.out;
  const auto without = testing::run_program(folder_, "optimize out.glb -o bare.glb -p vertex-fetch --products none");
  ASSERT_EQ(without.code, 0) << without.err;
  EXPECT_EQ(testing::content(folder_ / "bare.glb").find("EXAMPLE_landmarks"), std::string::npos);
}

}  // namespace
}  // namespace foredraw::product_test

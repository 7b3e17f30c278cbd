#include "../../evaluators/vertex_cache/vertex_cache.h"

#include "support/edit_product.h"
#include "support/meshes.h"

#include <foredraw/scene/order_table.h>
#include <foredraw/technique/plugin.h>

#include <gtest/gtest.h>
#include <meshoptimizer.h>
#include <rapidcheck/gtest.h>

namespace foredraw::vertex_cache_test {
namespace {

using testing::TestMesh;

/// Triangle lists with much reuse, repeated corners among them.
rc::Gen<std::vector<std::uint32_t>> index_lists(std::uint32_t vertices) {
  return rc::gen::map(rc::gen::container<std::vector<std::uint32_t>>(rc::gen::inRange<std::uint32_t>(0, vertices)),
                      [](std::vector<std::uint32_t> indices) {
                        indices.resize(indices.size() / 3 * 3);
                        return indices;
                      });
}

void expect_equal_to_peer(std::span<const std::uint32_t> indices, std::size_t vertices, const BatchModel& model) {
  const CacheCount ours = count_batches(indices, vertices, model);
  const meshopt_VertexCacheStatistics theirs = meshopt_analyzeVertexCache(
      indices.data(), indices.size(), vertices, model.cache_size, model.warp_size, model.primitive_group);
  ASSERT_EQ(ours.misses, theirs.vertices_transformed);
  if (!indices.empty()) {
    ASSERT_EQ(static_cast<float>(ours.misses) / static_cast<float>(ours.referenced), theirs.atvr);
  }
}

RC_GTEST_PROP(VertexCache, batches_count_as_meshoptimizer_does, ()) {
  const auto indices = *rc::gen::scale(10, index_lists(60));
  const BatchModel model{"any", *rc::gen::inRange(3u, 40u), *rc::gen::element(0u, 6u, 32u, 64u),
                         *rc::gen::element(0u, 1u, 7u, 32u)};
  const CacheCount ours = count_batches(indices, 60, model);
  const auto theirs = meshopt_analyzeVertexCache(indices.data(), indices.size(), 60, model.cache_size, model.warp_size,
                                                 model.primitive_group);
  RC_ASSERT(ours.misses == theirs.vertices_transformed);
}

TEST(VertexCache, vendor_models_count_as_meshoptimizer_does) {
  for (const TestMesh& mesh :
       {testing::torus(60, 40), testing::shuffled(testing::grid(50, 30), 5), testing::soup(90, 1)}) {
    for (const BatchModel& model : batch_models) expect_equal_to_peer(mesh.indices, mesh.positions.size(), model);
    for (const std::uint32_t size : {3u, 16u, 1000u}) {
      expect_equal_to_peer(mesh.indices, mesh.positions.size(), {"fifo", size, 0, 0});
    }
  }
}

TEST(VertexCache, fetches_as_meshoptimizer_does) {
  // 200 x 200 vertices of 48 bytes are more than the 128 KiB that the cache holds.
  for (const TestMesh& mesh :
       {testing::grid(200, 200), testing::shuffled(testing::grid(200, 200), 5), testing::soup(90, 1)}) {
    for (const std::size_t vertex_size : {1, 12, 32, 48, 100, 256}) {
      const std::size_t vertices = mesh.positions.size();
      const FetchCount ours = count_fetches(mesh.indices, vertices, vertex_size);
      const auto theirs = meshopt_analyzeVertexFetch(mesh.indices.data(), mesh.indices.size(), vertices, vertex_size);
      EXPECT_EQ(ours.fetched, theirs.bytes_fetched);
      EXPECT_EQ(static_cast<float>(ours.fetched) / static_cast<float>(ours.referenced), theirs.overfetch);
    }
  }
}

TEST(VertexCache, figures_of_a_draw) {
  const Plugin plugin = vertex_cache_plugin();
  const Technique technique = plugin.create({{"cache-size", std::int64_t{3}}, {"vertex-size", std::int64_t{64}}});
  // Two triangles that share an edge, and a third one of which a cache of three has lost one corner.
  TestMesh mesh = testing::grid(1, 1);
  mesh.positions.emplace_back(9, 9, 9);  // never drawn
  mesh.indices.insert(mesh.indices.end(), {0, 1, 2});
  const Scene scene = testing::scene_of(mesh);
  testing::RunFixture fixture;
  std::get<std::unique_ptr<DrawEvaluator>>(technique)->evaluate({scene, 0}, fixture.run);

  std::map<std::string, std::pair<double, double>> figures;
  for (const Measured& measured : fixture.findings.measured) {
    EXPECT_TRUE(figures.emplace(measured.metric, std::pair(measured.numerator, measured.denominator.value())).second);
  }
  // 0 1 2 miss; 2 1 hit, 3 misses and drives out 0; then 0 misses and drives out 1, which misses and drives out 2.
  EXPECT_EQ(figures.at("acmr"), std::pair(7.0, 3.0));
  EXPECT_EQ(figures.at("atvr"), std::pair(7.0, 4.0));
  EXPECT_EQ(figures.at("overfetch"), std::pair(256.0, 256.0));
  for (const char* model :
       {"fifo-12", "fifo-16", "fifo-20", "fifo-24", "fifo-32", "lru-16", "nvidia", "amd", "intel"}) {
    EXPECT_EQ(figures.at("models." + std::string(model) + ".acmr"), std::pair(4.0, 3.0)) << model;
    EXPECT_EQ(figures.at("models." + std::string(model) + ".atvr"), std::pair(4.0, 4.0)) << model;
  }
  EXPECT_EQ(figures.size(), 3 + 2 * 9u);
}

TEST(VertexCache, several_orders_weigh_as_their_tables_say) {
  const Plugin plugin = vertex_cache_plugin();
  const Technique technique = plugin.create({{"vertex-size", std::int64_t{2048}}, {"models", std::string("lru-4")}});
  const auto figures_of = [&](const Scene& scene) {
    testing::RunFixture fixture;
    std::get<std::unique_ptr<DrawEvaluator>>(technique)->evaluate({scene, 0}, fixture.run);
    std::map<std::string, std::pair<double, double>> figures;
    for (const Measured& measured : fixture.findings.measured) {
      figures[measured.metric] = {measured.numerator, measured.denominator.value()};
    }
    return figures;
  };
  const TestMesh mesh = testing::grid(20, 20);
  Scene scene = testing::scene_of(mesh);
  IndexStream bad{Shared<std::uint32_t>(testing::shuffled(mesh, 3).indices)};
  const auto good_figures = figures_of(scene);
  scene.draws[0].levels[0].orders.push_back(bad);
  EXPECT_EQ(figures_of(scene), good_figures) << "without a table nobody draws the second";
  const auto bad_figures = figures_of([&] {
    Scene alone = scene;
    alone.draws[0].levels[0].orders = {bad};
    return alone;
  }());
  // The cap down to 60 degrees from +Y is a quarter of the sphere; of two keyframes that makes an eighth.
  testing::edit<DrawOrders>(scene)->tables.push_back({{0}, {{"Walk", {0, 1}}}, 3, 1, {1, 0, 0, 0, 0, 0}});
  const auto figures = figures_of(scene);
  for (const auto& [metric, good] : good_figures) {
    const auto& worse = bad_figures.at(metric);
    EXPECT_NEAR(figures.at(metric).first, good.first * 7 / 8 + worse.first / 8, 1e-6) << metric;
    EXPECT_EQ(figures.at(metric).second, good.second) << metric;
    EXPECT_GT(worse.first, good.first) << metric;
  }
}

TEST(VertexCache, a_model_is_what_its_name_says) {
  const TestMesh mesh = testing::shuffled(testing::grid(30, 30), 2);
  const std::size_t vertices = mesh.positions.size();
  const auto of = [&](const char* name) { return count(mesh.indices, vertices, cache_model(name).value()); };
  EXPECT_EQ(of("fifo-7"), count_fifo(mesh.indices, vertices, 7));
  EXPECT_EQ(of("lru-300"), count_lru(mesh.indices, vertices, 300));
  EXPECT_EQ(of("batches-32-32-32"), of("nvidia"));
  EXPECT_EQ(of("batches-9-0-5"), count_batches(mesh.indices, vertices, {"", 9, 0, 5}));
  for (const char* name : {"", "fifo", "fifo-", "fifo-0", "fifo-x", "fifo-16-2", "lru--1", "lru-65536", "batches-1-2",
                           "batches-1-2-3-4", "voodoo", "fifo-16 "}) {
    EXPECT_FALSE(cache_model(name)) << name;
  }
}

TEST(VertexCache, an_unknown_model_is_a_mistake_that_names_the_known_ones) {
  const Plugin plugin = vertex_cache_plugin();
  EXPECT_THROW(plugin.create({{"models", std::string("fifo-16 lifo-16")}}), std::invalid_argument);
}

}  // namespace
}  // namespace foredraw::vertex_cache_test

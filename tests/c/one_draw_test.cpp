// Orders of one draw are those of the functions and of pipelines on a scene; what is wrong is said.

#include <foredraw/c/foredraw.h>
#include <foredraw/c/functions.h>

#include "bumpy_sheet.h"
#include "handles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <numeric>
#include <thread>

namespace foredraw::testing::one_draw_test {
namespace {

using Order = std::vector<std::uint32_t>;

class OneDraw : public ::testing::Test {
 protected:
  Order order(const std::string& stages) {
    Order made(count());
    EXPECT_EQ(foredraw_order(context_.get(), stages.c_str(), &triangles_, &positions_, made.data(), nullptr),
              FOREDRAW_DONE)
        << stages;
    return made;
  }
  std::size_t count() const { return sheet_.indices.size() / 3; }

  /// What the same pipeline makes of a scene of the draw.
  Order order_in_a_scene(const std::string& pipeline) {
    std::vector<std::uint32_t> indices(sheet_.indices.begin(), sheet_.indices.end());
    std::vector<float> places;
    for (const auto& vertex : sheet_.vertices) places.insert(places.end(), vertex.position, vertex.position + 3);
    foredraw_draw draw{};
    draw.size = sizeof draw;
    draw.vertex_count = triangles_.vertex_count;
    draw.triangle_count = count();
    draw.indices = indices.data();
    draw.positions = places.data();
    foredraw_scene *scene = nullptr, *made = nullptr;
    EXPECT_EQ(foredraw_make_scene(context_.get(), &draw, 1, &scene, nullptr), FOREDRAW_DONE);
    const SceneHandle given(scene);
    EXPECT_EQ(foredraw_optimize(context_.get(), scene, pipeline.c_str(), &made, nullptr), FOREDRAW_DONE);
    const SceneHandle held(made);
    const std::uint32_t *moved = nullptr, *vertices = nullptr;
    EXPECT_EQ(foredraw_scene_moves(made, 0, &moved, &vertices, nullptr), FOREDRAW_DONE);
    Order all(count());
    std::iota(all.begin(), all.end(), 0u);
    return moved == nullptr ? all : Order(moved, moved + count());
  }

  /// The diagnostics that come with a refusal.
  std::string refused(const std::string& stages, const foredraw_triangles& triangles) {
    Told report;
    Order made(count() + 1, 7);
    EXPECT_EQ(foredraw_order(context_.get(), stages.c_str(), &triangles, &positions_, made.data(), report.out()),
              FOREDRAW_MISTAKE);
    EXPECT_EQ(made, Order(count() + 1, 7));
    return report.json().at("diagnostics").dump();
  }

  const BumpySheet sheet_{20};
  const foredraw_triangles triangles_ = sheet_.triangles();
  const foredraw_positions positions_ = sheet_.positions();
  const Context context_{foredraw_context_new(nullptr)};
};

TEST_F(OneDraw, HasTheOrdersOfTheFunctions) {
  Order made(count());
  ASSERT_EQ(foredraw_tipsify(made.data(), &triangles_, 24), FOREDRAW_DONE);
  EXPECT_EQ(order("tipsify(cache-size=24)"), made);
  ASSERT_EQ(foredraw_forsyth(made.data(), &triangles_, 0), FOREDRAW_DONE);
  EXPECT_EQ(order("forsyth"), made);
  ASSERT_EQ(foredraw_lookahead(made.data(), &triangles_, FOREDRAW_LOOKAHEAD_HIGH, 0, 0), FOREDRAW_DONE);
  EXPECT_EQ(order("lookahead(quality=high)"), made);
}

TEST_F(OneDraw, HasTheOrderOfItsVertices) {
  BumpySheet sheet(250);                            // more than the caches between hold
  const std::size_t count = sheet.vertices.size();  // which 619 does not divide, so that each number comes once
  for (std::uint16_t& index : sheet.indices) index = static_cast<std::uint16_t>(index * 619u % count);
  const foredraw_triangles triangles = sheet.triangles();
  const foredraw_positions positions = sheet.positions();
  Order made(sheet.vertices.size()), vertices(sheet.vertices.size());
  ASSERT_EQ(foredraw_vertex_fetch(made.data(), nullptr, &triangles), FOREDRAW_DONE);
  ASSERT_EQ(foredraw_order(context_.get(), "vertex-fetch", &triangles, &positions, vertices.data(), nullptr),
            FOREDRAW_DONE);
  EXPECT_EQ(vertices, made);
  EXPECT_FALSE(std::ranges::is_sorted(made));
}

TEST_F(OneDraw, HasTheOcclusionOrderOfThePipelineAndOfTheFunction) {
  const std::string pipeline =
      "pipeline = 1\nstages = [{use = \"occlusion-order\", quality = \"QUALITY\"}]\nmeasure = [\"vertex-cache\"]\n"
      "[views]\nviews = \"fibonacci\"\ncount = 80\nsize = 128\n";
  Order of_function(count());
  const std::pair<int, const char*> qualities[] = {
      {FOREDRAW_OCCLUSION_FAST, "fast"}, {FOREDRAW_OCCLUSION_BALANCED, "balanced"}, {FOREDRAW_OCCLUSION_HIGH, "high"}};
  for (const auto& [quality, name] : qualities) {
    std::string text = pipeline;
    text.replace(text.find("QUALITY"), 7, name);
    ASSERT_EQ(foredraw_occlusion_order(of_function.data(), &triangles_, &positions_, quality, 0, 0, 0), FOREDRAW_DONE);
    EXPECT_EQ(of_function, order_in_a_scene(text)) << name;
  }
  EXPECT_FALSE(std::ranges::is_sorted(of_function));
  EXPECT_EQ(order("occlusion-order"), order_in_a_scene("occlusion-order"));
  EXPECT_EQ(foredraw_occlusion_order(of_function.data(), &triangles_, &positions_, 4, 0, 0, 0), FOREDRAW_OPTION_RANGE);
  EXPECT_EQ(foredraw_occlusion_order(of_function.data(), &triangles_, &positions_, 0, .5, 0, 0), FOREDRAW_OPTION_RANGE);
  EXPECT_EQ(foredraw_occlusion_order(of_function.data(), &triangles_, nullptr, 0, 0, 0, 0), FOREDRAW_NULL_POINTER);
}

TEST_F(OneDraw, HasTheOrdersOfLinesOfStages) {
  for (const char* line : {"lookahead, occlusion-order", "tipsify, linear-clusters, dot-rule",
                           "lookahead, animated-kmeans(k=1)", "forsyth, tipsify"}) {
    EXPECT_EQ(order(line), order_in_a_scene(line)) << line;
  }
}

TEST_F(OneDraw, HasTheOverdrawOfTheEvaluator) {
  foredraw_overdraw_figures figures;
  ASSERT_EQ(foredraw_overdraw(&figures, &triangles_, &positions_, 0, 0, 0), FOREDRAW_DONE);
  Order indices(sheet_.indices.begin(), sheet_.indices.end());
  std::vector<float> places;
  for (const auto& vertex : sheet_.vertices) places.insert(places.end(), vertex.position, vertex.position + 3);
  foredraw_draw draw{};
  draw.size = sizeof draw;
  draw.vertex_count = triangles_.vertex_count, draw.triangle_count = count();
  draw.indices = indices.data(), draw.positions = places.data();
  foredraw_scene* scene = nullptr;
  ASSERT_EQ(foredraw_make_scene(context_.get(), &draw, 1, &scene, nullptr), FOREDRAW_DONE);
  const SceneHandle held(scene);
  Told report;
  ASSERT_EQ(foredraw_measure(context_.get(), scene, "overdraw-raster", report.out()), FOREDRAW_DONE);
  const Json measured = report.json().at("totals").at("metrics").at("overdraw-raster");
  EXPECT_NEAR(figures.ratio, measured.at("ratio").at("value").get<double>(), 1e-6);
  EXPECT_NEAR(figures.error, measured.at("ratio").at("error").get<double>(), 1e-6);
  EXPECT_NEAR(figures.worst_view, measured.at("worst-view").at("value").get<double>(), 1e-6);
}

TEST_F(OneDraw, HasItsClusters) {
  Order made(count()), offsets(count() + 1), expected(count() + 1);
  std::uint32_t clusters = 0, of_function = 0;
  ASSERT_EQ(foredraw_cluster(context_.get(), "tipsify, linear-clusters", &triangles_, &positions_, made.data(),
                             offsets.data(), &clusters, nullptr),
            FOREDRAW_DONE);
  EXPECT_EQ(made, order("tipsify"));
  std::vector<std::uint16_t> drawn(sheet_.indices.size());
  ASSERT_EQ(foredraw_reorder_triangles(drawn.data(), &triangles_, made.data()), FOREDRAW_DONE);
  foredraw_triangles cached = triangles_;
  cached.indices = drawn.data();
  ASSERT_EQ(foredraw_linear_clusters(expected.data(), &of_function, &cached, 0, 0), FOREDRAW_DONE);
  ASSERT_EQ(clusters, of_function);
  EXPECT_TRUE(std::equal(expected.begin(), expected.begin() + of_function + 1, offsets.begin()));
  ASSERT_EQ(foredraw_cluster(context_.get(), "linear-clusters", &cached, &positions_, nullptr, offsets.data(),
                             &clusters, nullptr),
            FOREDRAW_DONE);
  EXPECT_EQ(clusters, of_function);
  EXPECT_EQ(foredraw_cluster(context_.get(), "tipsify", &triangles_, &positions_, made.data(), offsets.data(),
                             &clusters, nullptr),
            FOREDRAW_MISTAKE);
  EXPECT_EQ(foredraw_cluster(context_.get(), "tipsify, linear-clusters", &triangles_, &positions_, nullptr,
                             offsets.data(), &clusters, nullptr),
            FOREDRAW_NULL_POINTER);
}

TEST_F(OneDraw, OfNothingIsNothing) {
  const foredraw_triangles nothing{nullptr, 0, 4, 0};
  EXPECT_EQ(foredraw_order(context_.get(), "lookahead", &nothing, nullptr, nullptr, nullptr), FOREDRAW_DONE);
}

TEST_F(OneDraw, IsRefusedInWords) {
  EXPECT_NE(refused("tipsfy", triangles_).find("tipsfy"), std::string::npos);
  EXPECT_NE(refused("weld", triangles_).find("neither orders nor clusters"), std::string::npos);
  EXPECT_NE(refused("tipsify, vertex-fetch", triangles_).find("orders vertices"), std::string::npos);
  EXPECT_NE(refused("occlusion-order(k=2)", triangles_).find("several orders"), std::string::npos);
  foredraw_triangles bad = triangles_;
  bad.index_count = (std::uint64_t{3} << 31) + 3;
  EXPECT_NE(refused("tipsify", bad).find("2147483649 triangles are too many"), std::string::npos);
  bad = triangles_, bad.vertex_count = 3;
  EXPECT_NE(refused("tipsify", bad).find("not below"), std::string::npos);
  bad = triangles_, bad.index_bytes = 5;
  EXPECT_NE(refused("tipsify", bad).find("1, 2 or 4"), std::string::npos);
  Order made(count());
  EXPECT_EQ(foredraw_order(nullptr, "tipsify", &triangles_, &positions_, made.data(), nullptr), FOREDRAW_NULL_POINTER);
  EXPECT_EQ(foredraw_order(context_.get(), nullptr, &triangles_, &positions_, made.data(), nullptr),
            FOREDRAW_NULL_POINTER);
  EXPECT_EQ(foredraw_order(context_.get(), "tipsify", nullptr, &positions_, made.data(), nullptr),
            FOREDRAW_NULL_POINTER);
  EXPECT_EQ(foredraw_order(context_.get(), "tipsify", &triangles_, nullptr, made.data(), nullptr),
            FOREDRAW_NULL_POINTER);
  EXPECT_EQ(foredraw_order(context_.get(), "tipsify", &triangles_, &positions_, nullptr, nullptr),
            FOREDRAW_NULL_POINTER);
}

TEST_F(OneDraw, IsEndedInItsOwnContextAlone) {
  const Context other(foredraw_context_new(nullptr));
  std::atomic<bool> is_done = false;
  std::thread canceller([&] {
    while (!is_done) foredraw_cancel(other.get());
  });
  EXPECT_FALSE(std::ranges::is_sorted(order("lookahead, occlusion-order(quality=fast)")));  // and it was done
  is_done = true;
  canceller.join();
}

TEST_F(OneDraw, IsOrderedByEightThreadsAtOnceOnOneContext) {
  const Order expected = order("lookahead, occlusion-order(quality=fast)");
  std::atomic<int> good = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i) {
    threads.emplace_back([&] { good += order("lookahead, occlusion-order(quality=fast)") == expected ? 1 : 0; });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(good, 8);
}

}  // namespace
}  // namespace foredraw::testing::one_draw_test

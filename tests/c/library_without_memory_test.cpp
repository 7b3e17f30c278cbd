// Wherever memory runs out in the library for C, the status says so; nothing leaks, and no exception comes out.

#include "bumpy_sheet.h"
#include "without_memory.h"

namespace foredraw::testing::library_without_memory_test {
namespace {

/// With a draw in memory.
class DrawsWithoutMemory : public WithoutMemory {
 protected:
  DrawsWithoutMemory() {
    indices_.assign(sheet_.indices.begin(), sheet_.indices.end());
    for (const auto& vertex : sheet_.vertices) {
      positions_.insert(positions_.end(), vertex.position, vertex.position + 3);
    }
    draw_.size = sizeof draw_;
    draw_.vertex_count = static_cast<std::uint32_t>(sheet_.vertices.size());
    draw_.triangle_count = indices_.size() / 3;
    draw_.indices = indices_.data();
    draw_.positions = positions_.data();
  }

  const BumpySheet sheet_{6};
  std::vector<std::uint32_t> indices_;
  std::vector<float> positions_;
  foredraw_draw draw_{};
};

TEST_F(DrawsWithoutMemory, ScenesAreNotMade) {
  expect_survives([&] {
    foredraw_scene* scene = nullptr;
    foredraw_text text{};
    const int status = foredraw_make_scene(context_, &draw_, 1, &scene, &text);
    EXPECT_EQ(scene != nullptr, status == FOREDRAW_DONE);
    foredraw_scene_free(scene);
    foredraw_text_free(&text);
    return status;
  });
}

TEST_F(DrawsWithoutMemory, OrdersSayThatItRanOut) {
  const foredraw_triangles triangles = sheet_.triangles();
  const foredraw_positions positions = sheet_.positions();
  std::vector<std::uint32_t> order(triangles.index_count / 3);
  expect_survives([&] { return foredraw_order(context_, "lookahead", &triangles, &positions, order.data(), nullptr); });
}

/// With what comes of a scene of one draw.
class RunsWithoutMemory : public DrawsWithoutMemory {
 protected:
  RunsWithoutMemory() { foredraw_make_scene(context_, &draw_, 1, &scene_, nullptr); }
  ~RunsWithoutMemory() override { foredraw_scene_free(scene_); }

  void expect_optimize_survives(const char* pipeline, long most = 500) {
    const auto call = [&] {
      foredraw_scene* result = nullptr;
      foredraw_text report{};
      const int status = foredraw_optimize(context_, scene_, pipeline, &result, &report);
      EXPECT_TRUE(status != FOREDRAW_DONE || report.data != nullptr);
      foredraw_scene_free(result);
      foredraw_text_free(&report);
      return status;
    };
    expect_survives(call, most);
  }

  foredraw_scene* scene_ = nullptr;
};

TEST_F(RunsWithoutMemory, ReportsOfALineOfStages) { expect_optimize_survives("weld, lookahead, vertex-fetch"); }
TEST_F(RunsWithoutMemory, ReportsOfALineWithValues) {
  expect_optimize_survives("weld, lookahead(cache-size=16, quality=fast), vertex-fetch");
}
/// Values of more than 15 characters need memory wherever they are copied.
TEST_F(RunsWithoutMemory, ReportsOfALineWithLongValues) {
  expect_optimize_survives("weld, quadric-collapse, levels(ratios=\"0.75, 0.5, 0.25, 0.125\"), tipsify", 20'000);
}
TEST_F(RunsWithoutMemory, ReportsOfAPreset) { expect_optimize_survives("@cache-only"); }
TEST_F(RunsWithoutMemory, ReportsOfAFile) {
  expect_optimize_survives("pipeline = 1\nstages = [\"weld\", { use = \"tipsify\", cache-size = 16 }]\n");
}

TEST_F(RunsWithoutMemory, ReportsOfMistakes) {
  for (const char* wrong : {"lookahed", "lookahead(cache-size=x)", "pipeline = 1\nstages = [7", "weld(((", "@none"}) {
    expect_survives([&] {
      foredraw_text report{};
      const int status = foredraw_optimize(context_, scene_, wrong, nullptr, &report);
      foredraw_text_free(&report);
      return status == FOREDRAW_MISTAKE ? FOREDRAW_DONE : status;
    });
  }
}

TEST_F(RunsWithoutMemory, Figures) {
  expect_survives([&] {
    foredraw_text report{};
    const int status = foredraw_measure(context_, scene_, "vertex-cache", &report);
    foredraw_text_free(&report);
    return status;
  });
}

TEST_F(RunsWithoutMemory, Comparisons) {
  const char* pipelines[] = {"weld", "weld, tipsify"};
  expect_survives([&] {
    foredraw_text report{};
    const int status = foredraw_compare(context_, &scene_, 1, pipelines, 2, 1, &report);
    foredraw_text_free(&report);
    return status;
  });
}

}  // namespace
}  // namespace foredraw::testing::library_without_memory_test

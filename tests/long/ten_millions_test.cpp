// A mesh of ten million triangles: right, in bounded memory. The square of them would take days.

#include "golden/corpus_run.h"
#include "support/meshes.h"
#include "support/program.h"

#include "plugins/processors/quadric_collapse/quadric_collapse.h"

#include <foredraw/collapses/replay.h>
#include <foredraw/platform/memory.h>

#include <gtest/gtest.h>

#include <cstdio>

namespace foredraw::ten_millions_test {
namespace {

/// A torus whose triangles come in random order, each with vertices of its own.
testing::TestMesh torn_torus(std::uint32_t slices, std::uint32_t sides) {
  const testing::TestMesh whole = testing::shuffled(testing::torus(slices, sides), 1);
  testing::TestMesh torn;
  for (const std::uint32_t corner : whole.indices) {
    torn.indices.push_back(static_cast<std::uint32_t>(torn.positions.size()));
    torn.positions.push_back(whole.positions[corner]);
  }
  return torn;
}

TEST(TenMillions, are_ordered_for_the_vertex_cache_in_bounded_memory) {
  constexpr std::uint64_t gibibyte = std::uint64_t{1} << 30;
  ASSERT_TRUE(testing::is_sanitized || limit_memory(8 * gibibyte));
  const Scene scene = testing::scene_of(torn_torus(2500, 2000));
  ASSERT_EQ(scene.draws[0].levels[0].stream().triangle_count(), 10'000'000u);

  const Result result = testing::run_pipeline("weld, tipsify, vertex-fetch", scene, 2, "vertex-cache");

  // The runner checks each stage's answer and its certificate: nothing failed means that the same triangles are drawn.
  EXPECT_FALSE(result.failed) << to_text(result.report);
  ASSERT_EQ(result.report.stages.size(), 3u);
  const double before = result.report.before.metrics.find("vertex-cache", "acmr")->value();
  const double after = result.report.after.metrics.find("vertex-cache", "acmr")->value();
  EXPECT_EQ(before, 3);
  EXPECT_LT(after, 0.7) << "a half is the least";
  EXPECT_EQ(result.scene.draws[0].levels[0].vertices->count, 2501u * 2001) << "all are welded but for the seams";
  EXPECT_EQ(result.scene.draws[0].levels[0].stream().triangle_count(), 10'000'000u);
  EXPECT_LT(peak_memory(), 8 * gibibyte);
  std::printf("acmr %.4f, then %.4f; %.1f GiB at most\n", before, after,
              static_cast<double>(peak_memory()) / static_cast<double>(gibibyte));
}

TEST(TenMillions, come_down_to_ten_thousand_in_bounded_memory) {
  constexpr std::uint64_t gibibyte = std::uint64_t{1} << 30;
  ASSERT_TRUE(testing::is_sanitized || limit_memory(8 * gibibyte));
  const testing::TestMesh torus = testing::torus(2500, 2000);
  const Executor executor(2);
  const CollapseSequence sequence =
      quadric_collapse(torus.positions, torus.indices, {.least = 10'000, .executor = &executor});
  const Replay run = replay(sequence, torus.positions, torus.indices);
  EXPECT_EQ(run.mistake, "");
  EXPECT_EQ(run.triangles.front(), 10'000'000u);
  EXPECT_LE(run.triangles.back(), 10'000u);
  EXPECT_LT(peak_memory(), 8 * gibibyte);
  std::printf("%.1f GiB at most\n", static_cast<double>(peak_memory()) / gibibyte);
}

}  // namespace
}  // namespace foredraw::ten_millions_test

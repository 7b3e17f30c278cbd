// Displaced meshes of ten million triangles and maps of 16384 x 16384 texels: memory grows as they do. A stage whose
// time is the square of that takes days.

#include "charted_torus.h"

#include "golden/corpus_run.h"

#include <foredraw/platform/memory.h>

#include <gtest/gtest.h>

#include <cstdio>
#include <ctime>

namespace foredraw::displaced_growth_test {
namespace {

using testing::ChartedTorus;
using testing::png_map;
using testing::seam_length;
using testing::torus_of;
using testing::torus_of_small_charts;

struct Taken {
  double bytes = 0;    ///< at most at a time, beside the scene
  double seconds = 0;  ///< of one thread
  std::size_t triangles = 0;
};

Taken taken(const std::string& stages, const Scene& scene) {
  Registry registry;
  add_built_in_plugins(registry);
  Diagnostics diagnostics;
  const auto plan = foredraw::plan(*parse_line(stages, diagnostics), registry, scene, diagnostics);
  if (!plan) throw std::runtime_error(to_text(diagnostics));
  const Executor executor(1);
  Analyses analyses(image_decoder({}));
  const MemoryWatch memory;
  const std::clock_t begin = std::clock();
  const Result result = optimize(*plan, scene, {executor, analyses});
  Taken taken{static_cast<double>(memory.growth().value_or(0)),
              static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC,
              result.scene.draws[0].full().stream().triangle_count()};
  EXPECT_FALSE(result.failed) << to_text(result.report);
  // Where a triangle has hardly a texel, levels are measured, and none is worth its triangles.
  const bool may_keep = stages.starts_with("tessellation-levels");
  EXPECT_TRUE(may_keep || result.report.stages.back().skipped.empty()) << to_text(result.report);
  return taken;
}

constexpr const char* all_stages[] = {"tessellate(parts=1, most=20000000)",
                                      "displacement-seams",
                                      "displacement-seams(table=true)",
                                      "vertex-pack",
                                      "tessellation-levels",
                                      "displacement(factor=0.01)"};

/// Of what may be taken: 150 bytes for each triangle, and 6 for each texel.
double part_of_bound(const Taken& of, double triangles, double texels) {
  return of.bytes / (150 * triangles + 6 * texels);
}

void tell(const std::string& stages, const ChartedTorus& torus, const Taken& of, double triangles, std::uint32_t size) {
  const double texels = static_cast<double>(size) * size;
  std::printf("%-36s %4.1f M triangles in %4u charts, %5u texels wide: %6.1f MB, %.2f of the bound; %6.2f s\n",
              stages.c_str(), triangles / 1e6, torus.columns * torus.rows, size, of.bytes / 1e6,
              part_of_bound(of, triangles, texels), of.seconds);
  std::fflush(stdout);
}

TEST(DisplacedGrowth, TakesAtMost150BytesATriangle) {
  constexpr std::uint32_t size = 4096;
  const Image map = png_map(size);
  for (const std::string stages : all_stages) {
    for (const std::uint64_t millions : {1, 3, 10}) {
      const ChartedTorus torus = torus_of(millions * 1'000'000);
      const Scene scene = testing::scene_of(torus, map);
      const auto triangles = static_cast<double>(scene.draws[0].full().stream().triangle_count());
      const Taken of = taken(stages, scene);
      tell(stages, torus, of, triangles, size);
      EXPECT_LT(part_of_bound(of, triangles, static_cast<double>(size) * size), 1) << stages;
    }
  }
}

TEST(DisplacedGrowth, TakesAtMost6BytesATexel) {
  for (const std::uint32_t size : {4096u, 8192u, 16384u}) {
    const ChartedTorus torus = torus_of(20'000);
    const Scene scene = testing::scene_of(torus, png_map(size));
    const auto triangles = static_cast<double>(scene.draws[0].full().stream().triangle_count());
    for (const std::string stages : all_stages) {
      if (stages.starts_with("tessell")) continue;  // reads no more texels than there are points
      const Taken of = taken(stages, scene);
      tell(stages, torus, of, triangles, size);
      EXPECT_LT(part_of_bound(of, triangles, static_cast<double>(size) * size), 1) << stages;
    }
  }
}

/// What the equations along seams take grows with the seams.
TEST(DisplacedGrowth, TakesMemoryAsSeamsAreLong) {
  constexpr std::uint32_t size = 4096;
  const Image map = png_map(size);
  for (const std::uint64_t thousands : {300, 3'000}) {
    const ChartedTorus torus = torus_of_small_charts(thousands * 1'000);
    const Scene scene = testing::scene_of(torus, map);
    const auto triangles = static_cast<double>(scene.draws[0].full().stream().triangle_count());
    const Taken of = taken("displacement-seams", scene);
    tell("displacement-seams", torus, of, triangles, size);
    const double length = seam_length(torus, size);
    const double beside = of.bytes - 100 * triangles - 4.0 * size * size;
    std::printf("  %.0f texels of seams: %.0f bytes each beside triangles and map\n", length, beside / length);
    EXPECT_LT(beside / length, 2400);
  }
}

}  // namespace
}  // namespace foredraw::displaced_growth_test

// Displaced meshes of ten million triangles and maps of 16384 x 16384 texels: memory and time grow as they do.

#include "golden/corpus_run.h"
#include "support/displaced.h"
#include "support/program.h"

#include <foredraw/io/image/images.h>
#include <foredraw/platform/memory.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <cstdio>
#include <ctime>
#include <numbers>

namespace foredraw {
namespace {

/// A torus of squares in two triangles each, whose layout is cut into charts of so many squares along each edge.
struct ChartedTorus {
  std::uint32_t columns = 0, rows = 0;  ///< of charts
  std::uint32_t squares = 0;            ///< along an edge of a chart
};

/// About so many triangles, in six charts, as scans are laid out.
ChartedTorus torus_of(std::uint64_t triangles) {
  return {3, 2, static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(triangles) / 12)))};
}

/// The same in charts of 4,608 triangles: 1.4 per cent of its edges lie on seams.
ChartedTorus torus_of_small_charts(std::uint64_t triangles) {
  constexpr std::uint32_t squares = 48;
  const double charts = static_cast<double>(triangles) / (2.0 * squares * squares);
  const auto rows = static_cast<std::uint32_t>(std::lround(std::sqrt(charts / 1.25)));
  return {static_cast<std::uint32_t>(std::lround(charts / rows)), rows, squares};
}

constexpr float margin = 0.05f;  // around a chart, of its place in the map

/// Charts in a row of the map.
std::uint32_t charts_across(const ChartedTorus& torus) {
  return static_cast<std::uint32_t>(std::ceil(std::sqrt(torus.columns * torus.rows)));
}

/// Of all seams together, in texels.
double seam_length(const ChartedTorus& torus, std::uint32_t map) {
  return 2.0 * torus.columns * torus.rows * map * (1 - 2 * margin) / charts_across(torus);
}

/// Charts lie beside one another in the map, each somewhere else than its neighbours on the torus.
Scene scene_of(const ChartedTorus& torus, Image map) {
  const std::uint32_t charts = torus.columns * torus.rows, side = torus.squares + 1;
  const std::uint32_t across = charts_across(torus);
  constexpr float radius = 1, tube = 0.4f;
  testing::TestMesh mesh;
  std::vector<glm::vec3> normals;
  std::vector<glm::vec2> uvs;
  const auto angle = [&](std::uint32_t at, std::uint32_t whole) {
    return 2 * std::numbers::pi_v<float> * static_cast<float>(at % whole) / static_cast<float>(whole);
  };
  for (std::uint32_t chart = 0; chart < charts; ++chart) {
    const auto base = static_cast<std::uint32_t>(mesh.positions.size());
    const auto place = static_cast<std::uint32_t>(std::uint64_t{chart} * 7919 % charts);
    for (std::uint32_t j = 0; j < side; ++j) {
      for (std::uint32_t i = 0; i < side; ++i) {
        const float u = angle(chart % torus.columns * torus.squares + i, torus.columns * torus.squares);
        const float v = angle(chart / torus.columns * torus.squares + j, torus.rows * torus.squares);
        normals.emplace_back(std::cos(v) * std::cos(u), -std::sin(v), std::cos(v) * std::sin(u));
        mesh.positions.push_back(radius * glm::vec3(std::cos(u), 0, std::sin(u)) + tube * normals.back());
        const glm::vec2 inside(static_cast<float>(i) / static_cast<float>(torus.squares),
                               static_cast<float>(j) / static_cast<float>(torus.squares));
        uvs.push_back((glm::vec2(place % across, place / across) + margin + (1 - 2 * margin) * inside) /
                      static_cast<float>(across));
      }
    }
    for (std::uint32_t j = 0; j + 1 < side; ++j) {
      for (std::uint32_t i = 0; i + 1 < side; ++i) {
        const std::uint32_t a = base + j * side + i, b = a + 1, c = a + side, d = c + 1;
        mesh.indices.insert(mesh.indices.end(), {a, b, c, c, b, d});
      }
    }
  }
  Scene scene = testing::displaced_scene(mesh, uvs, std::move(map), 0.02f);
  VertexStreams vertices = *scene.draws[0].full().vertices;
  vertices.base.push_back(testing::float_stream("NORMAL", normals));
  scene.draws[0].full().vertices = std::make_shared<const VertexStreams>(std::move(vertices));
  return scene;
}

/// As a file has it: a PNG of 16 bits, with hills that repeat.
Image png_map(std::uint32_t size) {
  Texels texels{{size, size, 1, 16}, {}};
  texels.bytes.resize(2 * std::size_t{size} * size);
  for (std::uint32_t y = 0; y < size; ++y) {
    for (std::uint32_t x = 0; x < size; ++x) {
      const auto height = static_cast<std::uint16_t>(32768 + 8 * ((x ^ y) % 2048) - 4 * (y % 1024));
      std::memcpy(&texels.bytes[2 * (std::size_t{y} * size + x)], &height, 2);
    }
  }
  Image image{.name = "heights", .media_type = "image/png", .bytes = Shared(encode_png(texels))};
  image.facts = texels.facts;
  return image;
}

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

TEST(DisplacedGrowth, TakesAtMost150BytesATriangleAndTimeAsItHasTriangles) {
  constexpr std::uint32_t size = 4096;
  const Image map = png_map(size);
  for (const std::string stages : all_stages) {
    double before = 0;
    for (const std::uint64_t millions : {1, 3, 10}) {
      const ChartedTorus torus = torus_of(millions * 1'000'000);
      const Scene scene = scene_of(torus, map);
      const auto triangles = static_cast<double>(scene.draws[0].full().stream().triangle_count());
      const Taken of = taken(stages, scene);
      tell(stages, torus, of, triangles, size);
      EXPECT_LT(part_of_bound(of, triangles, static_cast<double>(size) * size), 1) << stages;
      EXPECT_TRUE(before == 0 || of.seconds / triangles < 2 * before) << stages;
      before = of.seconds / triangles;
    }
  }
}

TEST(DisplacedGrowth, TakesAtMost6BytesATexelAndTimeAsItHasTexels) {
  for (const std::uint32_t size : {4096u, 8192u, 16384u}) {
    const ChartedTorus torus = torus_of(20'000);
    const Scene scene = scene_of(torus, png_map(size));
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
TEST(DisplacedGrowth, TakesMemoryAndTimeAsSeamsAreLong) {
  constexpr std::uint32_t size = 4096;
  const Image map = png_map(size);
  for (const std::uint64_t thousands : {300, 3'000}) {
    const ChartedTorus torus = torus_of_small_charts(thousands * 1'000);
    const Scene scene = scene_of(torus, map);
    const auto triangles = static_cast<double>(scene.draws[0].full().stream().triangle_count());
    const Taken of = taken("displacement-seams", scene);
    tell("displacement-seams", torus, of, triangles, size);
    const double length = seam_length(torus, size);
    const double beside = of.bytes - 100 * triangles - 4.0 * size * size;
    std::printf("  %.0f texels of seams: %.0f bytes each beside triangles and map\n", length, beside / length);
    EXPECT_LT(beside / length, 2400);
    EXPECT_LT(of.seconds, 4e-6 * triangles + 30e-6 * length);
  }
}

}  // namespace
}  // namespace foredraw

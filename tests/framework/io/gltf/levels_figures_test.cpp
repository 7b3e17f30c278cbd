// Three levels in one vertex buffer: each as good as the level alone, in one vertex order, and no byte more.

#include "framework/io/gltf/edits.h"
#include "support/meshes.h"

#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/runner.h>
#include <foredraw/scene/levels.h>
#include <foredraw/technique/built_in_plugins.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>

namespace foredraw::levels_figures_test {
namespace {

using namespace testing;

/// Triangles between cells of a grid, each cell drawn as the first of its vertices: the vertices stay where they are.
Level by_cells(const Level& full, float cells) {
  const std::vector<glm::vec3> positions = decode_vec3(*full.vertices->find("POSITION"));
  glm::vec3 low(INFINITY), high(-INFINITY);
  for (const glm::vec3& p : positions) low = glm::min(low, p), high = glm::max(high, p);
  const float size = std::max({high.x - low.x, high.y - low.y, high.z - low.z}) / cells;
  std::map<std::array<int, 3>, std::uint32_t> first;
  std::vector<std::uint32_t> indices;
  for (std::size_t i = 0; i + 3 <= full.stream().indices.size(); i += 3) {
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t v = full.stream().indices.view()[i + c];
      const glm::vec3 at = (positions[v] - low) / size;
      corners[c] = first.try_emplace({int(at.x), int(at.y), int(at.z)}, v).first->second;
    }
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0]) {
      indices.insert(indices.end(), corners.begin(), corners.end());
    }
  }
  Level level = full;
  level.stream() = {.indices = Shared<std::uint32_t>(std::move(indices))};
  return level;
}

struct Ladder {
  const char* file;
  LevelsAs as;
};

class LevelsFigures : public ::testing::TestWithParam<Ladder> {
 protected:
  LevelsFigures() { add_built_in_plugins(registry_); }

  Result run(const Scene& scene, const std::string& measure) {
    Diagnostics diagnostics;
    auto pipeline = parse_line("tipsify, linear-clusters, occlusion-order, vertex-fetch", diagnostics);
    pipeline->measure = *parse_stages(measure, "measure", diagnostics);
    const auto plan = foredraw::plan(*pipeline, registry_, scene, diagnostics);
    if (!plan) throw std::runtime_error(to_text(diagnostics));
    const Executor executor(2);
    Analyses analyses;
    return optimize(*plan, scene, {executor, analyses});
  }

  static double figure(const Result& result, const char* name) {
    return result.report.after.metrics.find(name)->value();
  }

  Registry registry_;
};

TEST_P(LevelsFigures, EachLevelIsAsGoodAsAlone) {
  Diagnostics diagnostics;
  Scene made = *read_gltf(project_file(GetParam().file), diagnostics);
  for (Draw& draw : made.draws) {
    draw.levels.push_back(by_cells(draw.levels[0], 40));
    draw.levels.push_back(by_cells(draw.levels[0], 20));
  }
  const auto file = encode_gltf(made, "in.glb", diagnostics, {.levels = GetParam().as});
  ASSERT_TRUE(file) << to_text(diagnostics);
  const Bytes& before = file->front().bytes;
  const Scene scene = read(before);
  ASSERT_EQ(scene.draws.size(), made.draws.size()) << "one draw of three levels each";
  for (const Draw& draw : scene.draws) {
    ASSERT_EQ(draw.levels.size(), 3u);
    ASSERT_EQ(draw.levels[2].vertices, draw.full().vertices);
    ASSERT_GT(draw.levels[2].stream().triangle_count(), 50u);
  }

  for (int level = 0; level < 3; ++level) {
    const std::string of = level == 0 ? "" : ", level=" + std::to_string(level);
    const std::string caches = level == 0 ? "vertex-cache" : "vertex-cache(level=" + std::to_string(level) + ')';
    const Result all = run(scene, caches + ", overdraw-raster(count=40, size=128, poses=bind" + of + ")");
    const Result alone = run(at_level(scene, static_cast<std::size_t>(level)),
                             "vertex-cache, overdraw-raster(count=40, size=128, poses=bind)");
    ASSERT_FALSE(all.failed);
    for (const char* name : {"vertex-cache.acmr", "overdraw-raster.ratio"}) {
      EXPECT_NEAR(figure(all, name) / figure(alone, name), 1, 0.005) << name << " of level " << level;
    }
    if (level > 0) continue;
    const Bytes after = write(all.scene);
    EXPECT_LE(after.size(), before.size());
    const Scene again = read(after);
    for (const Draw& draw : again.draws) {
      ASSERT_EQ(draw.levels.size(), 3u);
      EXPECT_EQ(draw.levels[1].vertices, draw.full().vertices) << "one vertex order for all";
      EXPECT_EQ(draw.levels[2].vertices, draw.full().vertices);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Files, LevelsFigures,
    ::testing::Values(Ladder{"benchmarks/corpus/static/spot.glb", LevelsAs::lod_nodes},
                      Ladder{"benchmarks/corpus/static/spot.glb", LevelsAs::extension},
                      Ladder{"benchmarks/corpus/animated/cesium_man_notex.glb", LevelsAs::lod_nodes},
                      Ladder{"benchmarks/corpus/animated/cesium_man_notex.glb", LevelsAs::extension}),
    [](const auto& info) {
      const std::string as = info.param.as == LevelsAs::lod_nodes ? "_as_lod_nodes" : "_as_extension";
      return std::filesystem::path(info.param.file).stem().string() + as;
    });

}  // namespace
}  // namespace foredraw::levels_figures_test

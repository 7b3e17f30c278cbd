// Runs a pipeline made in code on a scene made in code, with a registry of two plugins.

#include <foredraw/analysis/vertex_cache.h>
#include <foredraw/image/found_traits.h>
#include <foredraw/pipeline/plan.h>
#include <foredraw/pipeline/runner.h>
#include <foredraw/scene/triangle_draw.h>
#include <plugins/orderers/tipsify/tipsify.h>
#include <plugins/orderers/vertex_fetch/vertex_fetch.h>

#include <cstdio>

using namespace foredraw;

namespace {

/// A sheet of `size` x `size` squares, its triangles in a bad order.
Draw sheet(std::uint32_t size) {
  std::vector<glm::vec3> positions;
  for (std::uint32_t y = 0; y <= size; ++y) {
    for (std::uint32_t x = 0; x <= size; ++x) positions.emplace_back(x, y, 0);
  }
  std::vector<std::uint32_t> indices;
  const std::uint32_t squares = size * size;
  for (std::uint32_t i = 0; i < squares; ++i) {
    const std::uint32_t square = i * 7919 % squares;
    const std::uint32_t a = square / size * (size + 1) + square % size;
    const std::uint32_t b = a + size + 1;
    indices.insert(indices.end(), {a, a + 1, b, b, a + 1, b + 1});
  }
  return triangle_draw("sheet", positions, std::move(indices));
}

double acmr(const Draw& draw) {
  const Level& level = draw.levels[0];
  const CacheCount count = count_fifo(level.orders[0].indices.view(), level.vertices->count, 16);
  return static_cast<double>(count.misses) / static_cast<double>(count.triangles);
}

}  // namespace

int main() {
  Registry registry;
  registry.add(tipsify_plugin());
  registry.add(vertex_fetch_plugin());

  Pipeline pipeline;
  pipeline.stages = {{.use = "tipsify", .settings = {{"cache-size", std::int64_t{16}}}}, {.use = "vertex-fetch"}};

  Scene scene;
  scene.draws = {sheet(60)};
  scene.meshes = {{.name = "sheet", .draws = {0}}};
  scene.nodes = {{.name = "sheet", .mesh = 0}};
  find_traits(scene);

  Diagnostics diagnostics;  // a plan that exists can be run; where there is none, these say why
  const auto planned = plan(pipeline, registry, scene, diagnostics);
  if (!planned) {
    std::fprintf(stderr, "%s\n", to_text(diagnostics).c_str());
    return 1;
  }
  const Executor executor;
  Analyses analyses;
  const Result result = optimize(*planned, scene, {executor, analyses});

  const double before = acmr(scene.draws[0]);
  const double after = acmr(result.scene.draws[0]);
  const std::uint32_t first_vertex = result.scene.draws[0].levels[0].orders[0].indices.view()[0];
  std::printf("%s\nmisses per triangle: %.3f, then %.3f\n", to_text(result.report).c_str(), before, after);

  // Mistakes are told, not thrown.
  pipeline.stages[0].settings = {{"cach-size", std::int64_t{16}}};
  const bool refused = !plan(pipeline, registry, scene, diagnostics);
  std::printf("%s\n", to_text(diagnostics).c_str());
  return !result.failed && after < 0.75 && after < before && first_vertex == 0 && refused ? 0 : 1;
}

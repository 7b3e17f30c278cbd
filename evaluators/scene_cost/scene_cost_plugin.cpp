#include "scene_cost.h"

#include <foredraw/technique/plugin.h>

namespace foredraw {

namespace {

class SceneCostEvaluator final : public Evaluator {
 public:
  explicit SceneCostEvaluator(const SceneCostOptions& options) : options_(options) {}

  void evaluate(const Scene& scene, Run& run) const override {
    const SceneCost cost = scene_cost(scene, options_, run.executor);
    const auto count = [&](const char* metric, std::uint64_t number) {
      run.count(metric, static_cast<double>(number));
    };
    count("draws", cost.draws);
    count("draws-if-instanced", cost.draws_if_instanced);
    count("instances", cost.instances);
    count("indices", cost.indices);
    run.count("shaded", cost.shaded);
    if (cost.triangles > 0) run.measure("acmr", cost.triangles_shaded, static_cast<double>(cost.triangles));
    count("bytes", cost.vertex_bytes + cost.index_bytes + cost.instance_bytes);
    count("of-vertices.bytes", cost.vertex_bytes);
    count("of-indices.bytes", cost.index_bytes);
    count("of-instances.bytes", cost.instance_bytes);
  }

 private:
  SceneCostOptions options_;
};

}  // namespace

Plugin scene_cost_plugin() {
  OptionTable<SceneCostOptions> table;
  table.row(&SceneCostOptions::cache_size, "cache-size",
            "Size of the FIFO vertex cache that shaded and acmr are counted with", {3, 65535, "entries"});

  Plugin plugin;
  plugin.kind = Kind::evaluator;
  plugin.card = {
      .name = "scene-cost",
      .summary = "Counts what drawing the whole scene costs: draw calls, indices, shaded vertices, bytes",
      .reference = "own; the quantities of Persson 2012 (merge-instancing)",
      .metrics =
          {
              {"draws", "draw calls", "Draw calls in an engine that batches nothing by itself"},
              {"draws-if-instanced", "draw calls", "Draw calls if equal primitives of the same material are instanced"},
              {"instances", "placed primitives",
               "Primitives, each counted as often as it is placed, however few draw calls draw it", false},
              {"indices", "indices", "Indices that all draw calls read"},
              {"shaded", "vertices", "Vertices shaded by all draw calls"},
              {"acmr", "misses per triangle", "Vertices shaded per triangle of the frame"},
              {"bytes", "bytes",
               "Bytes of the vertices, indices and placements that the draw calls read, each counted once"},
          },
  };
  bind_options(plugin, std::move(table),
               [](const SceneCostOptions& options) { return std::make_unique<SceneCostEvaluator>(options); });
  return plugin;
}

}  // namespace foredraw

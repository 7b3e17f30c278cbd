#include "gpu_instances.h"

#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw {

namespace {

class GpuInstances final : public Processor {
 public:
  explicit GpuInstances(const GpuInstancesOptions& options) : options_(options) {}

  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    const InstancedNodes made = gpu_instances(scene, draws, options_);
    for (const LeftPlaced& left : made.left) {
      run.note_at({scene.meshes[left.mesh].draws.front()}, "not-instanced",
                  fmt::format("{} of its nodes stay as they are: {}", left.nodes, left.why));
    }
    if (made.meshes.empty()) {
      run.keep(fmt::format("no mesh is placed by {} nodes or more that one could stand for", options_.least));
      return {};
    }
    std::vector<DrawId> changed;
    double saved = 0, instances = 0;
    for (const InstancedMesh& mesh : made.meshes) {
      const std::vector<DrawId>& drawn = scene.meshes[mesh.mesh].draws;
      changed.insert(changed.end(), drawn.begin(), drawn.end());
      saved += (mesh.instances - 1.0) * static_cast<double>(drawn.size());
      instances += mesh.instances;
    }
    run.count_at({}, "draws-saved", saved);
    run.count_at({}, "nodes", static_cast<double>(made.meshes.size()));
    run.count_at({}, "instances", instances);
    std::ranges::sort(changed);
    return changed;
  }

 private:
  GpuInstancesOptions options_;
};

}  // namespace

Plugin gpu_instances_plugin() {
  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {
      .name = "gpu-instances",
      .summary = "Nodes that place the same mesh become one that draws it many times (EXT_mesh_gpu_instancing)",
      .reference = "common practice; Khronos, EXT_mesh_gpu_instancing",
      .pays_if = "a mesh is placed by many nodes that nothing moves",
      .lossless = true,
      .metrics = {{"draws-saved", "draws", "Draw calls fewer, of an engine that batches nothing by itself", false},
                  {"nodes", "nodes", "Nodes that draw a mesh many times", false},
                  {"instances", "instances", "Nodes that they stand for", false}},
  };
  OptionTable<GpuInstancesOptions> table;
  table.row(&GpuInstancesOptions::least, "least", "Instances of a mesh that are worth a node of their own",
            {2, 65535, "instances"});
  bind_options(plugin, table,
               [](const GpuInstancesOptions& options) { return std::make_unique<GpuInstances>(options); });
  return plugin;
}

}  // namespace foredraw

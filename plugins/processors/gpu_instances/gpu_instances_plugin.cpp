#include "gpu_instances.h"

#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw {

namespace {

class GpuInstancesProcessor final : public Processor {
 public:
  explicit GpuInstancesProcessor(const GpuInstancesOptions& options) : options_(options) {}

  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    const InstancedNodes made = gpu_instances(scene, draws, options_);
    for (const LeftPlaced& left : made.left) {
      run.note_at({scene.meshes[left.mesh].draws.front()}, "not-instanced",
                  fmt::format("{} of its nodes stay as they are: {}", left.nodes, left.why));
    }
    if (made.meshes.empty()) {
      run.keep(fmt::format("no mesh is placed by at least {} nodes that can become instances (option least)",
                           options_.least));
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
      .summary =
          "Replaces the nodes that place a mesh by one instanced node (EXT_mesh_gpu_instancing), to save draw calls",
      .reference = "common practice; Khronos, EXT_mesh_gpu_instancing",
      .pays_if = "many nodes place the same mesh, and no animation moves them",
      .lossless = true,
      .measured_by = {"scene-cost"},
      .metrics = {{"draws-saved", "draws", "Draw calls saved, in an engine that batches nothing by itself", false},
                  {"nodes", "nodes", "Instanced nodes made", false},
                  {"instances", "instances", "Nodes that they replace", false}},
  };
  OptionTable<GpuInstancesOptions> table;
  table.row(&GpuInstancesOptions::least, "least",
            "Fewest nodes of a mesh that are replaced; a mesh placed by fewer stays as it is", {2, 65535, "instances"});
  bind_options(plugin, table,
               [](const GpuInstancesOptions& options) { return std::make_unique<GpuInstancesProcessor>(options); });
  return plugin;
}

}  // namespace foredraw

#include <foredraw/collapses/collapse_product.h>
#include <foredraw/collapses/collapse_sequences.h>
#include <foredraw/collapses/replay.h>
#include <foredraw/measuring/collapse_processor.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace foredraw {

namespace {

/// The draws of each mesh that may be changed. They lie in one space, so that what touches stays together.
std::vector<std::vector<DrawId>> meshes_of(const Scene& scene, const std::vector<DrawId>& draws) {
  std::vector<std::vector<DrawId>> meshes;
  std::vector<bool> is_free(scene.draws.size(), false);
  for (const DrawId id : draws) is_free[id] = scene.draws[id].levels.size() == 1;
  for (const Mesh& mesh : scene.meshes) {
    std::vector<DrawId> chosen;
    for (const DrawId id : mesh.draws) {
      if (is_free[id]) chosen.push_back(id);
      is_free[id] = false;
    }
    if (!chosen.empty()) meshes.push_back(std::move(chosen));
  }
  return meshes;
}

class CollapseProcessor final : public Processor {
 public:
  CollapseProcessor(Simplifier simplifier, CollapseProcessorOptions options)
      : simplifier_(std::move(simplifier)), options_(options) {}

  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    for (const DrawId id : draws) {
      if (scene.draws[id].levels.size() == 1) continue;
      run.note_at({.draw = id}, "has-levels", "not simplified: it already has levels of detail");
    }
    const std::vector<std::vector<DrawId>> meshes = meshes_of(scene, draws);
    std::vector<std::shared_ptr<const CollapseSequence>> made(meshes.size());
    std::vector<std::uint8_t> is_small(meshes.size(), 0);
    run.executor.for_each(meshes.size(), [&](std::size_t i) {
      const auto mesh = joined_mesh(scene, meshes[i], run.analyses);
      is_small[i] = mesh && mesh->indices.size() / 3 < least_triangles;
      if (mesh && !is_small[i] && !run.cancelled()) made[i] = sequence_of({*mesh, scene, meshes[i]}, run);
    });
    CollapseSequences sequences;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      if (!made[i] || made[i]->collapses.empty()) continue;
      run.count_at({.draw = meshes[i].front()}, "collapses", static_cast<double>(made[i]->collapses.size()));
      sequences.meshes.push_back({meshes[i], std::move(made[i])});
    }
    if (const auto small = std::ranges::count(is_small, 1); small > 0) {
      run.note("few-triangles",
               small == 1 ? fmt::format("a mesh has fewer than {} triangles and stays as it is", least_triangles)
                          : fmt::format("{} meshes have fewer than {} triangles and stay as they are", small,
                                        least_triangles));
    }
    if (sequences.meshes.empty()) {
      run.keep("no mesh has an edge that can be collapsed");
    } else {
      scene.products.set(std::move(sequences));
    }
    return draws;  // those without a sequence are as coarse as they get
  }

 private:
  static constexpr std::size_t least_triangles = 64;  // taking some of so few changes the shape, and gains hardly any

  std::shared_ptr<const CollapseSequence> sequence_of(const MeshInScene& of, Run& run) const {
    const JoinedMesh& mesh = of.mesh;
    const double least = std::ceil(options_.until * static_cast<double>(mesh.indices.size() / 3));
    auto sequence = std::make_shared<const CollapseSequence>(simplifier_(of, static_cast<std::size_t>(least), run));
    const Replay run_of_it = replay(*sequence, mesh.positions, mesh.indices, mesh.part);
    if (!run_of_it.mistake.empty()) {
      throw std::runtime_error(fmt::format("{}: {}", of.scene.draws[of.draws.front()].name, run_of_it.mistake));
    }
    return sequence;
  }

  Simplifier simplifier_;
  CollapseProcessorOptions options_;
};

}  // namespace

std::unique_ptr<Processor> collapse_processor(Simplifier simplifier, CollapseProcessorOptions options) {
  return std::make_unique<CollapseProcessor>(std::move(simplifier), options);
}

Plugin simplifier_plugin(std::string name, std::string summary, std::string reference) {
  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {
      .name = std::move(name),
      .summary = std::move(summary),
      .reference = std::move(reference),
      .acts_on = {traits::triangles},
      .wants = {traits::welded},
      .provides = {traits::progressive},
      .lossless = true,
      .metrics = {{"collapses", "edges", "Edges that can be collapsed, one after the other", false, false, true}},
  };
  plugin.products = {collapse_product()};
  return plugin;
}

}  // namespace foredraw

#include "geomorph_product.h"
#include "geomorphs.h"

#include <foredraw/collapses/collapse_product.h>
#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace foredraw {

namespace {

struct GeomorphsOptions {
  bool keep_sequences = false;
};

class GeomorphsProcessor final : public Processor {
 public:
  explicit GeomorphsProcessor(GeomorphsOptions options) : options_(options) {}

  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    const std::vector<DrawsCollapse> sequences = sequences_of(scene, draws);
    if (sequences.empty()) {
      run.keep(
          "no mesh has the sequence of collapses that its levels were cut from; put `levels` with keep-sequences = "
          "true right before this stage");
      return {};
    }
    std::vector<DrawsCollapse> meshes = sequences;
    std::erase_if(meshes, [&](const DrawsCollapse& mesh) {
      return std::ranges::any_of(mesh.draws, [&](DrawId id) { return scene.draws[id].levels.size() < 2; });
    });
    std::vector<std::vector<DrawGeomorph>> made(meshes.size());
    run.executor.for_each(meshes.size(), [&](std::size_t i) { made[i] = geomorphs_of(meshes[i], scene, run); });
    Geomorphs all;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      if (made[i].empty()) {
        run.note_at(
            {.draw = meshes[i].draws.front()}, "other-levels",
            "no geomorphs: its levels no longer match its sequence of collapses; put this stage right after `levels`");
      }
      std::ranges::move(made[i], std::back_inserter(all.draws));
    }
    if (meshes.empty()) run.note("nothing-to-gain", "no mesh has levels");
    std::ranges::sort(all.draws, {}, &DrawGeomorph::draw);
    std::vector<DrawId> changed;
    for (const DrawGeomorph& draw : all.draws) changed.push_back(draw.draw);
    if (!changed.empty()) scene.products.set(std::move(all));
    if (!options_.keep_sequences) remove_sequences(scene, sequences);
    return changed;
  }

 private:
  /// Of each draw of the mesh; none where a level is not found along the sequence.
  static std::vector<DrawGeomorph> geomorphs_of(const DrawsCollapse& of, const Scene& scene, Run& run) {
    const auto mesh = joined_mesh(scene, of.draws, run.analyses);
    if (!mesh || run.cancelled()) return {};
    const Replay all = replay(*of.sequence, mesh->positions, mesh->indices, mesh->part);
    if (!all.mistake.empty()) throw std::runtime_error(all.mistake);
    std::vector<DrawGeomorph> made;
    for (const DrawId id : of.draws) made.push_back({id, {}});
    std::optional<CutLevel> fine;
    for (std::size_t level = 0; level < scene.draws[of.draws.front()].levels.size(); ++level) {
      std::vector<const Level*> levels;
      for (const DrawId id : of.draws) levels.push_back(&scene.draws[id].level(level));
      auto cut = level == 0 ? full_detail(*of.sequence, *mesh) : find_cut(*of.sequence, all, *mesh, levels);
      if (!cut) return {};
      for (std::size_t d = 0; d < made.size() && level > 0; ++d) {
        made[d].ancestors.emplace_back(ancestors(fine->draws[d], cut->draws[d], cut->after, *mesh));
      }
      fine = std::move(cut);
    }
    return made;
  }

  /// With all its vertices, those that no triangle uses too.
  static std::optional<CutLevel> full_detail(const CollapseSequence& sequence, const JoinedMesh& mesh) {
    CutLevel level{collapsed(sequence, 0, mesh), {}};
    level.draws = cut_of_same_vertices(level.after, mesh);
    return level;
  }

  GeomorphsOptions options_;
};

}  // namespace

Plugin geomorphs_plugin() {
  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {
      .name = "geomorphs",
      .summary = "Stores what each vertex of a level becomes in the next coarser one, so that levels change smoothly",
      .reference = "Hoppe 1996, section 4.1",
      .acts_on = {traits::triangles},
      .needs = {traits::progressive},
      .lossless = true,
  };
  plugin.products = {geomorph_product(), collapse_product()};
  OptionTable<GeomorphsOptions> table;
  table.row(&GeomorphsOptions::keep_sequences, "keep-sequences",
            "Keep the sequences of collapses for a later stage, and in the file; otherwise they are used up");
  bind_options(plugin, table,
               [](const GeomorphsOptions& options) { return std::make_unique<GeomorphsProcessor>(options); });
  return plugin;
}

}  // namespace foredraw

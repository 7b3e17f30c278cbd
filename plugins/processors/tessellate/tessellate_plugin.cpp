#include "tessellate.h"

#include "divided_draw.h"

#include <foredraw/displaced/displacement_stamp.h>
#include <foredraw/measuring/level_processor.h>
#include <foredraw/scene/own_material.h>
#include <foredraw/viewing/self_crossings.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace foredraw {

namespace {

using CoarserLevels = std::map<DrawId, std::vector<DividedLevel>>;

/// Hands out levels that are there. Draws of a subject that have fewer show their coarsest one again.
class TessellateMaker final : public LevelMaker {
 public:
  explicit TessellateMaker(CoarserLevels levels) : levels_(std::move(levels)) {}

  SubjectLevels levels(const SubjectView& view, Run&) const override {
    std::size_t most = 0;
    for (const DrawId id : view.draws) most = std::max(most, levels_.at(id).size());
    SubjectLevels made(view.draws.size());
    for (std::size_t d = 0; d < view.draws.size(); ++d) {
      const std::vector<DividedLevel>& own = levels_.at(view.draws[d]);
      const Level& full = view.scene.draws[view.draws[d]].full();
      for (const DividedLevel& level : own) made[d].push_back({level.vertices, Shared(level.indices)});
      made[d].resize(most, own.empty() ? MadeLevel{full.vertices, full.stream().indices} : made[d].back());
    }
    return made;
  }

 private:
  CoarserLevels levels_;
};

class TessellateProcessor final : public Processor {
 public:
  explicit TessellateProcessor(DivisionOptions options) : options_(options) {}

  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    std::vector<std::variant<DividedDraw, std::string>> made(draws.size());
    run.executor.for_each(draws.size(), [&](std::size_t i) {
      if (!run.cancelled()) made[i] = divided(scene, draws[i], run.analyses);
    });
    for (std::size_t i = 0; i < draws.size(); ++i) {
      if (!std::holds_alternative<DividedDraw>(made[i])) continue;
      const std::string note = note_of(self_crossings(scene, draws[i], run.analyses, run.executor, run.cancel));
      if (!note.empty()) run.note_at({.draw = draws[i]}, "passes-through-itself", note);
    }
    if (run.cancelled()) return {};
    std::vector<DrawId> changed;
    CoarserLevels coarser;
    for (std::size_t i = 0; i < draws.size(); ++i) {
      const About about{.draw = draws[i]};
      if (const std::string* why_not = std::get_if<std::string>(&made[i])) {
        run.note_at(about, "not-tessellated", "not tessellated: " + *why_not);
        continue;
      }
      DividedDraw& of = std::get<DividedDraw>(made[i]);
      run.count_at(about, "triangles", static_cast<double>(of.levels.front().indices.size() / 3));
      put(of, scene.draws[draws[i]]);
      of.levels.erase(of.levels.begin());
      coarser[draws[i]] = std::move(of.levels);
      changed.push_back(draws[i]);
    }
    if (changed.empty()) run.keep("no draw can be tessellated");
    take_displacement(scene, changed);
    take_heights(scene, changed);
    put_levels(std::move(coarser), scene, changed, run);
    return changed;
  }

 private:
  std::variant<DividedDraw, std::string> divided(const Scene& scene, DrawId id, Analyses& analyses) const {
    const Draw& draw = scene.draws[id];
    if (draw.levels.size() > 1) return "it has several levels of detail";
    if (draw.full().orders.size() > 1) return "it has several orders";
    return divided_draw(scene, id, options_, analyses);
  }

  static void put(DividedDraw& divided, Draw& draw) {
    const auto of_file = draw.full().stream().triangle_origin.view();
    if (!of_file.empty()) {
      for (std::uint32_t& source : divided.source) source = of_file[source];
    }
    DividedLevel& finest = divided.levels.front();
    draw.full().vertices = std::move(finest.vertices);
    draw.full().stream() = {.indices = Shared(std::move(finest.indices)),
                            .triangle_origin = Shared(std::move(divided.source))};
    draw.traits.remove(traits::displaced);
    draw.traits.remove(traits::quantized);
  }

  void put_levels(CoarserLevels coarser, Scene& scene, const std::vector<DrawId>& changed, Run& run) const {
    if (options_.levels == 1 || changed.empty()) return;
    if (std::ranges::all_of(coarser, [](const auto& of) { return of.second.empty(); })) {
      run.note("no-coarser-level", "no coarser level: every edge is in one part already");
      return;
    }
    level_processor(std::make_unique<const TessellateMaker>(std::move(coarser)))->process(scene, changed, run);
    run.findings.nothing_to_gain.reset();  // draws that no node shows get no levels, and are divided all the same
  }

  /// What is moved for good is not moved again.
  static void take_displacement(Scene& scene, const std::vector<DrawId>& draws) {
    std::map<MaterialId, std::vector<DrawId>> by_material;
    for (const DrawId draw : draws) {
      const Material* material = scene.material_of(scene.draws[draw]);
      if (material != nullptr && material->displacement) by_material[*scene.draws[draw].material].push_back(draw);
    }
    for (const auto& [material, users] : by_material) {
      Material& own = scene.materials[own_material(scene, material, users)];
      change_look(own, stamp_of(*own.displacement));
      own.displacement.reset();
    }
  }

  static void take_heights(Scene& scene, const std::vector<DrawId>& draws) {
    const BakedHeights* all = scene.products.find<BakedHeights>();
    if (all == nullptr) return;
    BakedHeights left = *all;
    std::erase_if(left.draws, [&](const DrawHeights& of) { return std::ranges::binary_search(draws, of.draw); });
    if (left.draws.empty()) {
      scene.products.erase(BakedHeights::product);
    } else {
      scene.products.set(std::move(left));
    }
  }

  DivisionOptions options_;
};

}  // namespace

Plugin tessellate_plugin() {
  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {
      .name = "tessellate",
      .summary = "Divides displaced triangles as a GPU's tessellator does, and moves the points by the map of heights",
      .reference = "Tatarchuk, Barczak, Purnomo 2008",
      .acts_on = {traits::triangles, traits::displaced},
      .breaks = {traits::displaced, traits::quantized, traits::welded, traits::clustered, traits::cache_ordered,
                 traits::overdraw_ordered, traits::fetch_ordered, traits::progressive},
      .pays_if = "an engine or tool shows the surface and has no tessellation",
      .metrics = {{"triangles", "triangles", "Triangles that came out at full detail", false}},
  };
  std::ranges::copy(level_metrics(), std::back_inserter(plugin.card.metrics));
  OptionTable<DivisionOptions> table;
  table.row(&DivisionOptions::parts, "parts",
            "Parts of every edge, a tessellator's level; without it and `texels`, the levels that "
            "`tessellation-levels` stored",
            {1, 64});
  table.row(&DivisionOptions::texels, "texels",
            "Fewest texels of the map along a part of an edge; 1.5 where nothing else says how finely to divide",
            {0.5, 65536, "texels"});
  table.choice(&DivisionOptions::spacing, "spacing", "How the points on an edge are spaced, in the words of shaders",
               {{"equal", TessellationSpacing::equal},
                {"fractional-odd", TessellationSpacing::fractional_odd},
                {"fractional-even", TessellationSpacing::fractional_even}});
  table.row(&DivisionOptions::most, "most", "Most triangles that a draw may have afterwards",
            {1, 100'000'000, "triangles"});
  table.row(&DivisionOptions::levels, "levels",
            "Levels of detail that come out: each has half as many parts to an edge as the one before, and an error "
            "that is proved",
            {1, 7});
  bind_options(plugin, table,
               [](const DivisionOptions& options) { return std::make_unique<TessellateProcessor>(options); });
  return plugin;
}

}  // namespace foredraw

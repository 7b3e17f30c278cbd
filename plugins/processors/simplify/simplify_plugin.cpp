#include "simplify.h"

#include <foredraw/collapses/collapse_limits.h>
#include <foredraw/collapses/collapse_product.h>
#include <foredraw/collapses/collapse_sequences.h>
#include <foredraw/collapses/draw_distances.h>
#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw {

namespace {

struct Options : SimplifyOptions {
  std::optional<double> pixels;
  double distance = 10;
};

std::string text_of(Simplified::End end) {
  switch (end) {
    case Simplified::End::goal: return "the number of triangles is reached";
    case Simplified::End::error: return "more would exceed the error";
    case Simplified::End::sequence: break;
  }
  return "no other edge can be collapsed";
}

/// A mesh made coarser.
struct Made {
  std::vector<CutDraw> draws;
  Simplified simplified;
  std::uint32_t before = 0;  ///< triangles
  double largest = 0;        ///< proved distance, either way
};

class SimplifyProcessor final : public Processor {
 public:
  explicit SimplifyProcessor(SimplifyOptions options) : options_(options) {}

  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    std::vector<DrawsCollapse> meshes = sequences_of(scene, draws);
    std::erase_if(meshes, [&](const DrawsCollapse& mesh) {
      const bool has_levels =
          std::ranges::any_of(mesh.draws, [&](DrawId id) { return scene.draws[id].levels.size() > 1; });
      if (has_levels) {
        run.note_at({.draw = mesh.draws.front()}, "has-levels", "not simplified: it already has levels of detail");
      }
      return has_levels;
    });
    std::vector<Made> made(meshes.size());
    run.executor.for_each(meshes.size(), [&](std::size_t i) { made[i] = made_of(meshes[i], scene, run); });
    std::vector<DrawId> changed;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      tell(meshes[i], made[i], run);
      for (std::size_t d = 0; d < made[i].draws.size(); ++d) {
        put(made[i].draws[d], scene.draws[meshes[i].draws[d]]);
        changed.push_back(meshes[i].draws[d]);
      }
    }
    if (meshes.empty()) {
      run.keep("no mesh has a sequence of collapses, such as `quadric-collapse` finds before this stage");
      return changed;
    }
    if (changed.empty()) run.note("nothing-to-gain", "no edge may be collapsed within what is asked for");
    remove_sequences(scene, meshes);
    std::ranges::sort(changed);
    return changed;
  }

 private:
  Made made_of(const DrawsCollapse& mesh, const Scene& scene, Run& run) const {
    Made made;
    const auto joined = joined_mesh(scene, mesh.draws, run.analyses);
    if (!joined || run.cancelled()) return made;
    const Replay all = replay(*mesh.sequence, joined->positions, joined->indices, joined->part);
    if (!all.mistake.empty()) throw std::runtime_error(all.mistake);
    made.before = all.triangles.front();
    made.simplified = simplify(*joined, *mesh.sequence, all, options_, run.executor, run.cancel);
    if (made.simplified.collapses == 0) return made;
    const Collapsed after = collapsed(*mesh.sequence, made.simplified.collapses, *joined);
    made.draws = cut(*mesh.sequence, made.simplified.collapses, after, *joined);
    const auto farthest = DrawDistances(*joined).farthest(after, {.cancel = run.cancel}, run.executor);
    if (farthest) made.largest = farthest->bound;
    return made;
  }

  static void tell(const DrawsCollapse& mesh, const Made& made, Run& run) {
    const About about{.draw = mesh.draws.front()};
    run.count_at(about, "triangles", made.simplified.triangles);
    run.measure_at(about, "largest", made.largest, 1);
    run.note_at(about, "simplified",
                fmt::format("{} of {} triangles are left, at most {:.3g} units from full detail: {}",
                            made.simplified.triangles, made.before, made.largest, text_of(made.simplified.end)));
  }

  static void put(const CutDraw& cut, Draw& draw) {
    Level& level = draw.levels.front();
    level.vertices = cut.vertices;
    level.orders = {IndexStream{.indices = cut.indices}};
    level.vertex_destination = {};
  }

  SimplifyOptions options_;
};

}  // namespace

Plugin simplify_plugin() {
  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {
      .name = "simplify",
      .summary = "Leaves fewer triangles: as many as asked for, or as few as an error allows",
      .reference = "Hoppe 1996, section 3",
      .acts_on = {traits::triangles},
      .needs = {traits::progressive},
      .breaks = {traits::progressive, traits::clustered, traits::cache_ordered, traits::overdraw_ordered,
                 traits::fetch_ordered},
      .measured_by = {"surface-error", "attribute-error"},
      .metrics = {{"triangles", "triangles", "Triangles that are left"},
                  {"largest", "units", "Proved: no point of either surface is farther from the other", true, true}},
  };
  plugin.products = {collapse_product()};
  OptionTable<Options> table;
  table
      .row(&Options::ratio, "ratio", "Share of each mesh's triangles that is left; 0.5 where no other limit is given",
           {.least = 0, .most = 1})
      .row(&Options::triangles, "triangles", "Triangles of each mesh that are left", {.least = 0})
      .row(&Options::error, "error",
           "Largest distance between the surface before and after, in either direction; no triangle goes that would "
           "exceed it",
           {.least = 0, .unit = "units"})
      .row(&Options::pixels, "pixels",
           "The same in pixels of a picture 1080 pixels high with a field of view of 60 degrees, as seen from "
           "`distance` "
           "units away",
           {.least = 0})
      .row(&Options::distance, "distance", "How near a camera comes, for `pixels`", {.least = 0, .unit = "units"});
  bind_options(plugin, table, [](const Options& options) {
    SimplifyOptions limits = options;
    if (options.pixels) {
      const double error = distance_of_pixels(*options.pixels, options.distance);
      limits.error = std::min(error, options.error.value_or(error));
    }
    return std::make_unique<SimplifyProcessor>(limits);
  });
  return plugin;
}

}  // namespace foredraw

#include "cgal_collapse.h"

#include <foredraw/measuring/collapse_processor.h>

namespace foredraw {

namespace {

struct Options : CgalCollapseOptions {
  double until = CollapseProcessorOptions{}.until;
};

}  // namespace

Plugin cgal_collapse_plugin() {
  Plugin plugin = simplifier_plugin(
      "cgal-collapse", "Finds in which sequence edges collapse, by CGAL's edge collapse; `simplify` applies it",
      "Lindstrom, Turk 1998; Garland, Heckbert 1997");
  OptionTable<Options> table;
  table
      .choice<CgalCost>(
          &Options::cost, "cost",
          "What counts: lindstrom-turk (volumes and areas of the current triangles) or garland-heckbert "
          "(distances from the planes of all triangles that ever were)",
          {{"lindstrom-turk", CgalCost::lindstrom_turk}, {"garland-heckbert", CgalCost::garland_heckbert}})
      .row(&Options::until, "until", "Share of a mesh's triangles to stop at", {.least = 0, .most = 1})
      .row(&Options::keep_sides, "keep-sides", "Whether collapses that turn a triangle over are refused");
  bind_options(plugin, table, [](const Options& options) -> Technique {
    const auto find = [options](const MeshInScene& of, std::size_t least, Run& run) {
      CgalCollapseOptions own = options;
      own.least = least;
      own.cancel = run.cancel;
      return cgal_collapse(of.mesh.positions, of.mesh.indices, own);
    };
    return collapse_processor(find, {.until = options.until});
  });
  return plugin;
}

}  // namespace foredraw

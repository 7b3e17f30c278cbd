#include "openmesh_decimate.h"

#include <foredraw/measuring/collapse_processor.h>

namespace foredraw {

namespace {

struct Options : OpenmeshDecimateOptions {
  double until = CollapseProcessorOptions{}.until;
};

}  // namespace

Plugin openmesh_decimate_plugin() {
  Plugin plugin = simplifier_plugin(
      "openmesh-decimate", "Finds in which sequence edges collapse, by OpenMesh's decimater; `simplify` applies it",
      "Garland, Heckbert 1997; Botsch et al. 2002");
  OptionTable<Options> table;
  table.row(&Options::until, "until", "Share of a mesh's triangles to stop at", {.least = 0, .most = 1})
      .row(&Options::normal_flipping, "normal-flipping", "How far a triangle may turn in one collapse; 180 allows all",
           {.least = 0, .most = 180, .unit = "degrees"})
      .row(&Options::normal_deviation, "normal-deviation",
           "Width of the cone of all normals that one triangle may stand for",
           {.least = 0, .most = 360, .unit = "degrees"})
      .row(&Options::aspect_ratio, "aspect-ratio", "Longest side over height that triangles may come to",
           {.least = 1, .most = 1e6})
      .row(&Options::roundness, "roundness", "Least roundness of triangles; 1 is equilateral", {.least = 0, .most = 1})
      .row(&Options::edge_length, "edge-length", "Longest edge that may collapse, as a share of the box's diagonal",
           {.least = 0, .most = 1})
      .row(&Options::hausdorff, "hausdorff",
           "Farthest that original vertices may come to lie from the surface, as a share of the box's diagonal",
           {.least = 0, .most = 1});
  bind_options(plugin, table, [](const Options& options) -> Technique {
    const auto find = [options](const MeshInScene& of, std::size_t least, Run& run) {
      OpenmeshDecimateOptions own = options;
      own.least = least;
      own.cancel = run.cancel;
      return openmesh_decimate(of.mesh.positions, of.mesh.indices, own);
    };
    return collapse_processor(find, {.until = options.until});
  });
  return plugin;
}

}  // namespace foredraw

#include "quadric_collapse.h"

#include <foredraw/measuring/collapse_processor.h>
#include <foredraw/measuring/mesh_in_poses.h>

namespace foredraw {

namespace {

struct Options : QuadricCollapseOptions, AttributeWeights {
  double until = CollapseProcessorOptions{}.until;
};

constexpr std::size_t most_poses = 4;  // more make hardly a difference
constexpr double beside_poses = 0.25;  // what joints and targets do is seen there; this is for other poses

CollapseSequence collapses(Options options, const MeshInScene& of, std::size_t least, Run& run) {
  options.least = least;
  options.cancel = run.cancel;
  options.executor = &run.executor;
  const JoinedMesh& mesh = of.mesh;
  const PosedVertices posed = options.poses > 0 ? mesh_in_poses(of, run.poses, most_poses) : PosedVertices{};
  if (posed.poses() > 0) options.joints *= beside_poses, options.targets *= beside_poses;
  return quadric_collapse(mesh.positions, mesh.indices, options, attribute_rows(mesh, options), mesh.part, posed);
}

}  // namespace

Plugin quadric_collapse_plugin() {
  Plugin plugin = simplifier_plugin(
      "quadric-collapse", "Finds the sequence in which edges collapse at the least error; `simplify` applies it",
      "Hoppe 1996, section 3; costs after Garland, Heckbert 1997, Lindstrom, Turk 1998 and Hoppe 1999");
  OptionTable<Options> table;
  table
      .choice<CollapsePlacement>(&Options::placement, "placement",
                                 "Where the joined vertex lies: optimal (where the error is least) or endpoint (at one "
                                 "of the two vertices, so that all levels can share one vertex buffer)",
                                 {{"optimal", CollapsePlacement::optimal}, {"endpoint", CollapsePlacement::endpoint}})
      .row(&Options::until, "until", "Share of a mesh's triangles to stop at", {.least = 0, .most = 1})
      .row(&Options::memory, "memory", "Weight of the original triangles' planes beside those of the current ones",
           {.least = 0, .most = 1})
      .row(&Options::deviation, "deviation",
           "Weight of how far the surface moves at its farthest point, beside its mean distance",
           {.least = 0, .most = 1})
      .row(&Options::border, "border", "Weight of open borders", {.least = 0, .most = 1000})
      .row(&Options::seam, "seam", "Weight of seams, where normals, texture coordinates or materials break",
           {.least = 0, .most = 1000})
      .row(&Options::parts, "parts",
           "Size of whole pieces of a mesh that may be removed: their diagonal as a share of the mesh's; 0: none is "
           "removed",
           {.least = 0, .most = 1})
      .row(&Options::poses, "poses",
           "Weight of the surface in poses beside the one at rest, where an animation bends it: in four of the "
           "pipeline's [poses]; 0: at rest alone",
           {.least = 0, .most = 1000})
      .row(&Options::solves, "solve",
           "Whether normals, texture coordinates and colours are solved for beside the place; false: they are blended "
           "along "
           "the edge. With endpoint placement they are those of one of the two vertices")
      .row(&Options::normals, "normals",
           "Weight of normals: a difference of 1 counts as this share of the mesh's diagonal",
           {.least = 0, .most = 1000})
      .row(&Options::texcoords, "texcoords", "Weight of how far textures slide on the surface, beside distances",
           {.least = 0, .most = 1000})
      .row(&Options::colors, "colors", "Weight of colours: a difference of 1 counts as this share of the diagonal",
           {.least = 0, .most = 1000})
      .row(&Options::joints, "joints",
           "Weight of joint weights: a difference of 1 counts as this share of the diagonal",
           {.least = 0, .most = 1000})
      .row(&Options::targets, "targets", "Weight of how far morph targets move vertices, beside distances",
           {.least = 0, .most = 1000});
  bind_options(plugin, table, [](const Options& options) -> Technique {
    const auto find = [options](const MeshInScene& of, std::size_t least, Run& run) {
      return collapses(options, of, least, run);
    };
    return collapse_processor(find, {.until = options.until});
  });
  return plugin;
}

}  // namespace foredraw

#include "energy_collapse.h"

#include <foredraw/measuring/collapse_processor.h>

#include <algorithm>

namespace foredraw {

namespace {

struct Options : EnergyCollapseOptions {
  double until = CollapseProcessorOptions{}.until;
};

/// Normals, texture coordinates and colours: what a picture shows of a vertex besides its place.
std::size_t components_of(const VertexStream& stream) {
  const auto is = [&](std::string_view word) { return stream.semantic.starts_with(word); };
  return is("NORMAL") || is("TEXCOORD_") || is("COLOR_") ? stream.format.components : 0;
}

/// [vertex * width] of the joined mesh. Streams that have less are filled up with zeros.
std::vector<float> scalars_of(const JoinedMesh& mesh, std::size_t& width) {
  width = 0;
  for (const auto& streams : mesh.streams) {
    std::size_t here = 0;
    for (const VertexStream& stream : streams->base) here += components_of(stream);
    width = std::max(width, here);
  }
  std::vector<float> values(mesh.positions.size() * width, 0.0f);
  for (std::size_t s = 0; s < mesh.streams.size(); ++s) {
    std::size_t column = 0;
    for (const VertexStream& stream : mesh.streams[s]->base) {
      for (std::size_t k = 0; k < components_of(stream); ++k, ++column) {
        for (std::size_t v = 0; v < mesh.streams[s]->count; ++v) {
          values[(mesh.first_vertex[s] + v) * width + column] = decode_component(stream, v, k);
        }
      }
    }
  }
  return values;
}

class EnergyCollapse final : public Simplifier {
 public:
  explicit EnergyCollapse(const EnergyCollapseOptions& options) : options_(options) {}

  CollapseSequence collapses(const MeshInScene& of, std::size_t least, Run& run) const override {
    EnergyCollapseOptions options = options_;
    options.least = least;
    options.seed = run.seed;
    options.cancel = run.cancel;
    std::size_t width = 0;
    const std::vector<float> values = scalars_of(of.mesh, width);
    return energy_collapse(of.mesh.positions, of.mesh.indices, {values, width}, options);
  }

 private:
  EnergyCollapseOptions options_;
};

}  // namespace

Plugin energy_collapse_plugin() {
  Plugin plugin = simplifier_plugin(
      "energy-collapse",
      "Finds in which sequence edges collapse so that the least energy is added; slow; `simplify` applies it",
      "Hoppe 1996, section 4; Hoppe et al. 1993");
  OptionTable<Options> table;
  table.row(&Options::until, "until", "Share of a mesh's triangles to stop at", {.least = 0, .most = 1})
      .row(&Options::distance, "distance", "Weight of the squared distances of original points, in box diagonals",
           {.least = 0, .most = 1e6})
      .row(&Options::spring, "spring", "Weight of the squared lengths of edges, by factors from 0.01 to 0.00000001",
           {.least = 0, .most = 1e6})
      .row(&Options::scalar, "scalar",
           "Weight of the squared differences of normals, texture coordinates and colours at those points",
           {.least = 0, .most = 1e6})
      .row(&Options::discontinuity, "discontinuity", "Weight of the squared distances of points of borders and seams",
           {.least = 0, .most = 1e6})
      .row(&Options::samples, "samples", "Points on the original surface", {1, 100, "points per triangle"})
      .row(&Options::rounds, "rounds", "How often points are projected and the place is solved for", {0, 20});
  bind_options(plugin, table, [](const Options& options) -> Technique {
    return collapse_processor(std::make_unique<const EnergyCollapse>(options), {.until = options.until});
  });
  return plugin;
}

}  // namespace foredraw

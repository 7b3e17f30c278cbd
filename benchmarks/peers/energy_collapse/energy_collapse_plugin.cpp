#include "energy_collapse.h"

#include <foredraw/measuring/collapse_processor.h>
#include <foredraw/scene/scaled_texcoords.h>

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

/// Of the first draw with those vertices.
const Material* material_of(const MeshInScene& of, std::size_t stream) {
  for (std::size_t d = 0; d < of.draws.size(); ++d) {
    if (of.mesh.stream_of[d] == stream) return of.scene.material_of(of.scene.draws[of.draws[d]]);
  }
  return nullptr;
}

/// By how much numbers of the first two components count: those of texture coordinates in widths of the texture.
glm::dvec2 weight_of(const VertexStream& stream, const Material* material) {
  constexpr std::string_view word = "TEXCOORD_";
  if (!stream.semantic.starts_with(word)) return glm::dvec2(1);
  const std::string number = stream.semantic.substr(word.size());
  for (std::uint32_t set = 0; set < 32; ++set) {
    if (std::to_string(set) == number) return texture_widths(material, set);
  }
  return glm::dvec2(1);
}

/// [vertex * width] of the joined mesh. Streams that have less are filled up with zeros.
std::vector<float> scalars_of(const MeshInScene& of, std::size_t& width) {
  const JoinedMesh& mesh = of.mesh;
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
      const glm::dvec2 weight = weight_of(stream, material_of(of, s));
      for (std::size_t k = 0; k < components_of(stream); ++k, ++column) {
        const auto scale = static_cast<float>(k < 2 ? weight[static_cast<int>(k)] : 1);
        for (std::size_t v = 0; v < mesh.streams[s]->count; ++v) {
          values[(mesh.first_vertex[s] + v) * width + column] = decode_component(stream, v, k) * scale;
        }
      }
    }
  }
  return values;
}

CollapseSequence collapses(Options options, const MeshInScene& of, std::size_t least, Run& run) {
  options.least = least;
  options.seed = run.seed;
  options.cancel = run.cancel;
  std::size_t width = 0;
  const std::vector<float> values = scalars_of(of, width);
  return energy_collapse(of.mesh.positions, of.mesh.indices, {values, width}, options);
}

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
    const auto find = [options](const MeshInScene& of, std::size_t least, Run& run) {
      return collapses(options, of, least, run);
    };
    return collapse_processor(find, {.until = options.until});
  });
  return plugin;
}

}  // namespace foredraw

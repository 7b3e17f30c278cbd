#include "energy_collapse.h"

#include <foredraw/c/with_collapses.h>

using namespace foredraw;

int foredraw_energy_collapse(foredraw_collapses* sequence, const foredraw_triangles* triangles,
                             const foredraw_positions* positions, const foredraw_weighted_attribute* attributes,
                             uint32_t attribute_count, uint32_t least, uint32_t samples, uint64_t seed) {
  EnergyCollapseOptions options;
  options.least = least;
  options.seed = seed;
  constexpr std::uint32_t most_samples = 100;
  if (samples > most_samples) return FOREDRAW_OPTION_RANGE;
  if (samples > 0) options.samples = samples;
  const auto find = [&](const c::CheckedTriangles& mesh, const c::WeightedRows& rows) {
    const auto places = c::elements_at<glm::vec3>(positions->first, positions->stride, mesh.vertex_count());
    return energy_collapse(places, mesh.indices(), {rows.values, rows.width}, options);
  };
  // The sequence says where points move to, in every case.
  if (sequence != nullptr && sequence->places == nullptr) return FOREDRAW_NULL_POINTER;
  return c::with_collapses(sequence, triangles, positions, attributes, attribute_count, find);
}

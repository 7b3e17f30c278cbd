#include "quadric_collapse.h"

#include <foredraw/c/with_collapses.h>
#include <foredraw/collapses/alike_vertices.h>

using namespace foredraw;

int foredraw_quadric_collapse(foredraw_collapses* sequence, const foredraw_triangles* triangles,
                              const foredraw_positions* positions, const foredraw_weighted_attribute* attributes,
                              uint32_t attribute_count, uint32_t least) {
  const auto find = [&](const c::CheckedTriangles& mesh, c::WeightedRows rows) {
    QuadricCollapseOptions options;
    options.placement = sequence->places == nullptr ? CollapsePlacement::endpoint : CollapsePlacement::optimal;
    options.least = least;
    options.solves = sequence->solves == 1;
    const auto places = c::elements_at<glm::vec3>(positions->first, positions->stride, mesh.vertex_count());
    AttributeRows counted{rows.width, std::move(rows.values), rows.blended};
    for (const auto& [first, length] : rows.directions) counted.directions.push_back({first, length});
    counted.alike = alike_vertices(counted, places);
    return quadric_collapse(places, mesh.indices(), options, std::move(counted));
  };
  return c::with_collapses(sequence, triangles, positions, attributes, attribute_count, find);
}

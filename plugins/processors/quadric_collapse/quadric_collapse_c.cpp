#include "quadric_collapse.h"

#include <foredraw/c/checked_input.h>

#include <algorithm>
#include <cmath>

using namespace foredraw;

namespace {

constexpr std::uint32_t most_attributes = 16, most_components = 16;

int status_of(const foredraw_weighted_attribute& attribute) {
  if (attribute.first == nullptr) return FOREDRAW_NULL_POINTER;
  const bool is_good = attribute.components >= 1 && attribute.components <= most_components && attribute.weight >= 0 &&
                       std::isfinite(attribute.weight);
  return is_good ? FOREDRAW_DONE : FOREDRAW_OPTION_RANGE;
}

AttributeRows rows_of(std::span<const foredraw_weighted_attribute> attributes, std::size_t count) {
  AttributeRows rows;
  for (const foredraw_weighted_attribute& attribute : attributes) rows.width += attribute.components;
  rows.values.resize(count * rows.width);
  std::size_t first = 0;
  for (const foredraw_weighted_attribute& attribute : attributes) {
    const std::size_t bytes = attribute.components * sizeof(float);
    const std::size_t stride = attribute.stride == 0 ? bytes : attribute.stride;
    for (std::size_t v = 0; v < count; ++v) {
      float* row = rows.of(static_cast<std::uint32_t>(v)) + first;
      std::memcpy(row, static_cast<const std::byte*>(attribute.first) + v * stride, bytes);
      for (std::uint32_t i = 0; i < attribute.components; ++i) {
        row[i] = static_cast<float>(static_cast<double>(row[i]) * attribute.weight);
        if (!std::isfinite(row[i])) row[i] = 0;
      }
    }
    first += attribute.components;
  }
  return rows;
}

}  // namespace

int foredraw_quadric_collapse(foredraw_collapses* sequence, const foredraw_triangles* triangles,
                              const foredraw_positions* positions, const foredraw_weighted_attribute* attributes,
                              uint32_t attribute_count, uint32_t least) {
  return c::with_triangles(triangles, sequence, [&](const c::CheckedTriangles& checked) -> int {
    if (sequence == nullptr || (attributes == nullptr && attribute_count > 0)) return FOREDRAW_NULL_POINTER;
    const std::size_t vertices = checked.vertex_count();
    if (const int status = c::positions_status(positions, vertices)) return status;
    const bool has_room = sequence->collapses != nullptr && sequence->pairs != nullptr;
    if (sequence->first_pair == nullptr || (!has_room && vertices > 0)) return FOREDRAW_NULL_POINTER;
    if (attribute_count > most_attributes) return FOREDRAW_OPTION_RANGE;
    const std::span<const foredraw_weighted_attribute> weighted(attributes, attribute_count);
    if (vertices > 0) {
      for (const foredraw_weighted_attribute& attribute : weighted) {
        if (const int status = status_of(attribute)) return status;
      }
    }
    constexpr std::size_t most = std::size_t{1} << 31;
    if (checked.indices().size() > most || vertices > most) return FOREDRAW_TOO_LARGE;

    CollapseSequence found{.first_pair = {0}};
    if (vertices > 0) {
      QuadricCollapseOptions options;
      options.placement = sequence->places == nullptr ? CollapsePlacement::endpoint : CollapsePlacement::optimal;
      options.least = least;
      options.solves = false;  // callers blend
      found = quadric_collapse(c::elements_at<glm::vec3>(positions->first, positions->stride, vertices),
                               checked.indices(), options, rows_of(weighted, vertices));
    }
    // Each vertex is removed once at most, so that all of it has room.
    std::ranges::transform(found.collapses, sequence->collapses, [](const Collapse& one) -> foredraw_collapse {
      return {one.removed, one.kept, one.blend, one.error};
    });
    std::ranges::transform(found.pairs, sequence->pairs, [](const VertexPair& pair) -> foredraw_vertex_pair {
      return {pair.removed, pair.kept};
    });
    std::ranges::copy(found.first_pair, sequence->first_pair);
    if (found.first_pair.empty()) sequence->first_pair[0] = 0;
    if (sequence->places != nullptr) std::ranges::copy(found.places, sequence->places);
    sequence->count = static_cast<std::uint32_t>(found.collapses.size());
    return FOREDRAW_DONE;
  });
}

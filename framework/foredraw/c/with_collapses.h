#pragma once
// What functions for C that find sequences of collapses have in common: their input checked, and their answer put into
// the caller's arrays.

#include <foredraw/c/checked_input.h>
#include <foredraw/c/simplification.h>

#include <algorithm>
#include <cmath>

namespace foredraw::c {

inline int status_of(const foredraw_weighted_attribute& attribute) {
  constexpr std::uint32_t most_components = 16;
  if (attribute.first == nullptr) return FOREDRAW_NULL_POINTER;
  const bool is_good = attribute.components >= 1 && attribute.components <= most_components && attribute.weight >= 0 &&
                       std::isfinite(attribute.weight);
  return is_good ? FOREDRAW_DONE : FOREDRAW_OPTION_RANGE;
}

/// Numbers of each vertex, times their weights: [vertex * width + i]. Finite.
struct WeightedRows {
  std::size_t width = 0;
  std::vector<float> values;
};

inline WeightedRows rows_of(std::span<const foredraw_weighted_attribute> attributes, std::size_t count) {
  WeightedRows rows;
  for (const foredraw_weighted_attribute& attribute : attributes) rows.width += attribute.components;
  rows.values.resize(count * rows.width);
  std::size_t first = 0;
  for (const foredraw_weighted_attribute& attribute : attributes) {
    const std::size_t bytes = attribute.components * sizeof(float);
    const std::size_t stride = attribute.stride == 0 ? bytes : attribute.stride;
    for (std::size_t v = 0; v < count; ++v) {
      float* row = rows.values.data() + v * rows.width + first;
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

/// Each vertex is removed once at most, so that all of it has room.
template <class Sequence>
void put(const Sequence& found, foredraw_collapses& sequence) {
  std::ranges::transform(found.collapses, sequence.collapses, [](const auto& one) -> foredraw_collapse {
    return {one.removed, one.kept, one.blend, one.error};
  });
  std::ranges::transform(found.pairs, sequence.pairs, [](const auto& pair) -> foredraw_vertex_pair {
    return {pair.removed, pair.kept};
  });
  std::ranges::copy(found.first_pair, sequence.first_pair);
  if (found.first_pair.empty()) sequence.first_pair[0] = 0;
  if (sequence.places != nullptr) std::ranges::copy(found.places, sequence.places);
  sequence.count = static_cast<std::uint32_t>(found.collapses.size());
}

/// Puts the sequence that find(triangles, rows of attributes) answers with into the caller's, where the input is in
/// order.
template <class Find>
int with_collapses(foredraw_collapses* sequence, const foredraw_triangles* triangles,
                   const foredraw_positions* positions, const foredraw_weighted_attribute* attributes,
                   std::uint32_t attribute_count, Find find) noexcept {
  return with_triangles(triangles, sequence, [&](const CheckedTriangles& checked) -> int {
    if (sequence == nullptr || (attributes == nullptr && attribute_count > 0)) return FOREDRAW_NULL_POINTER;
    const std::size_t vertices = checked.vertex_count();
    if (const int status = positions_status(positions, vertices)) return status;
    const bool has_room = sequence->collapses != nullptr && sequence->pairs != nullptr;
    if (sequence->first_pair == nullptr || (!has_room && vertices > 0)) return FOREDRAW_NULL_POINTER;
    constexpr std::uint32_t most_attributes = 16;
    if (attribute_count > most_attributes) return FOREDRAW_OPTION_RANGE;
    const std::span<const foredraw_weighted_attribute> weighted(attributes, attribute_count);
    if (vertices > 0) {
      for (const foredraw_weighted_attribute& attribute : weighted) {
        if (const int status = status_of(attribute)) return status;
      }
    }
    constexpr std::size_t most = std::size_t{1} << 31;
    if (checked.indices().size() > most || vertices > most) return FOREDRAW_TOO_LARGE;
    if (vertices == 0) {
      sequence->first_pair[0] = 0;
      sequence->count = 0;
      return FOREDRAW_DONE;
    }
    put(find(checked, rows_of(weighted, vertices)), *sequence);
    return FOREDRAW_DONE;
  });
}

}  // namespace foredraw::c

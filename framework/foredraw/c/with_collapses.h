#pragma once
// What functions for C that find sequences of collapses have in common: their input checked, and their answer put into
// the caller's arrays.

#include <foredraw/c/checked_input.h>
#include <foredraw/c/simplification.h>

#include <algorithm>
#include <cmath>

namespace foredraw::c {

inline bool is_direction(const foredraw_weighted_attribute& attribute) {
  return (attribute.components & FOREDRAW_DIRECTION) != 0;
}

inline bool is_blended(const foredraw_weighted_attribute& attribute) {
  return (attribute.components & FOREDRAW_BLENDED) != 0;
}

/// Of a vertex.
inline std::uint32_t numbers_of(const foredraw_weighted_attribute& attribute) {
  return attribute.components & ~std::uint32_t{FOREDRAW_DIRECTION | FOREDRAW_BLENDED};
}

inline int status_of(const foredraw_weighted_attribute& attribute) {
  constexpr std::uint32_t most_components = 16;
  if (attribute.first == nullptr) return FOREDRAW_NULL_POINTER;
  const std::uint32_t numbers = numbers_of(attribute);
  const bool points = numbers == 3 || numbers == 4;
  const bool is_good = numbers >= 1 && numbers <= most_components && attribute.weight >= 0 &&
                       std::isfinite(attribute.weight) && (!is_direction(attribute) || points) &&
                       !(is_direction(attribute) && is_blended(attribute));
  return is_good ? FOREDRAW_DONE : FOREDRAW_OPTION_RANGE;
}

/// Of no vertices any attributes will do.
inline int attributes_status(const foredraw_weighted_attribute* attributes, std::uint32_t count, std::size_t vertices) {
  constexpr std::uint32_t most_attributes = 16;
  if (attributes == nullptr && count > 0) return FOREDRAW_NULL_POINTER;
  if (count > most_attributes) return FOREDRAW_OPTION_RANGE;
  if (vertices == 0) return FOREDRAW_DONE;
  for (const foredraw_weighted_attribute& attribute : std::span(attributes, count)) {
    if (const int status = status_of(attribute)) return status;
  }
  return FOREDRAW_DONE;
}

/// Numbers of each vertex, times their weights: [vertex * width + i]. Finite. Those that are always blended are last.
struct WeightedRows {
  struct Direction {
    std::size_t first;
    double length;
  };
  std::size_t width = 0;
  std::size_t blended = 0;  ///< how many of the last ones
  std::vector<float> values;
  std::vector<Direction> directions;
};

/// How many of an attribute's numbers count beside distances.
inline std::size_t counted(const foredraw_weighted_attribute& attribute) {
  return is_direction(attribute) ? 3 : numbers_of(attribute);
}

inline WeightedRows rows_of(std::span<const foredraw_weighted_attribute> attributes, std::size_t count) {
  WeightedRows rows;
  for (const foredraw_weighted_attribute& attribute : attributes) {
    rows.width += counted(attribute);
    if (is_blended(attribute)) rows.blended += counted(attribute);
  }
  rows.values.resize(count * rows.width);
  std::size_t next = 0, next_blended = rows.width - rows.blended;
  for (const foredraw_weighted_attribute& attribute : attributes) {
    const std::size_t numbers = counted(attribute);
    const std::size_t stride = attribute.stride == 0 ? numbers_of(attribute) * sizeof(float) : attribute.stride;
    const std::size_t first = is_blended(attribute) ? next_blended : next;
    (is_blended(attribute) ? next_blended : next) += numbers;
    if (is_direction(attribute)) rows.directions.push_back({first, attribute.weight});
    for (std::size_t v = 0; v < count; ++v) {
      float* row = rows.values.data() + v * rows.width + first;
      std::memcpy(row, static_cast<const std::byte*>(attribute.first) + v * stride, numbers * sizeof(float));
      for (std::size_t i = 0; i < numbers; ++i) {
        row[i] = static_cast<float>(static_cast<double>(row[i]) * attribute.weight);
        if (!std::isfinite(row[i])) row[i] = 0;
      }
    }
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
  sequence.solves = found.solves;
}

/// Puts the sequence that find(triangles, rows of attributes) answers with into the caller's, where the input is in
/// order.
template <class Find>
int with_collapses(foredraw_collapses* sequence, const foredraw_triangles* triangles,
                   const foredraw_positions* positions, const foredraw_weighted_attribute* attributes,
                   std::uint32_t attribute_count, Find find) noexcept {
  return with_triangles(triangles, sequence, [&](const CheckedTriangles& checked) -> int {
    if (sequence == nullptr) return FOREDRAW_NULL_POINTER;
    const std::size_t vertices = checked.vertex_count();
    if (const int status = positions_status(positions, vertices)) return status;
    const bool has_room = sequence->collapses != nullptr && sequence->pairs != nullptr;
    if (sequence->first_pair == nullptr || (!has_room && vertices > 0)) return FOREDRAW_NULL_POINTER;
    if (sequence->solves > 1) return FOREDRAW_OPTION_RANGE;
    if (const int status = attributes_status(attributes, attribute_count, vertices)) return status;
    constexpr std::size_t most = std::size_t{1} << 31;
    if (checked.indices().size() > most || vertices > most) return FOREDRAW_TOO_LARGE;
    if (vertices == 0) {
      sequence->first_pair[0] = 0;
      sequence->count = 0;
      return FOREDRAW_DONE;
    }
    put(find(checked, rows_of({attributes, attribute_count}, vertices)), *sequence);
    return FOREDRAW_DONE;
  });
}

}  // namespace foredraw::c

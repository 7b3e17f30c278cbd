#include "simplify.h"

#include <foredraw/base/this_thread.h>
#include <foredraw/c/with_collapses.h>
#include <foredraw/collapses/cut.h>
#include <foredraw/collapses/draw_distances.h>
#include <foredraw/collapses/level_vertices.h>

#include <algorithm>
#include <cmath>

using namespace foredraw;

namespace {

/// Of a caller's arrays; what it says is not trusted yet.
CollapseSequence sequence_of(const foredraw_collapses& given, std::size_t pairs) {
  CollapseSequence sequence;
  for (std::uint32_t i = 0; i < given.count; ++i) {
    const foredraw_collapse& one = given.collapses[i];
    sequence.collapses.push_back({one.removed, one.kept, one.blend, one.error});
  }
  for (std::size_t i = 0; i < pairs; ++i) sequence.pairs.push_back({given.pairs[i].removed, given.pairs[i].kept});
  sequence.first_pair.assign(given.first_pair, given.first_pair + given.count + 1);
  if (given.places != nullptr) sequence.places.assign(given.places, given.places + 3 * std::size_t{given.count});
  sequence.solves = given.solves == 1;
  return sequence;
}

/// How many pairs the sequence has; nothing where its numbers lead out of its arrays.
std::optional<std::size_t> pairs_of(const foredraw_collapses& given, std::size_t vertices) {
  const std::span<const std::uint32_t> first(given.first_pair, std::size_t{given.count} + 1);
  if (given.count > vertices || first.front() != 0 || !std::ranges::is_sorted(first) || first.back() > vertices) {
    return std::nullopt;
  }
  return first.back();
}

VertexStreams streams_of(std::span<const glm::vec3> positions) {
  const auto bytes = std::as_bytes(positions);
  VertexStreams streams;
  streams.count = static_cast<std::uint32_t>(positions.size());
  streams.base.push_back({"POSITION", {}, Shared(std::vector<std::byte>(bytes.begin(), bytes.end()))});
  return streams;
}

/// The triangles as one draw of a mesh, with no more than its positions.
JoinedMesh mesh_of(std::vector<glm::vec3> positions, std::span<const std::uint32_t> indices) {
  VertexStreams streams = streams_of(positions);
  JoinedMesh mesh;
  mesh.part.resize(positions.size());
  mesh.first_vertex = {0, streams.count};
  mesh.positions = std::move(positions);
  mesh.indices.assign(indices.begin(), indices.end());
  mesh.first_index = {0, static_cast<std::uint32_t>(indices.size())};
  mesh.streams = {std::make_shared<const VertexStreams>(std::move(streams))};
  mesh.stream_of = {0};
  return mesh;
}

/// The attribute as a stream of floats, whose name says how it follows collapses.
VertexStream stream_of(const foredraw_weighted_attribute& attribute, std::size_t vertices) {
  const std::size_t numbers = c::numbers_of(attribute), bytes = numbers * sizeof(float);
  const std::size_t stride = attribute.stride == 0 ? bytes : attribute.stride;
  std::vector<std::byte> values(vertices * bytes);
  for (std::size_t v = 0; v < vertices; ++v) {
    std::memcpy(values.data() + v * bytes, static_cast<const std::byte*>(attribute.first) + v * stride, bytes);
  }
  const char* name = c::is_blended(attribute) ? "POSITION" : c::is_direction(attribute) ? "NORMAL" : "_NUMBERS";
  return {name,
          Format{Component::float32, static_cast<std::uint8_t>(numbers), false, static_cast<std::uint16_t>(bytes)},
          Shared(std::move(values))};
}

/// What is always blended goes as a morph target does: alike for all vertices of a point.
std::shared_ptr<const VertexStreams> with_attributes(VertexStreams streams,
                                                     std::span<const foredraw_weighted_attribute> attributes) {
  for (const foredraw_weighted_attribute& attribute : attributes) {
    VertexStream stream = stream_of(attribute, streams.count);
    if (c::is_blended(attribute)) {
      streams.morph_targets.push_back({std::move(stream)});
    } else {
      streams.base.push_back(std::move(stream));
    }
  }
  return std::make_shared<const VertexStreams>(std::move(streams));
}

/// Each vertex of `to` gets its numbers, wherever it is in the level; where it is not, those of `before`.
void write_attributes(const LevelVertices& level, const VertexStreams& before,
                      std::span<const foredraw_weighted_attribute> attributes, float* to) {
  for (std::size_t v = 0; v < before.count; ++v) {
    const bool is_left = level.number[v] != no_vertex;
    const VertexStreams& from = is_left ? *level.vertices : before;
    std::size_t base = 1, target = 0;  // behind the positions
    for (const foredraw_weighted_attribute& attribute : attributes) {
      const VertexStream& stream = c::is_blended(attribute) ? from.morph_targets[target++].front() : from.base[base++];
      const std::size_t bytes = stream.format.bytes;
      std::memcpy(to, stream.bytes.view().data() + (is_left ? level.number[v] : v) * bytes, bytes);
      to += c::numbers_of(attribute);
    }
  }
}

/// Whether all of a sequence can be looked at.
int sequence_status(const foredraw_collapses* sequence, std::size_t vertices) {
  if (sequence == nullptr || sequence->first_pair == nullptr) return FOREDRAW_NULL_POINTER;
  if (!pairs_of(*sequence, vertices)) return FOREDRAW_NO_ORDER;
  const bool has_arrays = sequence->collapses != nullptr && sequence->pairs != nullptr;
  return sequence->count > 0 && !has_arrays ? FOREDRAW_NULL_POINTER : FOREDRAW_DONE;
}

}  // namespace

int foredraw_simplify(void* indices, float* places, foredraw_simplified* simplified,
                      const foredraw_triangles* triangles, const foredraw_positions* positions,
                      const foredraw_collapses* sequence, uint32_t triangle_count, double most_error) {
  return c::with_triangles(triangles, indices, [&](const c::CheckedTriangles& checked) -> int {
    if (simplified == nullptr || sequence == nullptr) return FOREDRAW_NULL_POINTER;
    const std::size_t vertices = checked.vertex_count();
    if (const int status = c::positions_status(positions, vertices)) return status;
    if (!(most_error >= 0)) return FOREDRAW_OPTION_RANGE;
    constexpr std::size_t most = std::size_t{1} << 31;
    if (checked.indices().size() > most || vertices > most) return FOREDRAW_TOO_LARGE;
    if (const int status = sequence_status(sequence, vertices)) return status;
    if (sequence->count > 0 && places == nullptr && sequence->places != nullptr) return FOREDRAW_NULL_POINTER;
    if (checked.triangle_count() == 0) {
      *simplified = {};
      if (places != nullptr) {
        std::ranges::copy(c::elements_at<glm::vec3>(positions == nullptr ? nullptr : positions->first,
                                                    positions == nullptr ? 0 : positions->stride, vertices),
                          reinterpret_cast<glm::vec3*>(places));
      }
      return FOREDRAW_DONE;
    }

    const JoinedMesh mesh =
        mesh_of(c::elements_at<glm::vec3>(positions->first, positions->stride, vertices), checked.indices());
    const CollapseSequence given = sequence_of(*sequence, *pairs_of(*sequence, vertices));
    const Replay run = replay(given, mesh.positions, mesh.indices, mesh.part);
    if (!run.mistake.empty()) return FOREDRAW_NO_ORDER;
    SimplifyOptions options{.triangles = triangle_count};
    if (std::isfinite(most_error)) options.error = most_error;
    const Executor executor = on_this_thread();
    const Simplified found = simplify(mesh, given, run, options, executor);
    const Collapsed after = collapsed(given, found.collapses, mesh);
    double error = 0;
    if (found.collapses > 0) {
      const auto farthest = DrawDistances(mesh).farthest(after, {}, executor);
      error = farthest ? farthest->bound : 0;
    }
    *simplified = {after.indices.size(), static_cast<std::uint32_t>(found.collapses), 0, error};
    c::write_indices(indices, triangles->index_bytes, after.indices);
    if (places != nullptr) std::memcpy(places, after.places.data(), after.places.size() * sizeof(glm::vec3));
    return FOREDRAW_DONE;
  });
}

int foredraw_level_attributes(float* values, const foredraw_triangles* triangles, const foredraw_positions* positions,
                              const foredraw_collapses* sequence, uint32_t collapses,
                              const foredraw_weighted_attribute* attributes, uint32_t attribute_count) {
  return c::with_triangles(triangles, values, [&](const c::CheckedTriangles& checked) -> int {
    const std::size_t vertices = checked.vertex_count();
    if (const int status = c::positions_status(positions, vertices)) return status;
    if (const int status = c::attributes_status(attributes, attribute_count, vertices)) return status;
    if (const int status = sequence_status(sequence, vertices)) return status;
    if (sequence->solves > 1) return FOREDRAW_OPTION_RANGE;
    constexpr std::size_t most = std::size_t{1} << 31;
    if (checked.indices().size() > most || vertices > most) return FOREDRAW_TOO_LARGE;
    if (collapses > sequence->count) return FOREDRAW_NO_ORDER;
    if (vertices == 0 || attribute_count == 0) return FOREDRAW_DONE;
    if (values == nullptr) return FOREDRAW_NULL_POINTER;

    JoinedMesh mesh =
        mesh_of(c::elements_at<glm::vec3>(positions->first, positions->stride, vertices), checked.indices());
    const CollapseSequence given = sequence_of(*sequence, *pairs_of(*sequence, vertices));
    if (!replay(given, mesh.positions, mesh.indices, mesh.part).mistake.empty()) return FOREDRAW_NO_ORDER;
    const std::span<const foredraw_weighted_attribute> all(attributes, attribute_count);
    mesh.streams = {with_attributes(streams_of(mesh.positions), all)};
    const Collapsed after = collapsed(given, collapses, mesh);
    write_attributes(level_vertices(given, collapses, after, mesh).front(), *mesh.streams.front(), all, values);
    return FOREDRAW_DONE;
  });
}

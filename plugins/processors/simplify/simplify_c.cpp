#include "simplify.h"

#include <foredraw/base/this_thread.h>
#include <foredraw/c/checked_input.h>
#include <foredraw/collapses/cut.h>
#include <foredraw/collapses/draw_distances.h>

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

/// The triangles as one draw of a mesh.
JoinedMesh mesh_of(std::vector<glm::vec3> positions, std::span<const std::uint32_t> indices) {
  const auto* bytes = reinterpret_cast<const std::byte*>(positions.data());
  VertexStreams streams;
  streams.count = static_cast<std::uint32_t>(positions.size());
  streams.base.push_back(
      {"POSITION", {}, Shared(std::vector<std::byte>(bytes, bytes + positions.size() * sizeof(glm::vec3)))});
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

}  // namespace

int foredraw_simplify(void* indices, float* places, foredraw_simplified* simplified,
                      const foredraw_triangles* triangles, const foredraw_positions* positions,
                      const foredraw_collapses* sequence, uint32_t triangle_count, double most_error) {
  return c::with_triangles(triangles, indices, [&](const c::CheckedTriangles& checked) -> int {
    if (simplified == nullptr || sequence == nullptr || sequence->first_pair == nullptr) return FOREDRAW_NULL_POINTER;
    const std::size_t vertices = checked.vertex_count();
    if (const int status = c::positions_status(positions, vertices)) return status;
    if (!(most_error >= 0)) return FOREDRAW_OPTION_RANGE;
    constexpr std::size_t most = std::size_t{1} << 31;
    if (checked.indices().size() > most || vertices > most) return FOREDRAW_TOO_LARGE;
    const auto pairs = pairs_of(*sequence, vertices);
    if (!pairs) return FOREDRAW_NO_ORDER;
    const bool has_arrays = sequence->collapses != nullptr && sequence->pairs != nullptr;
    if (sequence->count > 0 && (!has_arrays || (places == nullptr && sequence->places != nullptr))) {
      return FOREDRAW_NULL_POINTER;
    }
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
    const CollapseSequence given = sequence_of(*sequence, *pairs);
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

#include <foredraw/collapses/cut.h>
#include <foredraw/collapses/level_vertices.h>
#include <foredraw/scene/encode_component.h>

namespace foredraw {

namespace {

/// Places as the format can store them.
void round_to(const VertexStream& positions, std::span<glm::vec3> places) {
  VertexStream stored{positions.semantic, positions.format, {}};
  const Format& format = stored.format;
  std::vector<std::byte> bytes(places.size() * format.bytes);
  const auto each = [&](const auto& visit) {
    for (std::size_t v = 0; v < places.size(); ++v) {
      for (int c = 0; c < 3 && c < format.components; ++c) visit(v, c);
    }
  };
  each([&](std::size_t v, int c) {
    encode_component(bytes.data() + v * format.bytes + c * bytes_of(format.component), format, places[v][c]);
  });
  stored.bytes = Shared<std::byte>(std::move(bytes));
  each([&](std::size_t v, int c) { places[v][c] = decode_component(stored, v, static_cast<std::size_t>(c)); });
}

std::vector<CutDraw> draws_of(const Collapsed& after, const JoinedMesh& mesh, const auto& number,
                              const auto& vertices) {
  std::vector<CutDraw> draws;
  for (std::size_t d = 0; d < mesh.stream_of.size(); ++d) {
    const std::uint32_t s = mesh.stream_of[d];
    std::vector<std::uint32_t> indices;
    for (const std::uint32_t vertex : indices_of(after, mesh, d)) {
      indices.push_back(number(s, vertex - mesh.first_vertex[s]));
    }
    CutDraw draw{vertices(s), Shared<std::uint32_t>(std::move(indices)), {}};
    draw.origin.resize(draw.vertices->count);
    for (std::uint32_t v = mesh.first_vertex[s]; v < mesh.first_vertex[s + 1]; ++v) {
      if (const std::uint32_t now = number(s, v - mesh.first_vertex[s]); now != no_vertex) draw.origin[now] = v;
    }
    draws.push_back(std::move(draw));
  }
  return draws;
}

}  // namespace

Collapsed collapsed(const CollapseSequence& sequence, std::size_t collapses, const JoinedMesh& mesh) {
  Collapsed after = collapsed(sequence, collapses, mesh.positions, mesh.indices);
  for (std::size_t s = 0; s < mesh.streams.size(); ++s) {
    const VertexStream* positions = mesh.streams[s]->find("POSITION");
    if (positions == nullptr || positions->format.component == Component::float32) continue;
    const std::size_t first = mesh.first_vertex[s], end = mesh.first_vertex[s + 1];
    round_to(*positions, std::span(after.places).subspan(first, end - first));
  }
  return after;
}

std::span<const std::uint32_t> indices_of(const Collapsed& after, const JoinedMesh& mesh, std::size_t draw) {
  const auto first_left = [&](std::uint32_t index) {
    return std::ranges::lower_bound(after.origin, index / 3) - after.origin.begin();
  };
  const auto first = first_left(mesh.first_index[draw]), end = first_left(mesh.first_index[draw + 1]);
  return std::span(after.indices).subspan(3 * first, 3 * (end - first));
}

std::vector<CutDraw> cut(const CollapseSequence& sequence, std::size_t collapses, const Collapsed& after,
                         const JoinedMesh& mesh) {
  const std::vector<LevelVertices> streams = level_vertices(sequence, collapses, after, mesh);
  return draws_of(
      after, mesh, [&](std::uint32_t s, std::uint32_t vertex) { return streams[s].number[vertex]; },
      [&](std::uint32_t s) { return streams[s].vertices; });
}

bool leaves_vertices(const CollapseSequence& sequence, const JoinedMesh& mesh) {
  for (std::size_t k = 0; k < sequence.collapses.size(); ++k) {
    const Collapse& collapse = sequence.collapses[k];
    if (collapse.blend != 0) return false;
    if (sequence.places.empty()) continue;
    const float* place = sequence.places.data() + 3 * k;
    if (glm::vec3(place[0], place[1], place[2]) != mesh.positions[collapse.kept]) return false;
  }
  return true;
}

std::vector<CutDraw> cut_of_same_vertices(const Collapsed& after, const JoinedMesh& mesh) {
  return draws_of(
      after, mesh, [](std::uint32_t, std::uint32_t vertex) { return vertex; },
      [&](std::uint32_t s) { return mesh.streams[s]; });
}

}  // namespace foredraw

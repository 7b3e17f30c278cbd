#include "stream_mesh.h"

#include <foredraw/analysis/welded_positions.h>
#include <foredraw/base/content_hash.h>

#include <algorithm>
#include <array>

namespace foredraw {

namespace {

/// A draw, and what its three vertices have, begun so that it is least.
struct Drawn {
  std::uint32_t draw = 0;
  std::array<Stamp, 3> corners;
  auto operator<=>(const Drawn&) const = default;
};

Stamp stamp_of(std::span<const std::int32_t> place, std::span<const std::int32_t> values) {
  return content_hash(std::as_bytes(values), content_hash(std::as_bytes(place)).low);
}

/// Sorted, of triangles of three points.
std::vector<Drawn> drawn(std::size_t triangles, const auto& draw, const auto& point, const auto& stamp) {
  std::vector<Drawn> all;
  for (std::size_t t = 0; t < triangles; ++t) {
    const std::array points{point(3 * t), point(3 * t + 1), point(3 * t + 2)};
    if (points[0] == points[1] || points[1] == points[2] || points[2] == points[0]) continue;
    Drawn one{draw(t), {stamp(3 * t), stamp(3 * t + 1), stamp(3 * t + 2)}};
    const auto& c = one.corners;  // two of them may be equal
    one.corners = std::min({c, {c[1], c[2], c[0]}, {c[2], c[0], c[1]}});
    all.push_back(one);
  }
  std::ranges::sort(all);
  return all;
}

std::vector<Drawn> drawn_by(const StreamMesh& stream) {
  const foredraw_split_mesh& mesh = stream.mesh();
  const NumberGrid grid = stream.grid();
  std::vector<Stamp> stamps;
  for (std::size_t v = 0; v < mesh.vertices; ++v) {
    stamps.push_back(stamp_of({mesh.point[mesh.vertex[v].point].place, 3},
                              {mesh.values + grid.width * v, grid.parts[mesh.vertex[v].part].count}));
  }
  return drawn(
      mesh.triangles, [&](std::size_t t) { return mesh.draw[t]; }, [&](std::size_t c) { return mesh.corner[c].point; },
      [&](std::size_t c) { return stamps[mesh.indices[c]]; });
}

std::vector<Drawn> drawn_by(const JoinedMesh& mesh, const VertexNumbers& numbers, const NumberGrid& grid) {
  const std::vector<std::uint32_t> point_of = welded(mesh.positions);
  std::vector<Stamp> stamps;
  for (std::size_t v = 0; v < point_of.size(); ++v) {
    stamps.push_back(stamp_of(std::span(numbers.places).subspan(3 * v, 3),
                              std::span(numbers.values).subspan(grid.width * v, grid.parts[mesh.part[v]].count)));
  }
  const auto draw_of = [&](std::size_t t) {
    const auto behind = std::ranges::upper_bound(mesh.first_index, 3 * t);
    return static_cast<std::uint32_t>(behind - mesh.first_index.begin()) - 1;
  };
  return drawn(
      mesh.indices.size() / 3, draw_of, [&](std::size_t c) { return point_of[mesh.indices[c]]; },
      [&](std::size_t c) { return stamps[mesh.indices[c]]; });
}

}  // namespace

std::optional<StreamMesh> StreamMesh::read(std::span<const std::byte> bytes) {
  StreamMesh read;
  const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  foredraw_stream_header header;
  if (foredraw_stream_read_header(data, bytes.size(), &header) != 1 || header.total != bytes.size()) {
    return std::nullopt;
  }
  read.memory_.resize(foredraw_stream_memory(&header, data) / sizeof(std::uint32_t) + 1);
  foredraw_stream_begin(&read.stream_, &header, data, read.memory_.data());
  std::size_t at = header.bytes;
  while (const std::size_t used = foredraw_stream_take(&read.stream_, data + at, bytes.size() - at)) {
    at += used;
    read.chunk_end_.push_back(static_cast<std::uint32_t>(at));
  }
  if (read.stream_.damaged || read.stream_.chunks != header.chunks || at != bytes.size()) return std::nullopt;
  return read;
}

NumberGrid StreamMesh::grid() const {
  NumberGrid grid;
  grid.bits = header().grid_bits;
  std::copy_n(header().least, 3, grid.least);
  grid.step = header().step;
  grid.components.assign(mesh().component, mesh().component + header().components);
  grid.parts.assign(mesh().part, mesh().part + header().parts);
  grid.width = mesh().width;
  return grid;
}

std::string difference(const StreamMesh& stream, const JoinedMesh& mesh) {
  const NumberGrid grid = stream.grid();
  const auto numbers = vertex_numbers(mesh, grid);
  const std::span draw_parts(stream.mesh().draw_part, stream.header().draws);
  if (!numbers || !std::ranges::equal(draw_parts, mesh.stream_of)) return "its vertices have other attributes";
  return drawn_by(stream) == drawn_by(mesh, *numbers, grid) ? std::string() : "it shows other triangles";
}

}  // namespace foredraw

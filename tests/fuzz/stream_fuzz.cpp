// The bytes are what a chunk codes, behind a header and a checksum that are right, so that they are read; or a small
// mesh, whose stream must show it. Whatever the bytes say, reading comes to an end, and corners have vertices.

#include "claim.h"
#include "odd_input.h"

#include <plugins/processors/progressive_stream/progressive_stream.h>
#include <plugins/processors/progressive_stream/stream_bytes.h>
#include <plugins/processors/progressive_stream/stream_mesh.h>
#include <plugins/processors/quadric_collapse/quadric_collapse.h>

#include <cmath>
#include <cstring>

namespace foredraw {
namespace {

using testing::OddInput;

void read_any(OddInput input) {
  foredraw_stream_header header{};
  header.points = static_cast<std::uint32_t>(input.byte());
  header.vertices = static_cast<std::uint32_t>(input.byte());
  header.triangles = static_cast<std::uint32_t>(input.byte());
  header.grid_bits = static_cast<std::uint32_t>(1 + input.below(20));
  header.step = 1;
  header.parts = header.draws = 2;
  header.components = 3;
  const foredraw_part parts[] = {{0, 2}, {2, 1}};
  const std::uint32_t draw_parts[] = {1, 0};
  const foredraw_component components[] = {{0, 3, 0, 0}, {2, 1, 0, 0}, {1, 3, 0, 1}};
  CodedChunk chunk{{}, static_cast<std::uint32_t>(input.byte()), header.vertices, header.triangles, 0};
  while (input.left() > 0) chunk.bytes.push_back(static_cast<std::byte>(input.byte()));
  std::vector<std::uint32_t> ends;
  const std::vector<std::byte> bytes = stream_bytes(header, parts, draw_parts, components, std::span(&chunk, 1), ends);
  const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  claim(foredraw_stream_read_header(data, bytes.size(), &header) == 1, "a good header is refused");
  std::vector<std::uint32_t> memory(foredraw_stream_memory(&header, data) / 4 + 1);
  foredraw_stream stream;
  foredraw_stream_begin(&stream, &header, data, memory.data());
  foredraw_stream_take(&stream, data + header.bytes, bytes.size() - header.bytes);
  const foredraw_split_mesh& mesh = stream.coding.mesh;
  claim(mesh.points <= header.points && mesh.vertices <= header.vertices && mesh.triangles <= header.triangles,
        "there is more than there is room for");
  for (std::size_t c = 0; !stream.damaged && c < std::size_t{3} * mesh.triangles; ++c) {
    claim(mesh.indices[c] < mesh.vertices && mesh.vertex[mesh.indices[c]].point == mesh.corner[c].point,
          "a corner has a vertex of another point");
  }
}

void write_and_read(OddInput input) {
  const auto vertices = static_cast<std::uint32_t>(1 + input.below(60));
  JoinedMesh mesh;
  for (std::uint32_t v = 0; v < vertices; ++v)
    mesh.positions.emplace_back(input.number(), input.number(), input.number());
  mesh.indices = testing::odd_indices(input, vertices, 3 * input.below(100));
  for (const std::uint32_t index : mesh.indices) {
    const glm::vec3 at = mesh.positions[index];
    if (!std::isfinite(at.x) || !std::isfinite(at.y) || !std::isfinite(at.z)) return;  // refused, and said so
  }
  mesh.part.assign(vertices, 0);
  mesh.first_index = {0, static_cast<std::uint32_t>(mesh.indices.size())};
  mesh.first_vertex = {0, vertices};
  mesh.stream_of = {0};
  VertexStreams streams;
  streams.count = vertices;
  const auto bytes = std::as_bytes(std::span(mesh.positions));
  streams.base.push_back(
      {"POSITION", {Component::float32, 3, false, 12}, Shared<std::byte>({bytes.begin(), bytes.end()})});
  mesh.streams = {std::make_shared<const VertexStreams>(std::move(streams))};
  const CollapseSequence sequence =
      quadric_collapse(mesh.positions, mesh.indices, {.placement = CollapsePlacement::endpoint});
  ProgressiveStreamOptions options;
  options.position_bits = static_cast<std::uint32_t>(4 + input.below(17));
  options.lossless = input.below(2) == 0;
  options.chunk_size = 64;
  const auto read = StreamMesh::read(progressive_stream(mesh, sequence, options).bytes);
  claim(read.has_value(), "a stream that was written is refused");
  claim(difference(*read, mesh).empty(), "a stream shows another mesh");
}

}  // namespace
}  // namespace foredraw

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  foredraw::testing::OddInput input(data, size);
  if (input.byte() % 2 == 0) {
    foredraw::read_any(input);
  } else {
    foredraw::write_and_read(input);
  }
  return 0;
}

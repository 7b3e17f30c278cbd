// Progressive streams of positions and triangles, beside meshoptimizer's codecs (vertices of 16 bits a coordinate, in
// an order for the vertex cache; whole meshes, not progressive). Bytes are those of the whole stream, with header and
// coarsest mesh; a byte a vertex counts places, as streams and the peer both have them. Times are of the processor, one
// thread, the median of seven readings; the stream that is read must show the mesh.
//   progressive-stream-bench [-o FOLDER] FILES    a table of files (glTF, OBJ, PLY, ...), each as one mesh; the folder
//   gets
//                                                 what the peer's codecs wrote, for a general compressor

#include <benchmarks/meshes/one_mesh.h>
#include <plugins/processors/progressive_stream/progressive_stream.h>
#include <plugins/processors/progressive_stream/stream_mesh.h>
#include <plugins/processors/quadric_collapse/quadric_collapse.h>

#include <fmt/format.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace foredraw::bench {
namespace {

constexpr std::size_t rounds = 7;

/// All triangles of the file as one draw, one vertex a place, without other attributes.
JoinedMesh mesh_of(const std::string& path) {
  WeldedMesh welded = welded_mesh(read_joined(path));
  JoinedMesh mesh;
  mesh.positions = std::move(welded.positions);
  mesh.indices = std::move(welded.indices);
  const auto vertices = static_cast<std::uint32_t>(mesh.positions.size());
  VertexStreams streams;
  streams.count = vertices;
  const auto bytes = std::as_bytes(std::span(mesh.positions));
  streams.base.push_back(
      {"POSITION", {Component::float32, 3, false, 12}, Shared<std::byte>({bytes.begin(), bytes.end()})});
  mesh.part.assign(vertices, 0);
  mesh.first_index = {0, static_cast<std::uint32_t>(mesh.indices.size())};
  mesh.first_vertex = {0, vertices};
  mesh.streams = {std::make_shared<const VertexStreams>(std::move(streams))};
  mesh.stream_of = {0};
  return mesh;
}

/// Splits a second.
double reading(const ProgressiveStream& stream) {
  const auto* data = reinterpret_cast<const std::uint8_t*>(stream.bytes.data());
  foredraw_stream_header header;
  if (foredraw_stream_read_header(data, stream.bytes.size(), &header) != 1) throw std::runtime_error("no stream");
  std::vector<std::uint32_t> memory(foredraw_stream_memory(&header, data) / 4 + 1);
  std::array<double, rounds> times{};
  for (double& time : times) {
    const double begin = seconds();
    foredraw_stream reader;
    foredraw_stream_begin(&reader, &header, data, memory.data());
    std::size_t at = header.bytes;
    while (const std::size_t used = foredraw_stream_take(&reader, data + at, stream.bytes.size() - at)) at += used;
    time = seconds() - begin;
  }
  std::ranges::sort(times);
  return static_cast<double>(stream.collapse.size()) / times[rounds / 2];
}

std::vector<unsigned char> peers(const JoinedMesh& mesh, std::uint32_t bits) {
  NumberBits how;
  how.position_bits = bits;
  const std::size_t count = mesh.positions.size();
  const VertexNumbers numbers = vertex_numbers(mesh, number_grid(mesh, how)).value();
  std::vector<std::array<std::uint16_t, 4>> vertices(count), fetched(count);
  for (std::size_t v = 0; v < count; ++v) {
    for (std::size_t k = 0; k < 3; ++k) vertices[v][k] = static_cast<std::uint16_t>(numbers.places[3 * v + k]);
  }
  std::vector<std::uint32_t> indices(mesh.indices.size());
  meshopt_optimizeVertexCacheStrip(indices.data(), mesh.indices.data(), indices.size(), count);
  meshopt_optimizeVertexFetch(fetched.data(), indices.data(), indices.size(), vertices.data(), count, 8);
  std::vector<unsigned char> bytes(meshopt_encodeVertexBufferBound(count, 8));
  bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), fetched.data(), count, 8));
  std::vector<unsigned char> coded(meshopt_encodeIndexBufferBound(indices.size(), count));
  coded.resize(meshopt_encodeIndexBuffer(coded.data(), coded.size(), indices.data(), indices.size()));
  bytes.insert(bytes.end(), coded.begin(), coded.end());
  return bytes;
}

void measure(const std::string& path, const std::string& folder) {
  const JoinedMesh mesh = mesh_of(path);
  const CollapseSequence sequence =
      quadric_collapse(mesh.positions, mesh.indices, {.placement = CollapsePlacement::endpoint});
  const auto vertices = static_cast<double>(mesh.positions.size());
  const std::string name = std::filesystem::path(path).stem().string();
  for (const std::uint32_t bits : {12u, 16u}) {
    ProgressiveStreamOptions options;
    options.position_bits = bits;
    const ProgressiveStream stream = progressive_stream(mesh, sequence, options);
    const auto read = StreamMesh::read(stream.bytes);
    if (!read || !difference(*read, mesh).empty()) throw std::runtime_error("the stream shows another mesh");
    const std::vector<unsigned char> peer = peers(mesh, bits);
    fmt::print("| {} | {} | {} | {} | {:.2f} | {} | {:.2f} | {:.2f} |\n", name, mesh.positions.size(), bits,
               stream.bytes.size(), static_cast<double>(stream.bytes.size()) / vertices, stream.chunk_end.size(),
               reading(stream) / 1e6, static_cast<double>(peer.size()) / vertices);
    std::fflush(stdout);
    if (folder.empty()) continue;
    std::ofstream(std::filesystem::path(folder) / fmt::format("{}.{}", name, bits), std::ios::binary)
        .write(reinterpret_cast<const char*>(peer.data()), static_cast<std::streamsize>(peer.size()));
  }
}

}  // namespace
}  // namespace foredraw::bench

int main(int argc, char** argv) {
  std::vector<std::string> files(argv + 1, argv + argc);
  std::string folder;
  if (files.size() > 1 && files[0] == "-o") {
    folder = files[1];
    files.erase(files.begin(), files.begin() + 2);
  }
  fmt::print("| mesh | vertices | bits | bytes | bytes a vertex | chunks | M splits a second | meshoptimizer |\n");
  fmt::print("|---|---:|---:|---:|---:|---:|---:|---:|\n");
  for (const std::string& file : files) foredraw::bench::measure(file, folder);
  return 0;
}

#pragma once
// Meshes to be streamed, and a reader of streams.

#include "plugins/processors/progressive_stream/progressive_stream.h"
#include "plugins/processors/progressive_stream/stream_mesh.h"
#include "plugins/processors/quadric_collapse/quadric_collapse.h"
#include "support/collapses.h"

#include <foredraw/runtime/progressive_stream.h>

#include <cmath>

namespace foredraw::testing {

/// Attributes of all kinds, that change from vertex to vertex.
inline std::shared_ptr<const VertexStreams> with_attributes(const std::vector<glm::vec3>& positions) {
  auto vertices = std::make_shared<VertexStreams>(*vertex_streams(positions));
  std::vector<float> uv, normals;
  std::vector<std::uint8_t> colours;
  for (const glm::vec3& p : positions) {
    uv.insert(uv.end(), {p.x * 3 + p.z, p.y - 7});
    const float length = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z + 1);
    normals.insert(normals.end(), {p.x / length, p.y / length, 1 / length});
    for (int k = 0; k < 3; ++k) colours.push_back(static_cast<std::uint8_t>(static_cast<int>(90 * p[k]) & 255));
    colours.push_back(255);
  }
  const auto add = [&](const char* semantic, Format format, const auto& values) {
    const auto bytes = std::as_bytes(std::span(values));
    vertices->base.push_back({semantic, format, Shared<std::byte>({bytes.begin(), bytes.end()})});
  };
  add("TEXCOORD_0", {Component::float32, 2, false, 8}, uv);
  add("NORMAL", {Component::float32, 3, false, 12}, normals);
  add("COLOR_0", {Component::uint8, 4, true, 4}, colours);
  return vertices;
}

struct Sequenced {
  Scene scene;
  std::vector<DrawId> draws;
  JoinedMesh mesh;
  CollapseSequence sequence;
};

/// All draws of the scene as one mesh, and the sequence in which it becomes coarser.
inline Sequenced sequenced(Scene scene, CollapsePlacement placement = CollapsePlacement::endpoint) {
  Sequenced made{std::move(scene), {}, {}, {}};
  for (DrawId id = 0; id < made.scene.draws.size(); ++id) made.draws.push_back(id);
  Analyses analyses;
  made.mesh = joined_mesh(made.scene, made.draws, analyses).value();
  made.sequence = quadric_collapse(made.mesh.positions, made.mesh.indices, {.placement = placement});
  return made;
}

/// Half a torus with attributes, the other half without, as draws that meet at two rings; the first has a seam.
inline Scene two_halves() {
  TestMesh torus = closed_torus(48, 24);
  const std::size_t half = torus.indices.size() / 6 * 3, seam = half / 6 * 3;
  TestMesh other{torus.positions, {torus.indices.begin() + static_cast<std::ptrdiff_t>(half), torus.indices.end()}};
  torus.indices.resize(half);
  const std::size_t vertices = torus.positions.size();
  for (std::size_t v = 0; v < vertices; ++v) torus.positions.push_back(glm::vec3(torus.positions[v]));
  for (std::size_t i = seam; i < half; ++i) torus.indices[i] += static_cast<std::uint32_t>(vertices);
  std::vector<Draw> draws{draw_of(torus, "first"), draw_of(other, "second")};
  draws[0].full().vertices = with_attributes(torus.positions);
  // Both sides of the seam have texture coordinates of their own.
  auto seamed = std::make_shared<VertexStreams>(*draws[0].full().vertices);
  std::vector<std::byte> uv(seamed->base[1].bytes.view().begin(), seamed->base[1].bytes.view().end());
  for (std::size_t v = vertices; v < 2 * vertices; ++v) uv[8 * v + 2] ^= std::byte{0x40};
  seamed->base[1].bytes = Shared<std::byte>(std::move(uv));
  draws[0].full().vertices = std::move(seamed);
  return scene_of(std::move(draws));
}

inline const std::uint8_t* raw(std::span<const std::byte> bytes) {
  return reinterpret_cast<const std::uint8_t*>(bytes.data());
}

/// Reads so many chunks of a good stream.
class Reader {
 public:
  Reader(std::span<const std::byte> bytes, std::size_t chunks) {
    foredraw_stream_header header;
    is_good_ = foredraw_stream_read_header(raw(bytes), bytes.size(), &header) == 1;
    if (!is_good_) return;
    memory_.resize(foredraw_stream_memory(&header, raw(bytes)) / 4 + 1);
    foredraw_stream_begin(&stream_, &header, raw(bytes), memory_.data());
    std::size_t at = header.bytes, used = 0;
    while (stream_.chunks < chunks && (used = foredraw_stream_take(&stream_, raw(bytes) + at, bytes.size() - at)) > 0) {
      at += used;
    }
    is_good_ = !stream_.damaged;
  }
  bool is_good() const { return is_good_; }
  const foredraw_stream& stream() const { return stream_; }
  const foredraw_split_mesh& mesh() const { return stream_.coding.mesh; }

 private:
  foredraw_stream stream_ = {};
  std::vector<std::uint32_t> memory_;
  bool is_good_ = false;
};

inline constexpr std::size_t all_chunks = ~std::size_t{0};

}  // namespace foredraw::testing

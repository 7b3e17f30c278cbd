#pragma once
// A scene through bytes and back, and the changes that the tests of the writer make to it.

#include <foredraw/io/gltf/gltf.h>
#include <foredraw/scene/reorder.h>
#include <foredraw/scene/vertex_groups.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "support/gltf_builder.h"
#include "support/products.h"

namespace foredraw::testing {

using Bytes = std::vector<std::byte>;
using Indices = std::vector<std::uint32_t>;

inline Scene read(const Bytes& file) {
  Diagnostics diagnostics;
  auto scene = read_gltf(file, "test", {}, diagnostics, {.products = built_in_products()});
  if (!scene) throw std::runtime_error(to_text(diagnostics));
  return *scene;
}

inline Scene read(const GltfBuilder& builder) { return read(builder.glb()); }

inline Bytes write(const Scene& scene) {
  Diagnostics diagnostics;
  const auto files = encode_gltf(scene, "out.glb", diagnostics, {.products = built_in_products()});
  const bool quiet = std::ranges::all_of(diagnostics.all(), [](const auto& d) { return d.code == "output-grew"; });
  if (!files || !quiet) throw std::runtime_error(to_text(diagnostics));
  return files->front().bytes;
}

inline GltfJson written(const Scene& scene) { return json_of(write(scene)); }

inline void reverse(Draw& draw) {
  Indices order(draw.levels[0].orders[0].triangle_count());
  std::iota(order.rbegin(), order.rend(), 0u);
  draw = with_triangle_order(draw, order);
}

/// Vertices in the opposite sequence, for everybody who draws from the same streams; the first `drop` are left out.
inline void reverse_vertices(Scene& scene, std::size_t draw, std::uint32_t drop = 0) {
  for (const VertexGroup& group : vertex_groups(scene)) {
    if (group.vertices != scene.draws[draw].levels[0].vertices) continue;
    Indices destination(group.vertices->count, no_vertex);
    std::iota(destination.rbegin(), destination.rend() - drop, 0u);
    move_vertices(scene, group, destination, group.vertices->count - drop);
    return;
  }
}

inline const VertexStream& stream(const Scene& scene, std::size_t draw, const char* semantic) {
  return *scene.draws[draw].levels[0].vertices->find(semantic);
}

inline Indices indices_of(const Scene& scene, std::size_t draw) {
  const auto view = scene.draws[draw].levels[0].orders[0].indices.view();
  return {view.begin(), view.end()};
}

inline VertexStreams with_stream(const Scene& scene, std::size_t draw, VertexStream replaced) {
  VertexStreams streams = *scene.draws[draw].levels[0].vertices;
  for (VertexStream& one : streams.base) {
    if (one.semantic == replaced.semantic) one = replaced;
  }
  return streams;
}

/// Three draws: two with the very same accessors, a third with the positions alone.
inline GltfBuilder sharing() {
  GltfBuilder builder = ribbon(3);
  GltfJson& primitives = builder.json["meshes"][0]["primitives"];
  const GltfJson first = primitives[0];
  primitives.push_back(first);
  primitives.push_back(first);
  primitives[2]["attributes"].erase("TEXCOORD_0");
  return builder;
}

}  // namespace foredraw::testing

#pragma once
// Scenes whose vertices can be packed.

#include "plugins/processors/vertex_pack/packed_vertices_product.h"
#include "support/bending_tube.h"
#include "support/displaced.h"
#include "support/gltf_builder.h"
#include "support/packed_vertices.h"
#include "support/staged.h"

#include <foredraw/io/gltf/gltf.h>

#include <glm/common.hpp>

namespace foredraw::testing {

inline void put_streams(Level& level, const std::vector<VertexStream>& added) {
  VertexStreams streams = *level.vertices;
  for (const VertexStream& stream : added) {
    std::erase_if(streams.base, [&](const VertexStream& old) { return old.semantic == stream.semantic; });
    streams.base.push_back(stream);
  }
  level.vertices = std::make_shared<const VertexStreams>(std::move(streams));
}

/// Normals that point away from the middle, tangents around z, texture coordinates by angles and height.
inline void add_frames(Level& level, const glm::vec3& middle = glm::vec3(0)) {
  std::vector<glm::vec3> normals;
  std::vector<glm::vec4> tangents;
  std::vector<glm::vec2> uvs;
  for (const glm::vec3& p : decode_vec3(*level.vertices->find("POSITION"))) {
    const glm::vec3 away = p - middle + glm::vec3(1e-3f, 0, 0);
    normals.push_back(glm::normalize(away));
    tangents.emplace_back(glm::normalize(glm::cross(normals.back(), glm::vec3(0.1f, 0.2f, 1))), p.x < 0 ? -1 : 1);
    uvs.emplace_back(0.5f + 0.4f * normals.back().x, 0.5f + 0.5f * normals.back().z);
  }
  put_streams(level,
              {float_stream("NORMAL", normals), float_stream("TANGENT", tangents), float_stream("TEXCOORD_0", uvs)});
}

inline Draw framed(Draw draw) {
  for (Level& level : draw.levels) add_frames(level);
  return draw;
}

/// A ball of three levels, and a plate of one.
inline Scene framed_scene() {
  Draw ball = draw_of(sphere(48, 24), "ball");
  for (const std::uint32_t part : {2u, 4u}) {
    Level level = draw_of(sphere(48 / part, 24 / part)).full();
    level.error = 0.01f * static_cast<float>(part * part);
    ball.levels.push_back(std::move(level));
  }
  return scene_of({framed(std::move(ball)), framed(draw_of(grid(8, 8), "plate"))});
}

inline Scene packed(const Scene& scene, const std::string& options = "") {
  Result result = run("vertex-pack" + options, scene);
  for (const Diagnostic& diagnostic : result.report.diagnostics) {
    if (result.failed) throw std::runtime_error(to_text(diagnostic));
  }
  return std::move(result.scene);
}

inline std::string notes_of(const Result& result) {
  std::string text;
  for (const auto& stage : result.report.stages) {
    for (const NoteRecord& note : stage.notes) text += note.code + ": " + note.message + '\n';
  }
  return text;
}

inline const PackedVertices& packed_of(const Scene& scene) {
  const auto* all = scene.products.find<PackedVertices>();
  if (all == nullptr) throw std::runtime_error("the scene has no packed vertices");
  return *all;
}

inline std::vector<std::byte> written_packed(const Scene& scene) {
  Diagnostics diagnostics;
  const auto files = encode_gltf(scene, "out.glb", diagnostics, {.products = {packed_vertices_product()}});
  if (!files || diagnostics.has_errors()) throw std::runtime_error(to_text(diagnostics));
  return files->front().bytes;
}

inline foredraw_packed_vertex unpacked_vertex(const PackedVertices::OfDraw& draw, std::size_t vertex) {
  foredraw_packed_vertex decoded;
  foredraw_packed_decode(&draw.layout, draw.rows[0].view().data() + 4 * vertex, &decoded);
  return decoded;
}

}  // namespace foredraw::testing

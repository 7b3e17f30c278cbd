#pragma once
// Scenes whose texture coordinates are in other units, and whose materials scale them back.

#include <foredraw/scene/scaled_texcoords.h>
#include <foredraw/scene/scene.h>
#include <foredraw/scene/triangle_draw.h>

#include <glm/vec2.hpp>

#include <string>

namespace foredraw::testing {

/// A unit is scale of what it was, counted from offset; with powers of two and coordinates of few bits to the last bit.
inline Scene in_other_units(Scene scene, const ScaledTexcoords& change) {
  const std::string semantic = "TEXCOORD_" + std::to_string(change.set);
  for (Draw& draw : scene.draws) {
    for (Level& level : draw.levels) {
      VertexStreams streams = *level.vertices;
      for (VertexStream& stream : streams.base) {
        if (stream.semantic != semantic) continue;
        std::vector<glm::vec2> uvs;
        for (const glm::dvec2 uv : decode_vec3(stream)) uvs.emplace_back((uv - change.offset) / change.scale);
        stream = float_stream(semantic, uvs);
      }
      level.vertices = std::make_shared<const VertexStreams>(std::move(streams));
    }
    if (draw.material) continue;
    draw.material = static_cast<MaterialId>(scene.materials.size());
    scene.materials.emplace_back();
  }
  for (Material& material : scene.materials) material = with_scaled_texcoords(std::move(material), change);
  return scene;
}

}  // namespace foredraw::testing

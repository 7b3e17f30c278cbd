#pragma once
// Surfaces that a map of heights moves.

#include "support/meshes.h"

#include <foredraw/scene/triangle_draw.h>

#include <glm/vec2.hpp>

#include <cstring>
#include <functional>
#include <limits>

namespace foredraw::testing {

using foredraw::float_stream;

/// Heights at (x, y), rows from the top, as an image that a stage made.
inline Image height_image(std::uint32_t width, std::uint32_t height,
                          const std::function<std::uint16_t(std::uint32_t, std::uint32_t)>& at) {
  std::vector<std::byte> bytes(std::size_t{width} * height * 2);
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      const std::uint16_t value = at(x, y);
      std::memcpy(&bytes[2 * (std::size_t{y} * width + x)], &value, 2);
    }
  }
  Image image{.name = "heights", .bytes = Shared(std::move(bytes))};
  image.is_texels = true;
  image.facts = {width, height, 1, 16};
  return image;
}

/// The mesh with texture coordinates and an image, by which its material moves it.
inline Scene displaced_scene(const TestMesh& mesh, const std::vector<glm::vec2>& uv, Image map, float factor = 1,
                             float offset = 0) {
  Scene scene = scene_of(mesh);
  VertexStreams vertices = *scene.draws[0].full().vertices;
  vertices.base.push_back(float_stream("TEXCOORD_0", uv));
  scene.draws[0].full().vertices = std::make_shared<const VertexStreams>(std::move(vertices));
  scene.images.push_back(std::move(map));
  Material material;
  material.displacement = {{.image = 0}, factor, offset};
  scene.materials.push_back(std::move(material));
  scene.draws[0].material = 0;
  scene.draws[0].traits.add(traits::displaced);
  scene.draws[0].traits.add(traits::uv0);
  return scene;
}

/// grid(): its square is the map.
inline Scene displaced_grid(std::uint32_t columns, std::uint32_t rows, Image map, float factor = 1, float offset = 0) {
  const TestMesh mesh = grid(columns, rows);
  std::vector<glm::vec2> uv;
  for (const glm::vec3& at : mesh.positions)
    uv.emplace_back(at.x / static_cast<float>(columns), at.y / static_cast<float>(rows));
  return displaced_scene(mesh, uv, std::move(map), factor, offset);
}

}  // namespace foredraw::testing

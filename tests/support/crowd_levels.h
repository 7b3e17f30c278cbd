#pragma once
// Scenes of what stands in crowds, and their levels.

#include "plugins/processors/crowd_levels/crowd_levels.h"
#include "plugins/processors/crowd_levels/crowd_levels_product.h"
#include "support/displaced.h"
#include "support/gltf_builder.h"
#include "support/meshes.h"
#include "support/staged.h"

#include <foredraw/io/gltf/gltf.h>

#include <algorithm>

namespace foredraw::testing {

/// A ball of three levels, and a plate of one, each a mesh.
inline Scene crowd_of_balls() {
  Draw ball = draw_of(sphere(48, 24), "ball");
  for (const std::uint32_t part : {2u, 4u}) {
    Level level = draw_of(sphere(48 / part, 24 / part)).full();
    level.error = 0.01f * static_cast<float>(part * part);
    ball.levels.push_back(std::move(level));
  }
  return scene_of({std::move(ball), draw_of(grid(8, 8), "plate")});
}

/// A square of two triangles whose height is x^2, x from 0 to 1. It takes the middle of the map, so that nothing is
/// wrapped.
inline Scene displaced_parabola(float factor) {
  const TestMesh mesh = grid(1, 1);
  std::vector<glm::vec2> uv;
  for (const glm::vec3& at : mesh.positions) uv.emplace_back(0.25f + at.x / 2, 0.5f);
  return displaced_scene(mesh, uv,
                         height_image(1024, 1,
                                      [](std::uint32_t column, std::uint32_t) {
                                        const double x = std::clamp(2 * (column + 0.5) / 1024 - 0.5, 0.0, 1.0);
                                        return static_cast<std::uint16_t>(65535 * x * x + 0.5);
                                      }),
                         factor);
}

inline Scene with_crowd_levels(const std::string& options = "") {
  return run("crowd-levels" + options, crowd_of_balls()).scene;
}

inline const CrowdLevels& crowd_levels_of(const Scene& scene) {
  const auto* levels = scene.products.find<CrowdLevels>();
  if (levels == nullptr) throw std::runtime_error("the scene has no levels of a crowd");
  return *levels;
}

inline std::vector<std::byte> written_crowd(const Scene& scene) {
  Diagnostics diagnostics;
  const auto files = encode_gltf(scene, "out.glb", diagnostics, {.products = {crowd_levels_product()}});
  if (!files || diagnostics.has_errors()) throw std::runtime_error(to_text(diagnostics));
  return files->front().bytes;
}

}  // namespace foredraw::testing

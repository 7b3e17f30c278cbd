#pragma once
// A scene of draws with levels, and its table of levels and renderings.

#include "plugins/processors/lod_table/lod_table.h"
#include "plugins/processors/lod_table/lod_table_product.h"
#include "support/gltf_builder.h"
#include "support/meshes.h"
#include "support/staged.h"

#include <foredraw/io/gltf/gltf.h>

namespace foredraw::testing {

/// A ball of three levels, and a plate of one.
inline Scene ball_and_plate() {
  Draw ball = draw_of(sphere(48, 24), "ball");
  for (const std::uint32_t part : {2u, 4u}) {
    Level level = draw_of(sphere(48 / part, 24 / part)).full();
    level.error = 0.01f * static_cast<float>(part * part);
    ball.levels.push_back(std::move(level));
  }
  return scene_of({std::move(ball), draw_of(grid(8, 8), "plate")});
}

inline Scene with_table(const std::string& options = "") { return run("lod-table" + options, ball_and_plate()).scene; }

inline const LodTable& table_of(const Scene& scene) {
  const auto* table = scene.products.find<LodTable>();
  if (table == nullptr) throw std::runtime_error("the scene has no table");
  return *table;
}

inline std::vector<std::byte> written_with_table(const Scene& scene) {
  Diagnostics diagnostics;
  const auto files = encode_gltf(scene, "out.glb", diagnostics, {.products = {lod_table_product()}});
  if (!files || diagnostics.has_errors()) throw std::runtime_error(to_text(diagnostics));
  return files->front().bytes;
}

}  // namespace foredraw::testing

#pragma once
// Small files with a double-sided box, and what the stage `sides` makes of them.

#include "support/gltf_builder.h"

#include <foredraw/io/gltf/gltf.h>
#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/runner.h>
#include <foredraw/technique/built_in_plugins.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

namespace foredraw::testing {

/// Outwards; three a triangle. The last two triangles are its lid.
inline std::vector<std::uint16_t> box_corners() {
  return {0, 2, 1, 1, 2, 3, 0, 1, 4, 1, 5, 4, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5, 2, 6, 3, 3, 6, 7, 4, 5, 6, 5, 7, 6};
}

/// Eight points at 1 and -1 with normals that point out of the middle, or into it where `way` is -1.
inline GltfJson box_primitive(GltfBuilder& builder, const std::vector<std::uint16_t>& corners, float way = 1) {
  std::vector<float> positions;
  for (int i = 0; i < 8; ++i) {
    for (const int bit : {1, 2, 4}) positions.push_back(i & bit ? 1.f : -1.f);
  }
  std::vector<float> normals = positions;
  for (float& component : normals) component *= way * 0.57735027f;
  const std::size_t position = builder.add_values(positions, "VEC3");
  builder.json["accessors"][position]["min"] = {-1, -1, -1};
  builder.json["accessors"][position]["max"] = {1, 1, 1};
  return {{"attributes", {{"POSITION", position}, {"NORMAL", builder.add_values(normals, "VEC3")}}},
          {"indices", builder.add_values(corners, "SCALAR")},
          {"material", 0}};
}

/// A file with one mesh, of which the material is double-sided.
inline GltfBuilder box_file(const std::vector<std::uint16_t>& corners = box_corners()) {
  GltfBuilder builder;
  builder.add("materials", {{"name", "skin"}, {"doubleSided", true}});
  builder.add_mesh(box_primitive(builder, corners));
  return builder;
}

inline std::vector<std::byte> encoded(const Scene& scene) {
  Diagnostics diagnostics;
  const auto files = encode_gltf(scene, "out.glb", diagnostics);
  if (!files) throw std::runtime_error(to_text(diagnostics));
  return (*files)[0].bytes;
}

inline Scene decoded(const std::vector<std::byte>& file) {
  Diagnostics diagnostics;
  auto scene = read_gltf(file, "box.glb", "", diagnostics);
  if (!scene) throw std::runtime_error(to_text(diagnostics));
  return *std::move(scene);
}

inline Result with_fewer_sides(const Scene& scene, const Executor& executor = Executor(2),
                               const std::atomic<bool>* cancel = nullptr) {
  Diagnostics diagnostics;
  Registry registry;
  add_built_in_plugins(registry);
  const auto pipeline = load_pipeline("sides(most-added=1)", diagnostics);
  const auto plan = pipeline ? foredraw::plan(*pipeline, registry, scene, diagnostics) : std::nullopt;
  if (!plan) throw std::runtime_error(to_text(diagnostics));
  Analyses analyses;
  return optimize(*plan, scene, {executor, analyses, cancel});
}

/// Whether the file comes out otherwise than it would without the stage.
inline bool changes(const GltfBuilder& builder) {
  const Scene scene = decoded(builder.glb());
  return encoded(with_fewer_sides(scene).scene) != encoded(scene);
}

}  // namespace foredraw::testing

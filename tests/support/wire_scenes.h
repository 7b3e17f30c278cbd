#pragma once
// Scenes with wires, as they go through stages and files.

#include "benchmarks/wire_radius/wire_sets.h"
#include "plugins/processors/wire_radius/wires_product.h"
#include "support/gltf_builder.h"
#include "support/staged.h"

#include <foredraw/io/gltf/gltf.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace foredraw::testing {

inline bench::KnownMesh made_wire(const std::string& name) {
  for (bench::KnownMesh& mesh : bench::made_meshes(201)) {
    if (mesh.name == name) return std::move(mesh);
  }
  throw std::invalid_argument(name);
}

inline std::vector<float> floats_of(const bench::KnownMesh& mesh) {
  std::vector<float> values;
  for (const glm::vec3& at : mesh.positions) values.insert(values.end(), {at.x, at.y, at.z});
  return values;
}

/// With a floor below the body.
inline bench::KnownMesh closed_antenna() {
  bench::KnownMesh mesh = made_wire("antenna on a body");
  const auto n = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.indices.insert(mesh.indices.end(), {n - 4, n - 2, n - 3, n - 4, n - 1, n - 2});
  return mesh;
}

/// The meshes in one draw, its triangles in this sequence: first a triangle of each, then the next of each.
inline GltfBuilder mixed(const std::vector<std::string>& names) {
  std::vector<float> positions;
  std::vector<std::vector<std::uint32_t>> parts;
  for (const std::string& name : names) {
    const bench::KnownMesh mesh = name == "closed antenna" ? closed_antenna() : made_wire(name);
    parts.push_back(mesh.indices);
    for (std::uint32_t& index : parts.back()) index += static_cast<std::uint32_t>(positions.size() / 3);
    const std::vector<float> values = floats_of(mesh);
    positions.insert(positions.end(), values.begin(), values.end());
  }
  std::vector<std::uint32_t> indices;
  for (std::size_t t = 0; indices.size() < 3'000'000; t += 3) {
    const std::size_t before = indices.size();
    for (const auto& part : parts) {
      if (t < part.size())
        indices.insert(indices.end(), part.begin() + static_cast<std::ptrdiff_t>(t),
                       part.begin() + static_cast<std::ptrdiff_t>(t) + 3);
    }
    if (indices.size() == before) break;
  }
  GltfBuilder builder;
  const std::size_t at = builder.add_values(positions, "VEC3");
  builder.json["accessors"][at]["min"] = {-100, -100, -100};
  builder.json["accessors"][at]["max"] = {100, 100, 100};
  builder.add_mesh({{"attributes", {{"POSITION", at}}}, {"indices", builder.add_values(indices, "SCALAR")}});
  return builder;
}

inline std::optional<Scene> read_with_wires(const std::vector<std::byte>& file, Diagnostics& diagnostics) {
  return read_gltf(file, "scene.glb", {}, diagnostics, {.products = {wires_product()}});
}

inline Scene scene_of_file(const GltfBuilder& builder) {
  Diagnostics diagnostics;
  auto scene = read_with_wires(builder.glb(), diagnostics);
  if (!scene) throw std::runtime_error(to_text(diagnostics));
  return std::move(*scene);
}

inline std::vector<std::byte> written_with_wires(const Scene& scene) {
  Diagnostics diagnostics;
  const auto files = encode_gltf(scene, "out.glb", diagnostics, {.products = {wires_product()}});
  if (!files || diagnostics.has_errors()) throw std::runtime_error(to_text(diagnostics));
  return files->front().bytes;
}

/// A rope, a lamp post and a body, triangle by triangle in turn.
inline const Scene& scene_of_three() {
  static const Scene scene = scene_of_file(mixed({"flat rope", "lamp post", "egg"}));
  return scene;
}

inline const Scene& with_wires() {
  static const Scene scene = run("wire-radius", scene_of_three()).scene;
  return scene;
}

/// All triangles by their corners' positions, in order.
inline std::vector<std::array<float, 9>> triangles_of(const Scene& scene, std::size_t first = 0) {
  const Level& level = scene.draws[0].full();
  const std::vector<glm::vec3> positions = decode_vec3(*level.vertices->find("POSITION"));
  std::vector<std::array<float, 9>> all;
  const auto indices = level.stream().indices.view();
  for (std::size_t t = 3 * first; t < indices.size(); t += 3) {
    std::array<float, 9> triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      for (int axis = 0; axis < 3; ++axis)
        triangle[3 * i + static_cast<std::size_t>(axis)] = positions[indices[t + i]][axis];
    }
    all.push_back(triangle);
  }
  std::ranges::sort(all);
  return all;
}

}  // namespace foredraw::testing

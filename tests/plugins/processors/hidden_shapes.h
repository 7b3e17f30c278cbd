#pragma once
// Shapes in shapes: scenes of which it is known what is hidden.

#include "support/meshes.h"

#include <foredraw/image/found_traits.h>

#include <utility>

namespace foredraw::testing {

/// Outwards: a box has 12 triangles, an open one (without its top at +Z) 10.
inline TestMesh box(float size = 1, glm::vec3 centre = glm::vec3(0), bool is_open = false) {
  TestMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.positions.push_back(centre + size * glm::vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
  }
  mesh.indices = {0, 2, 1, 1, 2, 3, 0, 1, 4, 1, 5, 4, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5, 2, 6, 3, 3, 6, 7};
  if (!is_open) mesh.indices.insert(mesh.indices.end(), {4, 5, 6, 5, 7, 6});
  return mesh;
}

inline TestMesh turned(TestMesh mesh) {
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
  return mesh;
}

/// A ball around the origin, outwards, with a hole of this radius in its side at +X.
inline TestMesh ball_with_hole(float hole) {
  TestMesh ball = sphere(64, 33);
  std::vector<std::uint32_t> indices;
  TestMesh rim;
  for (std::size_t i = 0; i < ball.indices.size(); i += 3) {
    // One triangle near +X gives way to a ring of three around a smaller one.
    const glm::vec3 a = ball.positions[ball.indices[i]], b = ball.positions[ball.indices[i + 1]],
                    c = ball.positions[ball.indices[i + 2]];
    const glm::vec3 middle = (a + b + c) / 3.f;
    if (!rim.positions.empty() || middle.x < 0.99f) {
      indices.insert(indices.end(), ball.indices.begin() + static_cast<std::ptrdiff_t>(i),
                     ball.indices.begin() + static_cast<std::ptrdiff_t>(i) + 3);
      continue;
    }
    const auto in = [&](const glm::vec3& p) { return middle + (p - middle) * (hole / 0.05f); };
    rim.positions = {a, b, c, in(a), in(b), in(c)};
    rim.indices = {0, 1, 3, 1, 4, 3, 1, 2, 4, 2, 5, 4, 2, 0, 5, 0, 3, 5};
  }
  ball.indices = std::move(indices);
  return joined(ball, rim);
}

/// One mesh that holds all the draws, so that they hide each other; all with material 0.
inline Scene one_mesh(std::vector<TestMesh> meshes) {
  std::vector<Draw> draws;
  for (const TestMesh& mesh : meshes) {
    draws.push_back(draw_of(mesh, "draw" + std::to_string(draws.size())));
    draws.back().material = 0;
  }
  Scene scene = scene_of(std::move(draws));
  scene.meshes.resize(1);
  scene.nodes.resize(1);
  for (DrawId id = 1; id < scene.draws.size(); ++id) scene.meshes[0].draws.push_back(id);
  scene.materials.resize(1);
  find_traits(scene);
  return scene;
}

}  // namespace foredraw::testing

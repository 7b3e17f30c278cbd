#pragma once
// Scenes of small meshes placed often.

#include <foredraw/scene/scene.h>

#include <glm/gtc/matrix_transform.hpp>

#include <vector>

#include "support/meshes.h"

namespace foredraw::testing {

/// A scene of meshes, each placed at transforms.
struct Placements {
  TestMesh mesh;
  std::vector<glm::mat4> at;
};

inline Scene scene_with(const std::vector<Placements>& placements) {
  std::vector<Draw> draws;
  for (std::size_t i = 0; i < placements.size(); ++i) {
    draws.push_back(draw_of(placements[i].mesh, "mesh" + std::to_string(i)));
  }
  Scene scene = scene_of(std::move(draws));
  scene.nodes.clear();
  for (MeshId m = 0; m < placements.size(); ++m) {
    for (const glm::mat4& world : placements[m].at) {
      Node node;
      node.matrix = world;
      node.mesh = m;
      scene.nodes.push_back(node);
    }
  }
  return scene;
}

inline glm::mat4 random_transform(Random& random, bool may_mirror = true) {
  const auto unit = [&] { return static_cast<float>(random.unit()); };
  glm::mat4 world = glm::translate(glm::mat4(1), {100 * unit(), 10 * unit(), 100 * unit()});
  const glm::vec3 axis{unit() + 0.1f, unit(), unit()};
  world = glm::rotate(world, 6 * unit(), glm::normalize(axis));
  glm::vec3 scale{0.5f + unit(), 0.5f + unit(), 0.5f + unit()};
  if (may_mirror && random.below(3) == 0) scale[static_cast<int>(random.below(3))] *= -1;
  return glm::scale(world, scale);
}

inline std::vector<DrawId> all_draws(const Scene& scene) {
  std::vector<DrawId> draws;
  for (DrawId id = 0; id < scene.draws.size(); ++id) draws.push_back(id);
  return draws;
}

inline std::vector<Placements> random_placements(std::uint64_t seed, std::size_t meshes, std::size_t instances) {
  Random random(seed);
  std::vector<Placements> placements;
  for (std::size_t m = 0; m < meshes; ++m) {
    placements.push_back({soup(static_cast<std::uint32_t>(1 + random.below(90)), seed + m), {}});
    for (std::size_t i = 0; i < instances; ++i) placements.back().at.push_back(random_transform(random));
  }
  return placements;
}

}  // namespace foredraw::testing

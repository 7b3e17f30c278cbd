#include "gpu_instancing.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <cmath>
#include <map>
#include <stdexcept>

namespace foredraw::bench {

namespace {

Transform parts_of(const glm::mat4& matrix) {
  glm::dmat3 axes(matrix);
  glm::dvec3 scale(glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2]));
  if (glm::determinant(axes) < 0) scale.x = -scale.x;
  for (int i = 0; i < 3; ++i) axes[i] /= scale[i];
  const Transform parts{glm::vec3(matrix[3]), glm::quat(glm::normalize(glm::quat_cast(axes))), glm::vec3(scale)};
  const glm::mat4 again = parts.matrix();
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      if (!(std::abs(again[column][row] - matrix[column][row]) < 1e-4f)) {
        throw std::runtime_error("a placement is not made of translation, rotation and scale");
      }
    }
  }
  return parts;
}

}  // namespace

Scene with_gpu_instancing(const Scene& scene, std::size_t kept) {
  const std::vector<glm::mat4> worlds = world_transforms(scene);
  std::map<MeshId, std::size_t> number;
  std::vector<std::vector<Transform>> placements;
  Scene made = scene;
  made.nodes.resize(kept);
  for (auto i = static_cast<NodeId>(kept); i < scene.nodes.size(); ++i) {
    if (!scene.nodes[i].mesh) continue;
    const auto [known, is_new] = number.try_emplace(*scene.nodes[i].mesh, placements.size());
    if (is_new) {
      placements.emplace_back();
      made.nodes.emplace_back().mesh = *scene.nodes[i].mesh;
    }
    placements[known->second].push_back(parts_of(worlds[i]));
  }
  for (std::size_t i = 0; i < placements.size(); ++i) {
    made.nodes[kept + i].instances = Shared<Transform>(std::move(placements[i]));
  }
  return made;
}

}  // namespace foredraw::bench

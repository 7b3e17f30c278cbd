#include <foredraw/viewing/stretch.h>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace foredraw {

namespace {

/// The largest sum of a row of the squared matrix bounds its largest eigenvalue (Gershgorin 1931).
double stretch_of(const glm::dmat3& by) {
  const glm::dmat3 squared = glm::transpose(by) * by;
  double most = 0;
  for (int row = 0; row < 3; ++row) {
    most = std::max(most, std::abs(squared[row].x) + std::abs(squared[row].y) + std::abs(squared[row].z));
  }
  return std::sqrt(most);
}

}  // namespace

double most_stretch(const Scene& scene, const SubjectPart& part, const PosedNodes& nodes) {
  if (!part.node) return 1;
  const Node& node = scene.nodes[*part.node];
  if (!node.skin) return stretch_of(glm::dmat3(nodes.world[*part.node]));
  const Skin& skin = scene.skins[*node.skin];
  double most = 0;
  for (std::size_t i = 0; i < skin.joints.size(); ++i) {
    const glm::dmat3 from_bind(i < skin.inverse_bind_matrices.size() ? skin.inverse_bind_matrices[i] : glm::mat4(1));
    most = std::max(most, stretch_of(glm::dmat3(nodes.world[skin.joints[i]]) * from_bind));
  }
  return most;
}

}  // namespace foredraw

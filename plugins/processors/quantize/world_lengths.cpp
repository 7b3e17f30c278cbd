#include "world_lengths.h"

#include <foredraw/analysis/diagonal.h>
#include <foredraw/scene/walk.h>

#include <algorithm>
#include <cmath>

namespace foredraw {

namespace {

/// The longest of what becomes of the three axes.
double stretch_of(const glm::dmat4& matrix) {
  double longest = 0;
  for (int c = 0; c < 3; ++c) {
    const glm::dvec4& axis = matrix[c];
    longest = std::max(longest, axis.x * axis.x + axis.y * axis.y + axis.z * axis.z);
  }
  return std::sqrt(longest);
}

double largest_component(const glm::vec3& scale) {
  return std::max({std::abs(double{scale.x}), std::abs(double{scale.y}), std::abs(double{scale.z})});
}

/// [node] by how much it may stretch what is below it.
std::vector<double> longest_stretches(const Scene& scene) {
  std::vector<double> stretches;
  for (const Node& node : scene.nodes) {
    stretches.push_back(node.matrix ? stretch_of(*node.matrix) : largest_component(node.transform.scale));
  }
  for (const Animation& animation : scene.animations) {
    for (const AnimationChannel& channel : animation.channels) {
      if (channel.path != AnimatedPath::scale || channel.node >= stretches.size()) continue;
      for (const float scale : channel.values.view())
        stretches[channel.node] = std::max(stretches[channel.node], std::abs(double{scale}));
    }
  }
  return stretches;
}

}  // namespace

double longest_diagonal(const Scene& scene, const std::vector<DrawId>& draws, Analyses& analyses) {
  const std::vector<glm::mat4> worlds = world_transforms(scene);
  double longest = 0;
  for (NodeId n = 0; n < scene.nodes.size(); ++n) {
    const Node& node = scene.nodes[n];
    if (!node.mesh) continue;
    double stretch = stretch_of(worlds[n]);
    if (node.skin && !scene.skins[*node.skin].joints.empty()) {
      const Skin& skin = scene.skins[*node.skin];
      stretch = stretch_of(glm::dmat4(worlds[skin.joints.front()]) * glm::dmat4(skin.inverse_bind_matrices.front()));
    }
    for (const DrawId id : scene.meshes[*node.mesh].draws) {
      if (!std::ranges::binary_search(draws, id)) continue;
      const auto positions = positions_of(analyses, *scene.draws[id].full().vertices);
      longest = std::max(longest, stretch * diagonal_of(positions->values));
    }
  }
  return longest;
}

std::vector<double> longest_units(const Scene& scene) {
  const std::vector<double> stretches = longest_stretches(scene);
  std::vector<double> units(scene.nodes.size(), 1);
  for (const NodeId n : walk(scene)) {
    for (const NodeId child : scene.nodes[n].children) units[child] = units[n] * stretches[n];
  }
  return units;
}

}  // namespace foredraw

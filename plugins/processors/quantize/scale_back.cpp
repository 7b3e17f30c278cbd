#include "scale_back.h"

#include <foredraw/base/content_hash.h>
#include <foredraw/scene/own_material.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace foredraw {

namespace {

/// What comes last moves points by the transform's own scale and rotation.
Transform before(const Transform& place, const PositionGrid& grid) {
  const glm::dvec3 moved =
      glm::dmat3(glm::mat3_cast(glm::dquat(place.rotation))) * (glm::dvec3(place.scale) * glm::dvec3(grid.offset()));
  return {glm::vec3(glm::dvec3(place.translation) + moved), place.rotation,
          glm::vec3(glm::dvec3(place.scale) * grid.step)};
}

glm::mat4 before(const glm::mat4& place, const PositionGrid& grid) {
  const glm::dmat4 back = glm::scale(glm::translate(glm::dmat4(1), glm::dvec3(grid.offset())), glm::dvec3(grid.step));
  return glm::mat4(glm::dmat4(place) * back);
}

Shared<Transform> before(const Shared<Transform>& instances, const PositionGrid& grid) {
  std::vector<Transform> placed;
  for (const Transform& instance : instances.view()) placed.push_back(before(instance, grid));
  return Shared<Transform>(std::move(placed));
}

class ScalingBack {
 public:
  ScalingBack(Scene& scene, const std::vector<std::optional<PositionGrid>>& grids) : scene_(scene), grids_(grids) {}

  std::vector<NodeId> run() {
    find_pivots();
    const auto count = static_cast<NodeId>(scene_.nodes.size());
    std::vector<NodeId> drawn_by(count);
    std::iota(drawn_by.begin(), drawn_by.end(), NodeId{0});
    for (NodeId n = 0; n < count; ++n) {
      const PositionGrid* grid = grid_of(scene_.nodes[n]);
      if (grid != nullptr) drawn_by[n] = place(n, *grid);
    }
    materials();
    return drawn_by;
  }

 private:
  const PositionGrid* grid_of(const Node& node) const {
    if (!node.mesh || scene_.meshes[*node.mesh].draws.empty()) return nullptr;
    const auto& grid = grids_[scene_.meshes[*node.mesh].draws.front()];
    return grid ? &*grid : nullptr;
  }

  /// Nodes whose own place counts for something else than their mesh.
  void find_pivots() {
    for (const Node& node : scene_.nodes) {
      is_pivot_.push_back(!node.name.empty() || !node.children.empty() || node.has_camera);
    }
    for (const Skin& skin : scene_.skins) {
      for (const NodeId joint : skin.joints) is_pivot_[joint] = true;
    }
    for (const Animation& animation : scene_.animations) {
      for (const AnimationChannel& channel : animation.channels) {
        if (channel.path != AnimatedPath::weights) is_pivot_[channel.node] = true;
      }
    }
  }

  NodeId place(NodeId n, const PositionGrid& grid) {
    Node& node = scene_.nodes[n];
    if (node.skin) {
      skin(*node.skin, grid);
    } else if (!node.instances.empty()) {
      node.instances = before(node.instances, grid);
    } else if (is_pivot_[n]) {
      return below(n, grid);
    } else if (node.matrix) {
      node.matrix = before(*node.matrix, grid);
    } else {
      node.transform = before(node.transform, grid);
    }
    return n;
  }

  /// Where a skin moves a mesh, its node does not.
  void skin(SkinId id, const PositionGrid& grid) {
    if (!skins_done_.insert(id).second) return;
    for (glm::mat4& matrix : scene_.skins[id].inverse_bind_matrices) matrix = before(matrix, grid);
  }

  NodeId below(NodeId n, const PositionGrid& grid) {
    const auto id = static_cast<NodeId>(scene_.nodes.size());
    Node child;
    child.transform = before(Transform{}, grid);
    child.is_shown = scene_.nodes[n].is_shown;
    std::swap(child.mesh, scene_.nodes[n].mesh);
    std::swap(child.weights, scene_.nodes[n].weights);
    scene_.nodes[n].children.insert(scene_.nodes[n].children.begin(), id);
    scene_.nodes.push_back(std::move(child));
    for (Animation& animation : scene_.animations) {
      for (AnimationChannel& channel : animation.channels) {
        if (channel.node == n && channel.path == AnimatedPath::weights) channel.node = id;
      }
    }
    return id;
  }

  void materials() {
    std::map<std::pair<MaterialId, double>, std::vector<DrawId>> users;  // by the step of their draws
    for (DrawId id = 0; id < scene_.draws.size(); ++id) {
      const Material* material = scene_.material_of(scene_.draws[id]);
      if (grids_[id] && material != nullptr && (material->thickness || material->displacement))
        users[{*scene_.draws[id].material, grids_[id]->step}].push_back(id);
    }
    for (const auto& [of, draws] : users) {
      scale(scene_.materials[own_material(scene_, of.first, draws)], 1 / of.second);
    }
  }

  static void scale(Material& material, double by) {
    if (material.thickness) material.thickness = static_cast<float>(double{*material.thickness} * by);
    if (material.displacement) {
      material.displacement->factor = static_cast<float>(double{material.displacement->factor} * by);
      material.displacement->offset = static_cast<float>(double{material.displacement->offset} * by);
    }
    change_look(material, content_hash(std::span<const double>(&by, 1)));
  }

  Scene& scene_;
  const std::vector<std::optional<PositionGrid>>& grids_;
  std::vector<bool> is_pivot_;
  std::set<SkinId> skins_done_;
};

}  // namespace

std::vector<NodeId> scale_back(Scene& scene, const std::vector<std::optional<PositionGrid>>& grids) {
  return ScalingBack(scene, grids).run();
}

}  // namespace foredraw

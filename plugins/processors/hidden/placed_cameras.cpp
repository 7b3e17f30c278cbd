#include "placed_cameras.h"

#include <foredraw/analysis/moved_nodes.h>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

namespace foredraw::processors::hidden {

namespace {

const glm::dvec3 up(0, 1, 0);

/// Every transform that the mesh is shown by.
std::vector<glm::dmat4> placements(const Scene& scene, MeshId mesh) {
  const std::vector<glm::mat4> world = world_transforms(scene);
  std::vector<glm::dmat4> result;
  for (NodeId n = 0; n < scene.nodes.size(); ++n) {
    if (scene.nodes[n].mesh != mesh) continue;
    const glm::dmat4 by_node(world[n]);
    for (const Transform& instance : scene.nodes[n].instances.view()) {
      result.push_back(by_node * glm::dmat4(instance.matrix()));
    }
    if (scene.nodes[n].instances.empty()) result.push_back(by_node);
  }
  return result;
}

}  // namespace

Cameras cameras_beside(const SceneCameras& cameras) {
  if (cameras.seen_from == SeenFrom::outside) return {};
  if (cameras.seen_from == SeenFrom::above) return {{up}, {}};
  return {{}, cameras.boxes};
}

std::optional<Cameras> cameras_beside_moving(const SceneCameras& cameras) {
  return cameras.are_outside() ? std::optional(Cameras{}) : std::nullopt;
}

std::optional<Cameras> cameras_beside_mesh(const SceneCameras& cameras, const Scene& scene, MeshId mesh) {
  if (cameras.seen_from == SeenFrom::outside) return Cameras{};
  const std::vector<bool> moved = moved_nodes(scene);
  for (NodeId n = 0; n < scene.nodes.size(); ++n) {
    if (scene.nodes[n].mesh == mesh && moved[n]) return cameras_beside_moving(cameras);
  }
  const std::vector<glm::dmat4> all = placements(scene, mesh);
  if (all.empty()) return cameras_beside(cameras);
  Cameras result;
  for (const glm::dmat4& placement : all) {
    const double volume = glm::determinant(glm::dmat3(placement));
    if (!std::isfinite(volume) || volume == 0) return cameras_beside_moving(cameras);
    if (cameras.seen_from == SeenFrom::above) {
      const glm::dvec3 own_up = glm::transpose(glm::dmat3(placement)) * up;
      if (std::ranges::find(result.ups, own_up) == result.ups.end()) result.ups.push_back(own_up);
    }
    for (const glm::dmat4& box : cameras.boxes) result.boxes.push_back(glm::inverse(placement) * box);
  }
  return result;
}

std::optional<std::vector<glm::dvec3>> points_in(const std::string& text) {
  std::vector<glm::dvec3> points;
  std::istringstream all(text);
  for (std::string one; std::getline(all, one, ';');) {
    std::istringstream numbers(one);
    numbers.imbue(std::locale::classic());
    glm::dvec3 point;
    if (!(numbers >> point.x >> point.y >> point.z) || !(numbers >> std::ws).eof()) return std::nullopt;
    if (!std::isfinite(point.x + point.y + point.z)) return std::nullopt;
    points.push_back(point);
  }
  return points.empty() ? std::nullopt : std::optional(points);
}

}  // namespace foredraw::processors::hidden

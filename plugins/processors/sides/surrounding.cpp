#include "surrounding.h"

#include <foredraw/analysis/ray_tree.h>
#include <foredraw/viewing/posed_positions.h>
#include <foredraw/viewing/subject_geometry.h>
#include <foredraw/viewing/view_directions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace foredraw::processors::sides {

namespace {

struct Extent {
  glm::dvec3 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};

  void add(const glm::dvec3& point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  glm::dvec3 centre() const { return (low + high) / 2.0; }
  double size() const { return std::max({high.x - low.x, high.y - low.y, high.z - low.z}); }
};

/// Where somebody may look around.
struct Standpoint {
  glm::dvec3 at;
  double size = 0;                     ///< of what stands there; 0 for a camera
  std::optional<std::size_t> subject;  ///< that it is the centre of
};

struct PlacedScene {
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;
  std::vector<Blocks> blocks;
  std::vector<DrawId> draws;  ///< [triangle]
  std::vector<double> sizes;  ///< [triangle] of its draw, as its node shows it
  std::vector<Standpoint> standpoints;
};

/// [draw] a subject that it is in.
std::vector<std::size_t> subject_of_draws(const Scene& scene) {
  std::vector<std::size_t> result(scene.draws.size(), 0);
  const std::vector<Subject> subjects = subjects_of(scene);
  for (std::size_t s = 0; s < subjects.size(); ++s) {
    for (const SubjectPart& part : subjects[s].parts) result[part.draw] = s;
  }
  return result;
}

/// Adds a draw as a node shows it; its extent.
Extent add_placed(const Scene& scene, const SubjectPart& part, const PosedNodes& nodes, PlacedScene& placed) {
  const Draw& draw = scene.draws[part.draw];
  const std::vector<glm::vec3> positions = posed_positions(scene, part, nodes);
  Extent extent;
  if (positions.empty() || draw.topology != Topology::triangles || is_blended(scene, draw)) return extent;
  const auto base = static_cast<std::uint32_t>(placed.positions.size());
  const bool is_turned = is_mirrored(part, nodes);
  const auto indices = draw.full().stream().indices.view();
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    for (const std::size_t c : {0, is_turned ? 2 : 1, is_turned ? 1 : 2}) {
      placed.indices.push_back(base + indices[i + c]);
      extent.add(glm::dvec3(positions[indices[i + c]]));
    }
  }
  placed.positions.insert(placed.positions.end(), positions.begin(), positions.end());
  const Material* material = scene.material_of(draw);
  placed.blocks.resize(placed.indices.size() / 3,
                       material != nullptr && material->double_sided ? Blocks::both : Blocks::front);
  placed.draws.resize(placed.blocks.size(), part.draw);
  placed.sizes.resize(placed.blocks.size(), extent.size());
  return extent;
}

/// An instanced mesh is there once, as its node stands.
PlacedScene placed_scene(const Scene& scene) {
  PlacedScene placed;
  const PosedNodes nodes = posed_nodes(scene);
  const std::vector<std::size_t> subjects = subject_of_draws(scene);
  for (NodeId n = 0; n < scene.nodes.size(); ++n) {
    const Node& node = scene.nodes[n];
    if (!node.is_shown) continue;
    if (node.has_camera) placed.standpoints.push_back({glm::dvec3(nodes.world[n][3]), 0, std::nullopt});
    if (!node.mesh) continue;
    for (const DrawId id : scene.meshes[*node.mesh].draws) {
      const Extent extent = add_placed(scene, {id, n}, nodes, placed);
      if (std::isfinite(extent.size())) placed.standpoints.push_back({extent.centre(), extent.size(), subjects[id]});
    }
  }
  return placed;
}

}  // namespace

std::vector<bool> surrounding_draws(const Scene& scene, const Executor& executor) {
  constexpr std::size_t most_standpoints = 1024;  // of more some are asked, evenly spread over the list
  std::vector<bool> result(scene.draws.size(), false);
  const PlacedScene placed = placed_scene(scene);
  const std::vector<std::size_t> subjects = subject_of_draws(scene);
  const RayTree tree(placed.positions, placed.indices, placed.blocks);
  const Directions directions = fibonacci_directions(64);
  const std::size_t step =
      std::max<std::size_t>(1, (placed.standpoints.size() + most_standpoints - 1) / most_standpoints);
  std::vector<std::vector<DrawId>> around((placed.standpoints.size() + step - 1) / step);
  executor.for_each(around.size(), [&](std::size_t i) {
    const Standpoint& standpoint = placed.standpoints[i * step];
    std::map<DrawId, std::size_t> backs;  // how many rays hit them first
    for (const glm::dvec3& direction : directions) {
      RayTree::Ray ray{standpoint.at, direction};
      auto hit = tree.first(ray);
      for (; hit && subjects[placed.draws[hit->triangle]] == standpoint.subject; hit = tree.first(ray)) {
        ray.nearest = hit->way;  // out of what stands there itself
      }
      if (!hit || hit->at_front || placed.sizes[hit->triangle] < 2 * standpoint.size) continue;
      ++backs[placed.draws[hit->triangle]];
    }
    for (const auto& [draw, hits] : backs) {
      if (2 * hits >= directions.size()) around[i].push_back(draw);
    }
  });
  for (const auto& draws : around) {
    for (const DrawId draw : draws) result[draw] = true;
  }
  return result;
}

}  // namespace foredraw::processors::sides

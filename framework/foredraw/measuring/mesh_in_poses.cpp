#include <foredraw/measuring/mesh_in_poses.h>

#include <foredraw/geometry/finite.h>
#include <foredraw/geometry/triangle_area.h>
#include <foredraw/scene/subject.h>
#include <foredraw/viewing/posed_positions.h>

#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>

namespace foredraw {

namespace {

/// Those at the middles of as many equal parts of all weights. A pose that lies in several parts counts for each.
Poses spread(const Poses& poses, std::size_t most) {
  double all = 0, passed = 0;
  for (const Pose& pose : poses.poses) all += pose.weight;
  Poses chosen;
  chosen.poses.clear();
  for (const Pose& pose : poses.poses) {
    const auto parts_before = [&](double weight) { return std::ceil(weight / all * static_cast<double>(most) - 0.5); };
    const double parts = parts_before(passed + pose.weight) - parts_before(passed);
    passed += pose.weight;
    if (parts > 0) chosen.poses.push_back({pose.clip, pose.time, parts});
  }
  return chosen;
}

/// In one pose: maps[vertex * stride].
void put_maps(const MeshInScene& of, NodeId node, const PosedNodes& nodes, std::size_t stride, glm::dmat4x3* maps) {
  std::vector<bool> is_done(of.mesh.streams.size(), false);
  for (std::size_t d = 0; d < of.draws.size(); ++d) {
    const std::uint32_t stream = of.mesh.stream_of[d];
    if (is_done[stream]) continue;
    is_done[stream] = true;
    const std::vector<glm::dmat4x3> made = vertex_maps(of.scene, {of.draws[d], node}, nodes);
    for (std::size_t v = 0; v < made.size(); ++v) maps[(of.mesh.first_vertex[stream] + v) * stride] = made[v];
  }
}

template <class PlaceOf>
double area(std::span<const std::uint32_t> indices, const PlaceOf& place_of) {
  double sum = 0;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    sum += triangle_area(place_of(indices[i]), place_of(indices[i + 1]), place_of(indices[i + 2]));
  }
  return sum;
}

}  // namespace

PosedVertices mesh_in_poses(const MeshInScene& of, const Poses& poses, std::size_t most) {
  const bool is_bent =
      std::ranges::any_of(of.draws, [&](DrawId id) { return of.scene.draws[id].traits.has(traits::animated); });
  const bool is_moved = std::ranges::any_of(poses.poses, [](const Pose& pose) { return pose.clip.has_value(); });
  const auto part = is_bent && is_moved ? shown_part(of.scene, of.draws.front()) : std::nullopt;
  if (!part || most == 0) return {};
  const Poses chosen = spread(poses, most);
  const std::size_t count = chosen.poses.size();
  PosedVertices posed{{}, std::vector<glm::dmat4x3>(of.mesh.positions.size() * count)};
  double areas = 0;
  for (std::size_t i = 0; i < count; ++i) {
    posed.weights.push_back(chosen.poses[i].weight / static_cast<double>(most));
    put_maps(of, *part->node, posed_nodes(of.scene, chosen.poses[i]), count, posed.maps.data() + i);
    areas += posed.weights[i] * area(of.mesh.indices, [&](std::uint32_t v) {
               return posed.maps[v * count + i] * glm::dvec4(of.mesh.positions[v], 1);
             });
  }
  const double at_rest = area(of.mesh.indices, [&](std::uint32_t v) { return glm::dvec3(of.mesh.positions[v]); });
  const double scale = std::sqrt(at_rest / areas);
  if (!(scale > 0)) return {};
  for (glm::dmat4x3& map : posed.maps) map *= scale;
  return std::ranges::all_of(posed.maps, [](const glm::dmat4x3& map) { return is_finite(map); }) ? posed
                                                                                                 : PosedVertices{};
}

}  // namespace foredraw

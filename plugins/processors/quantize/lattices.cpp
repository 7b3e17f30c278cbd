#include "lattices.h"

#include <foredraw/analysis/diagonal.h>
#include <foredraw/geometry/finite.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <utility>

namespace foredraw {

namespace {

/// The largest side of the box.
double side_of(std::span<const glm::vec3> positions) {
  glm::vec3 least(std::numeric_limits<float>::infinity()), most(-least);
  for (const glm::vec3& position : positions) {
    if (!is_finite(position)) continue;
    least = glm::min(least, position);
    most = glm::max(most, position);
  }
  const glm::dvec3 sides = glm::dvec3(most) - glm::dvec3(least);
  return std::max({sides.x, sides.y, sides.z, 0.0});
}

}  // namespace

double grid_step(double distance, int dimensions) {
  const double most = 2 * distance / std::sqrt(static_cast<double>(dimensions));
  const double unit = std::ldexp(1.0, std::ilogb(most) + 1 - step_bits);
  return std::floor(most / unit) * unit;
}

void join_placed_together(const Scene& scene, JoinedSets& sets) {
  for (const Mesh& mesh : scene.meshes) {
    for (const DrawId id : mesh.draws) sets.join(mesh.draws.front(), id);
  }
  std::map<SkinId, DrawId> of_skin;
  for (const Node& node : scene.nodes) {
    if (!node.mesh || !node.skin || scene.meshes[*node.mesh].draws.empty()) continue;
    const DrawId draw = scene.meshes[*node.mesh].draws.front();
    sets.join(of_skin.try_emplace(*node.skin, draw).first->second, draw);
  }
}

Lattices lattices_of(const Scene& scene, const std::vector<DrawId>& draws, const std::vector<VertexGroup>& groups,
                     const std::vector<Meeting>& meetings, SubjectUnit unit, const PositionTolerance& tolerance,
                     Analyses& analyses) {
  JoinedSets sets(scene.draws.size());
  const std::vector<Subject> subjects = subjects_of(scene, unit);
  for (const Subject& subject : subjects) {
    for (const SubjectPart& other : subject.parts) sets.join(subject.parts.front().draw, other.draw);
  }
  std::vector<double> sizes(scene.draws.size());  // of a subject: the largest of its draws
  for (const DrawId id : draws) {
    const auto positions = positions_of(analyses, *scene.draws[id].full().vertices);
    double& size = sizes[sets.of(id)];
    size = std::max(size, tolerance.of_side ? side_of(positions->values) : diagonal_of(positions->values));
  }
  std::vector<double> tolerances(scene.draws.size());
  for (const DrawId id : draws) tolerances[id] = tolerance.part * sizes[sets.of(id)];
  for (const VertexGroup& group : groups) {
    for (const VertexGroup::User& user : group.users) sets.join(group.users.front().draw, user.draw);
  }
  join_placed_together(scene, sets);
  for (const Meeting& meeting : meetings) sets.join(meeting.at.draw, meeting.with.draw);
  std::vector<double> least(scene.draws.size());
  for (const DrawId id : draws) {
    double& one = least[sets.of(id)];
    if (one == 0 || (tolerances[id] > 0 && tolerances[id] < one)) one = tolerances[id];
  }
  for (const DrawId id : draws) tolerances[id] = least[sets.of(id)];
  return {std::move(sets), std::move(tolerances)};
}

}  // namespace foredraw

#include "packed_boxes.h"

#include <foredraw/geometry/finite.h>
#include <foredraw/geometry/joined_sets.h>
#include <foredraw/scene/levels.h>
#include <foredraw/viewing/posed_positions.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace foredraw::processors::vertex_pack {

namespace {

void add_finite(Box<glm::dvec3>& box, const glm::dvec3& point) {
  if (foredraw::is_finite(point)) box.add(point);
}

/// Levels that have vertices of their own, as scenes of one level.
std::vector<Scene> levels_of(const Scene& scene) {
  std::vector<Scene> levels;
  for (std::size_t level = 0; level < most_levels(scene); ++level) levels.push_back(at_level(scene, level));
  return levels;
}

bool repeats_level(const Draw& draw, std::size_t level) {
  return level >= draw.levels.size() || (level > 0 && draw.levels[level].vertices == draw.levels[level - 1].vertices);
}

/// Where morph targets may bring each vertex, with weights from 0 to 1. Empty where there are none.
std::vector<Box<glm::dvec3>> morphed_places(const VertexStreams& vertices) {
  const VertexStream* positions = vertices.find("POSITION");
  std::vector<Box<glm::dvec3>> places;
  if (positions == nullptr || vertices.morph_targets.empty()) return places;
  for (const glm::vec3& stored : decode_vec3(*positions)) places.push_back({stored, stored});
  for (const std::vector<VertexStream>& target : vertices.morph_targets) {
    for (const VertexStream& stream : target) {
      if (stream.semantic != "POSITION") continue;
      const std::vector<glm::vec3> offsets = decode_vec3(stream);
      for (std::size_t v = 0; v < std::min(places.size(), offsets.size()); ++v) {
        places[v].min += glm::min(glm::dvec3(offsets[v]), glm::dvec3(0));
        places[v].max += glm::max(glm::dvec3(offsets[v]), glm::dvec3(0));
      }
    }
  }
  return places;
}

/// The box's box behind the map.
void add_moved(Box<glm::dvec3>& to, const Box<glm::dvec3>& place, const glm::dmat4x3& by) {
  const glm::dvec3 middle = (place.min + place.max) / 2.0, half = (place.max - place.min) / 2.0;
  const glm::dvec3 centre = by * glm::dvec4(middle, 1);
  const glm::dvec3 reach = glm::abs(by[0]) * half.x + glm::abs(by[1]) * half.y + glm::abs(by[2]) * half.z;
  add_finite(to, centre - reach);
  add_finite(to, centre + reach);
}

bool is_moved(const Scene& scene, const SubjectPart& part) {
  return !scene.draws[part.draw].full().vertices->morph_targets.empty() ||
         (part.node && scene.nodes[*part.node].skin.has_value());
}

}  // namespace

std::vector<std::vector<DrawId>> stored_groups(const Scene& scene, std::span<const Subject> subjects) {
  JoinedSets sets(scene.draws.size());
  for (const Mesh& mesh : scene.meshes) {
    for (const DrawId draw : mesh.draws) sets.join(mesh.draws.front(), draw);
  }
  const std::vector<glm::mat4> world = world_transforms(scene);
  for (const Subject& subject : subjects) {
    std::map<SkinId, DrawId> by_skin;
    std::vector<SubjectPart> unskinned;
    for (const SubjectPart& part : subject.parts) {
      if (!part.node) continue;
      if (const auto skin = scene.nodes[*part.node].skin) {
        sets.join(by_skin.try_emplace(*skin, part.draw).first->second, part.draw);
        continue;
      }
      const auto alike = std::ranges::find_if(
          unskinned, [&](const SubjectPart& other) { return world[*other.node] == world[*part.node]; });
      if (alike == unskinned.end()) {
        unskinned.push_back(part);
      } else {
        sets.join(alike->draw, part.draw);
      }
    }
  }
  std::map<DrawId, std::vector<DrawId>> groups;
  for (DrawId draw = 0; draw < scene.draws.size(); ++draw) groups[sets.of(draw)].push_back(draw);
  std::vector<std::vector<DrawId>> result;
  for (auto& [first, draws] : groups) result.push_back(std::move(draws));
  return result;
}

std::vector<std::vector<SubjectPart>> posed_groups(const Scene& scene, std::span<const Subject> subjects) {
  JoinedSets sets(scene.draws.size());
  for (const Subject& subject : subjects) {
    for (const SubjectPart& part : subject.parts) sets.join(subject.parts.front().draw, part.draw);
  }
  std::map<DrawId, std::vector<SubjectPart>> groups;
  for (const Subject& subject : subjects) {
    for (const SubjectPart& part : subject.parts) groups[sets.of(part.draw)].push_back(part);
  }
  std::vector<std::vector<SubjectPart>> result;
  for (auto& [first, parts] : groups) {
    if (std::ranges::any_of(parts, [&](const SubjectPart& part) { return is_moved(scene, part); })) {
      result.push_back(std::move(parts));
    }
  }
  return result;
}

Box<glm::dvec3> stored_box(const Scene& scene, std::span<const DrawId> draws) {
  Box<glm::dvec3> box;
  for (const DrawId id : draws) {
    const Draw& draw = scene.draws[id];
    for (std::size_t level = 0; level < draw.levels.size(); ++level) {
      const VertexStream* positions = draw.levels[level].vertices->find("POSITION");
      if (positions == nullptr || repeats_level(draw, level)) continue;
      for (const glm::vec3& position : decode_vec3(*positions)) add_finite(box, position);
    }
  }
  return box;
}

std::vector<Box<glm::dvec3>> posed_boxes(const Scene& scene, std::span<const std::vector<SubjectPart>> groups,
                                         const Poses& poses, const Executor& executor) {
  const std::vector<Scene> levels = levels_of(scene);
  std::map<const VertexStreams*, std::vector<Box<glm::dvec3>>> places;
  for (const std::vector<SubjectPart>& group : groups) {
    for (const SubjectPart& part : group) {
      for (const Level& level : scene.draws[part.draw].levels) {
        const auto [known, is_new] = places.try_emplace(level.vertices.get());
        if (is_new) known->second = morphed_places(*level.vertices);
      }
    }
  }
  const auto add = [&](Box<glm::dvec3>& box, const SubjectPart& part, const PosedNodes& nodes,
                       const PosedNodes& unmorphed) {
    for (std::size_t level = 0; level < levels.size(); ++level) {
      if (repeats_level(scene.draws[part.draw], level)) continue;
      for (const glm::vec3& position : posed_positions(levels[level], part, nodes)) add_finite(box, position);
      const std::vector<Box<glm::dvec3>>& morphed = places.at(scene.draws[part.draw].levels[level].vertices.get());
      if (morphed.empty()) continue;
      const std::vector<glm::dmat4x3> maps = vertex_maps(levels[level], part, unmorphed);
      for (std::size_t v = 0; v < morphed.size(); ++v) add_moved(box, morphed[v], maps[v]);
    }
  };
  std::vector<std::vector<Box<glm::dvec3>>> in_pose(poses.poses.size(), std::vector<Box<glm::dvec3>>(groups.size()));
  executor.for_each(in_pose.size(), [&](std::size_t p) {
    const PosedNodes nodes = posed_nodes(scene, poses.poses[p]);
    const PosedNodes unmorphed{nodes.world, std::vector<std::vector<float>>(nodes.weights.size())};
    for (std::size_t g = 0; g < groups.size(); ++g) {
      for (const SubjectPart& part : groups[g]) add(in_pose[p][g], part, nodes, unmorphed);
    }
  });
  std::vector<Box<glm::dvec3>> boxes(groups.size());
  for (const std::vector<Box<glm::dvec3>>& pose : in_pose) {
    for (std::size_t g = 0; g < groups.size(); ++g) boxes[g].add(pose[g]);
  }
  return boxes;
}

double rest_scale(const Scene& scene, const SubjectPart& part) {
  const std::vector<glm::dmat4x3> maps = vertex_maps(scene, part, posed_nodes(scene));
  if (maps.empty()) return 1;
  const glm::dmat4x3& map = maps.front();
  return std::sqrt(std::max({glm::dot(map[0], map[0]), glm::dot(map[1], map[1]), glm::dot(map[2], map[2])}));
}

}  // namespace foredraw::processors::vertex_pack

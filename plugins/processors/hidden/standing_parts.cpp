#include "standing_parts.h"

#include <foredraw/viewing/posed_positions.h>

#include <set>
#include <utility>

namespace foredraw::processors::hidden {

namespace {

bool has_morph_targets(const Draw& draw) {
  return draw.traits.has(traits::morphed) || !draw.full().vertices->morph_targets.empty();
}

bool has_instances(const Scene& scene, const SubjectPart& part) {
  return part.node && !scene.nodes[*part.node].instances.empty();
}

}  // namespace

std::size_t drawn_triangles(const Draw& draw) {
  const bool is_drawn = draw.topology == Topology::triangles && draw.full().vertices->find("POSITION") != nullptr;
  return is_drawn ? draw.full().stream().triangle_count() : 0;
}

bool is_opaque(const Scene& scene, const Draw& draw) {
  if (has_morph_targets(draw) || draw.traits.has(traits::extended) || draw.traits.has(traits::sprite)) return false;
  const Material* material = scene.material_of(draw);
  return material == nullptr ||
         (material->alpha_mode == AlphaMode::opaque && !material->keeps_sides && !material->displacement);
}

StandingParts standing_parts(const Scene& scene, const Subject& subject, const PosedNodes& nodes) {
  StandingParts standing;
  for (const SubjectPart& part : subject.parts) {
    const Draw& draw = scene.draws[part.draw];
    const Material* material = scene.material_of(draw);
    RasterPart drawn;
    standing.positions.push_back(drawn_triangles(draw) > 0 ? posed_positions(scene, part, nodes)
                                                           : std::vector<glm::vec3>());
    drawn.positions = standing.positions.back();
    drawn.indices = draw.full().stream().indices.view().first(3 * drawn_triangles(draw));
    drawn.culls_back_faces = material == nullptr || !material->double_sided;
    drawn.is_mirrored = is_mirrored(part, nodes);
    standing.parts.push_back(drawn);
    standing.hides.push_back(is_opaque(scene, draw) && !has_instances(scene, part));
  }
  return standing;
}

namespace {

std::string why_it_stays(const Scene& scene, const Draw& draw) {
  const Material* material = scene.material_of(draw);
  if (material != nullptr && material->alpha_mode == AlphaMode::blend) return "it is blended";
  if (material != nullptr && material->keeps_sides) {
    return "light passes through its material, or the material may change";
  }
  if (material != nullptr && material->displacement) return "a map of heights moves its surface";
  if (has_morph_targets(draw)) return "it has morph targets, and may take any shape between them";
  if (draw.traits.has(traits::sprite)) return "it is a sprite";
  if (draw.levels.size() != 1) return "it has several levels of detail";
  if (draw.full().orders.size() != 1) return "it has several orders";
  if (draw.full().vertices->find("POSITION") == nullptr) return "it has no positions";
  return "";
}

}  // namespace

std::vector<std::string> why_they_stay(const Scene& scene, SubjectUnit subjects) {
  std::vector<std::string> why;
  for (const Draw& draw : scene.draws) why.push_back(why_it_stays(scene, draw));
  // Each node that shows a draw must be one that it is looked at by; a mesh by itself stands for all of its nodes.
  std::set<std::pair<DrawId, NodeId>> looked_at;
  std::vector<bool> is_by_itself(scene.draws.size(), false);
  for (const Subject& subject : subjects_of(scene, subjects)) {
    for (const SubjectPart& part : subject.parts) {
      if (!part.node) is_by_itself[part.draw] = true;
      if (part.node) looked_at.emplace(part.draw, *part.node);
      if (has_instances(scene, part)) why[part.draw] = "its node shows it many times by instancing";
    }
  }
  for (NodeId n = 0; n < scene.nodes.size(); ++n) {
    if (!scene.nodes[n].mesh) continue;
    for (const DrawId id : scene.meshes[*scene.nodes[n].mesh].draws) {
      if (is_by_itself[id] || looked_at.contains({id, n}) || !why[id].empty()) continue;
      why[id] = "a node shows it elsewhere, outside of what is looked at";
    }
  }
  return why;
}

}  // namespace foredraw::processors::hidden

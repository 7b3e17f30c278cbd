#include "second_depth.h"

#include <foredraw/analysis/analyses.h>
#include <foredraw/analysis/welded_positions.h>
#include <foredraw/geometry/triangle_area.h>
#include <foredraw/scene/skin_weights.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace foredraw {

namespace {

/// What joints do to a vertex, in the sequence in which they do it: sums in another sequence differ in their last bits.
using Pull = std::vector<std::pair<std::uint32_t, float>>;

Pull pull_on(const SkinWeights& skin, std::uint32_t vertex) {
  Pull pull;
  if (skin.empty()) return pull;
  for (const SkinWeights::Slot& slot : skin.of(vertex)) {
    if (slot.weight != 0) pull.emplace_back(slot.joint, slot.weight);
  }
  return pull;
}

/// The vertices of several draws, one behind the other; those that draws share are there once.
struct JoinedVertices {
  std::vector<glm::vec3> positions;
  std::vector<Pull> pulls;  ///< empty where no draw follows joints
  std::map<const VertexStreams*, std::uint32_t> first;

  JoinedVertices(const Scene& scene, std::span<const DrawId> draws, Analyses& analyses) {
    std::vector<const VertexStreams*> all;
    bool is_skinned = false;
    for (const DrawId id : draws) {
      const VertexStreams& vertices = *scene.draws[id].full().vertices;
      if (!first.emplace(&vertices, static_cast<std::uint32_t>(positions.size())).second) continue;
      const auto of_draw = positions_of(analyses, vertices);
      positions.insert(positions.end(), of_draw->values.begin(), of_draw->values.end());
      all.push_back(&vertices);
      is_skinned = is_skinned || vertices.find("JOINTS_0") != nullptr;
    }
    if (!is_skinned) return;
    for (const VertexStreams* vertices : all) {
      const SkinWeights skin(*vertices);
      for (std::uint32_t v = 0; v < vertices->count; ++v) pulls.push_back(pull_on(skin, v));
    }
  }

  /// [vertex] equal ones stay at one place in every pose.
  std::vector<std::uint32_t> points() const {
    std::vector<std::uint32_t> points = welded(positions);
    if (pulls.empty()) return points;
    std::map<std::pair<std::uint32_t, Pull>, std::uint32_t> known;
    for (std::uint32_t v = 0; v < points.size(); ++v)
      points[v] = known.emplace(std::pair(points[v], pulls[v]), v).first->second;
    return points;
  }
};

double area_of(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const double area = triangle_area(a, b, c);
  return std::isfinite(area) ? area : 0;
}

}  // namespace

std::string why_not_in_second_depth(const Scene& scene, DrawId id, const SecondDepthOptions& options) {
  const Draw& draw = scene.draws[id];
  const Material* material = scene.material_of(draw);
  if (draw.topology != Topology::triangles) return "has no triangles";
  if (draw.full().vertices->find("POSITION") == nullptr) return "has no positions";
  if (material != nullptr) {
    if (material->alpha_mode == AlphaMode::blend) return "is blended: what lies behind it is seen";
    if (material->alpha_mode == AlphaMode::mask) return "is masked: what lies behind its holes is seen";
    if (material->double_sided) return "is double-sided: its back faces are drawn; put `sides` before this stage";
    if (material->keeps_sides)
      return "has a material that light passes through, or that an animation or a variant changes";
    if (material->displacement) return "is displaced by a map of heights";
  }
  if (!draw.full().vertices->morph_targets.empty()) {
    return "has morph targets, which move walls by themselves: what is closed at rest may fold through itself";
  }
  if (!options.skinned && draw.full().vertices->find("JOINTS_0") != nullptr) return "follows joints";
  return {};
}

double area_of(const Draw& draw, Analyses& analyses) {
  const auto positions = positions_of(analyses, *draw.full().vertices);
  const auto indices = draw.full().stream().indices.view();
  double area = 0;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    area +=
        area_of(positions->values[indices[i]], positions->values[indices[i + 1]], positions->values[indices[i + 2]]);
  }
  return area;
}

std::vector<DrawShells> shells_of(const Scene& scene, std::span<const DrawId> draws,
                                  std::span<const std::uint32_t> triangles, Analyses& analyses,
                                  const processors::second_depth::Limits& limits) {
  const JoinedVertices joined(scene, draws, analyses);
  std::vector<std::uint32_t> indices;
  for (std::size_t i = 0; i < draws.size(); ++i) {
    const Level& level = scene.draws[draws[i]].full();
    const std::uint32_t first = joined.first.at(level.vertices.get());
    for (const std::uint32_t v : level.stream().indices.view().first(3 * std::size_t{triangles[i]})) {
      indices.push_back(first + v);
    }
  }
  const std::vector<processors::second_depth::Kind> kinds =
      processors::second_depth::kinds_of(joined.positions, joined.points(), indices, limits);
  std::vector<DrawShells> result;
  std::size_t t = 0;
  for (std::size_t i = 0; i < draws.size(); ++i) {
    DrawShells& draw = result.emplace_back(DrawShells{draws[i], {}, {}});
    for (std::uint32_t end = triangles[i]; end > 0; --end, ++t) {
      const auto corner = [&](std::size_t c) { return joined.positions[indices[3 * t + c]]; };
      draw.kinds.push_back(kinds[t]);
      draw.areas.push_back(area_of(corner(0), corner(1), corner(2)));
    }
  }
  return result;
}

}  // namespace foredraw

#include "drawn_subject.h"

#include <foredraw/analysis/rest_positions.h>

#include <glm/matrix.hpp>

#include <algorithm>

namespace foredraw {

namespace {

RasterPart raster_part(const Scene& scene, const SubjectPart& part, std::span<const glm::vec3> positions,
                       std::span<const glm::mat4> world, Faces faces) {
  const Draw& draw = scene.draws[part.draw];
  const Material* material = scene.material_of(draw);
  RasterPart result;
  result.positions = positions;
  if (draw.topology == Topology::triangles && !is_blended(scene, draw) && !positions.empty()) {
    result.indices = draw.levels[0].orders[0].indices.view();
  }
  result.culls_back_faces = faces == Faces::front || material == nullptr || !material->double_sided;
  // glTF 2.0, 3.7.4: the node's transform decides, of skinned meshes too.
  result.is_mirrored = part.node && glm::determinant(glm::dmat3(world[*part.node])) < 0;
  return result;
}

}  // namespace

bool is_blended(const Scene& scene, const Draw& draw) {
  const Material* material = scene.material_of(draw);
  return material != nullptr && material->alpha_mode == AlphaMode::blend;
}

DrawnSubject drawn_subject(const Scene& scene, const Subject& subject, Faces faces, std::span<const glm::mat4> world) {
  DrawnSubject drawn;
  for (const SubjectPart& part : subject.parts) drawn.positions.push_back(rest_positions(scene, part, world));
  for (std::size_t i = 0; i < subject.parts.size(); ++i) {
    drawn.parts.push_back(raster_part(scene, subject.parts[i], drawn.positions[i], world, faces));
  }
  return drawn;
}

OverdrawCounts overdraw_raster(const DrawnSubject& subject, const Views& views, const Executor& executor) {
  const std::size_t all = views.views.size();
  // Each share prepares the parts anew, so there are few: twice the threads, for those that end early.
  const std::size_t shares = std::min<std::size_t>(all, 2 * static_cast<std::size_t>(executor.threads()));
  std::vector<OverdrawCounts> of_shares(shares);
  executor.for_each(shares, [&](std::size_t share) {
    const auto from = views.views.begin();
    const Views some{{from + static_cast<std::ptrdiff_t>(all * share / shares),
                      from + static_cast<std::ptrdiff_t>(all * (share + 1) / shares)},
                     views.size};
    of_shares[share] = overdraw_raster(subject.parts, some);
  });
  OverdrawCounts counts(subject.parts.size());
  for (const OverdrawCounts& some : of_shares) {
    for (std::size_t part = 0; part < counts.size(); ++part) {
      counts[part].insert(counts[part].end(), some[part].begin(), some[part].end());
    }
  }
  return counts;
}

}  // namespace foredraw

#include <foredraw/viewing/subject_geometry.h>

#include <foredraw/geometry/finite.h>
#include <foredraw/viewing/draw_mask.h>
#include <foredraw/viewing/posed_positions.h>

namespace foredraw {

namespace {

bool draws_triangles(const Scene& scene, const Draw& draw) {
  return draw.topology == Topology::triangles && !is_blended(scene, draw);
}

RasterPart raster_part(const Scene& scene, const SubjectPart& part, std::span<const glm::vec3> positions,
                       const PosedNodes& nodes, Faces faces, Analyses& analyses) {
  const Draw& draw = scene.draws[part.draw];
  const Material* material = scene.material_of(draw);
  RasterPart result;
  result.positions = positions;
  if (draws_triangles(scene, draw) && !positions.empty()) {
    const auto mask = mask_of(analyses, scene, draw);
    if (const auto* known = std::get_if<std::shared_ptr<const Mask>>(&mask)) {
      result.indices = draw.full().stream().indices.view();
      result.mask = *known;
    }
  }
  result.culls_back_faces = faces == Faces::front || material == nullptr || !material->double_sided;
  result.is_mirrored = is_mirrored(part, nodes);
  return result;
}

}  // namespace

bool is_blended(const Scene& scene, const Draw& draw) {
  const Material* material = scene.material_of(draw);
  return material != nullptr && material->alpha_mode == AlphaMode::blend;
}

SubjectGeometry subject_geometry(const Scene& scene, const Subject& subject, Faces faces, const PosedNodes& nodes,
                                 Analyses& analyses, ShownSurface surface) {
  SubjectGeometry drawn;
  for (const SubjectPart& part : subject.parts) {
    drawn.positions.push_back(posed_positions(scene, part, nodes));
    drawn.displaced.push_back(surface == ShownSurface::stored ? nullptr
                                                              : displaced_draw_of(scene, part.draw, analyses));
  }
  for (std::size_t i = 0; i < subject.parts.size(); ++i) {
    const SubjectPart& part = subject.parts[i];
    RasterPart made = raster_part(scene, part, drawn.positions[i], nodes, faces, analyses);
    if (const DisplacedDraw* displaced = drawn.displaced[i].get(); displaced && !made.indices.empty() && !made.mask) {
      drawn.positions[i] = posed_positions(*displaced, drawn.positions[i], scene, part, nodes);
      made.positions = drawn.positions[i];
      made.owner_count = made.indices.size() / 3;
      made.indices = displaced->mesh.indices;
      made.owners = displaced->owners;
    }
    drawn.parts.push_back(std::move(made));
  }
  return drawn;
}

std::size_t count_triangles(const Scene& scene, const Subject& subject) {
  std::size_t count = 0;
  for (const SubjectPart& part : subject.parts) {
    const Draw& draw = scene.draws[part.draw];
    if (draws_triangles(scene, draw)) count += draw.full().stream().triangle_count();
  }
  return count;
}

std::size_t count_non_finite_triangles(const RasterPart& part) {
  std::size_t count = 0;
  for (std::size_t i = 0; i + 2 < part.indices.size(); i += 3) {
    for (std::size_t corner = i; corner < i + 3; ++corner) {
      if (is_finite(part.positions[part.indices[corner]])) continue;
      ++count;
      break;
    }
  }
  return count;
}

}  // namespace foredraw

#pragma once
// A draw whose material moves its surface, as it is seen.

#include <foredraw/analysis/analyses.h>
#include <foredraw/displaced/displaced_mesh.h>
#include <foredraw/scene/subject.h>
#include <foredraw/viewing/animation.h>

#include <memory>

namespace foredraw {

struct DisplacedDraw {
  static constexpr std::string_view name = "displaced-draw";

  TessellatedMesh mesh;
  std::vector<float> displacements;   ///< [vertex of the mesh]
  std::vector<glm::vec3> directions;  ///< [vertex of the draw] at rest
  std::vector<std::uint32_t> owners;  ///< [triangle of the mesh] that of the draw which it lies on

  std::size_t bytes() const;
};

/// The draw's full detail, as fine as its map by levels_by_texels(), but with no more than half a million triangles or
/// its own; kept by content. Null where its material moves nothing.
std::shared_ptr<const DisplacedDraw> displaced_draw_of(const Scene& scene, DrawId draw, Analyses& analyses);

/// [vertex of the mesh] where a part shows the draw, as posed_positions() has those of the draw itself: `posed`.
std::vector<glm::vec3> posed_positions(const DisplacedDraw& displaced, std::span<const glm::vec3> posed,
                                       const Scene& scene, const SubjectPart& part, const PosedNodes& nodes);

/// The triangles of a draw as a part shows them: displaced where its material or heights displace it, else its own.
struct SeenSurface {
  std::shared_ptr<const DisplacedDraw> displaced;  ///< null: it is not
  std::vector<glm::vec3> positions;
  std::span<const std::uint32_t> indices;  ///< of the scene's draw or of `displaced`
};
SeenSurface seen_surface(const Scene& scene, const SubjectPart& part, const PosedNodes& nodes, Analyses& analyses);

}  // namespace foredraw

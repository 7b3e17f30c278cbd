#pragma once
// From a scene to the triangles that are drawn.

#include <foredraw/analysis/analyses.h>
#include <foredraw/scene/subject.h>
#include <foredraw/viewing/animation.h>
#include <foredraw/viewing/displaced_draw.h>
#include <foredraw/viewing/raster_part.h>

#include <cstddef>
#include <vector>

namespace foredraw {

/// Which back faces are culled: those of single-sided materials, or all.
enum class Faces { material, front };

/// Whether a draw is drawn as its material displaces it, or by its own triangles.
enum class ShownSurface { displaced, stored };

/// A subject in a pose, ready to be drawn.
struct SubjectGeometry {
  std::vector<std::vector<glm::vec3>> positions;                ///< what the parts look into
  std::vector<std::shared_ptr<const DisplacedDraw>> displaced;  ///< the same, of those that are; null for the others
  std::vector<RasterPart> parts;  ///< as many as the subject's; those that are not drawn have no triangles
};

/// Triangle lists alone are drawn, no blended draws, and of masked ones those of which it is known where their holes
/// are (mask_of()). Displaced draws are shown as displaced_draw_of() has them, unless they are masked. `nodes`:
/// posed_nodes() of the scene.
SubjectGeometry subject_geometry(const Scene& scene, const Subject& subject, Faces faces, const PosedNodes& nodes,
                                 Analyses& analyses, ShownSurface surface = ShownSurface::displaced);

bool is_blended(const Scene& scene, const Draw& draw);

/// How many triangles may be drawn of a subject, in any pose.
std::size_t count_triangles(const Scene& scene, const Subject& subject);

/// How many triangles have a position that is not finite.
std::size_t count_non_finite_triangles(const RasterPart& part);

}  // namespace foredraw

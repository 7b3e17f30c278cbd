#pragma once
#include "overdraw_raster.h"

#include <foredraw/base/parallel.h>
#include <foredraw/scene/subject.h>

#include <glm/mat4x4.hpp>

#include <span>
#include <vector>

namespace foredraw {

/// A subject at rest, ready to be drawn.
struct DrawnSubject {
  std::vector<std::vector<glm::vec3>> positions;  ///< what the parts look into
  std::vector<RasterPart> parts;  ///< as many as the subject's; those that are not drawn have no triangles
};

/// Triangle lists alone are drawn, and no blended draws; masked ones as if they were opaque.
DrawnSubject drawn_subject(const Scene& scene, const Subject& subject, Faces faces, std::span<const glm::mat4> world);

bool is_blended(const Scene& scene, const Draw& draw);

/// overdraw_raster() with the views shared out over the threads. The counts are the same however they are.
OverdrawCounts overdraw_raster(const DrawnSubject& subject, const Views& views, const Executor& executor);

}  // namespace foredraw

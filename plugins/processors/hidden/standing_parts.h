#pragma once
// A subject's parts as they stand in a pose, and which of them hide what lies behind.

#include "sight.h"

#include <foredraw/scene/subject.h>
#include <foredraw/viewing/animation.h>

#include <string>

namespace foredraw::processors::hidden {

struct StandingParts {
  std::vector<std::vector<glm::vec3>> positions;  ///< that the parts look into
  std::vector<RasterPart> parts;                  ///< without masks; what draws no triangles has none
  Flags hides;                                    ///< [part]
};

StandingParts standing_parts(const Scene& scene, const Subject& subject, const PosedNodes& nodes);

/// How many triangles of a draw are looked at: none where it draws none, or has no positions.
std::size_t drawn_triangles(const Draw& draw);

/// Whether nobody sees through the draw, whatever becomes of the scene: it is not masked, blended or morphed, and its
/// material is not one that light passes through, nor may it be exchanged.
bool is_opaque(const Scene& scene, const Draw& draw);

/// [draw] why what is hidden of it has to stay, or nothing.
std::vector<std::string> why_they_stay(const Scene& scene, SubjectUnit subjects);

}  // namespace foredraw::processors::hidden

#pragma once
// Which of the objects in the frustum something hides.

#include <foredraw/frames/reference_renderer.h>

#include <vector>

namespace foredraw {

/// Those of `seen` that are not hidden: each has a point in the square around its sphere before which nothing stands.
/// What stands there is drawn at its coarsest level, in a picture of half the size; so an object that only shows
/// through a gap between levels may be left out. Blended and masked surfaces hide nothing. `pixels` of the others
/// become what that picture shows of them.
std::vector<SeenObject> unhidden_objects(const FrameScene& scene, const FrameMoment& moment, const FrameCamera& camera,
                                         FrameSize size, std::vector<SeenObject> seen);

}  // namespace foredraw

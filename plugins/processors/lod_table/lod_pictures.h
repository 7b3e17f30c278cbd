#pragma once
// What a draw looks like by each rendering, measured in pictures.

#include <foredraw/analysis/analyses.h>
#include <foredraw/base/parallel.h>
#include <foredraw/frames/rendering.h>
#include <foredraw/scene/scene.h>

#include <array>

namespace foredraw {

struct LodPictures {
  double radius = 0;    ///< of the bounding sphere of full detail, in the draw's units; 0: it has no size
  double coverage = 0;  ///< of the sphere's outline, what part the draw covers in the mean; 0 to 1: FrameMesh::fill
  std::array<double, all_renderings.size()> accuracy = {1, 1, 1};  ///< 0 to 1; as rendering_accuracies() has them
};

/// Of the draw alone, in full detail, at rest and as it is bound. A draw of triangles. The same bits everywhere.
LodPictures lod_pictures(const Scene& scene, DrawId draw, Analyses& analyses, const Executor& executor);

}  // namespace foredraw

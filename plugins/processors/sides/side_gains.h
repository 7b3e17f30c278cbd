#pragma once
// What is saved where the two sides of a triangle are drawn apart.

#include "all_sides.h"

#include <foredraw/analysis/analyses.h>
#include <foredraw/base/parallel.h>
#include <foredraw/scene/poses.h>
#include <foredraw/scene/scene.h>
#include <foredraw/scene/subject.h>
#include <foredraw/scene/views.h>

#include <map>
#include <vector>

namespace foredraw::processors::sides {

struct SideGains {
  std::map<DrawId, std::vector<double>> of;  ///< [draw asked for][triangle] fragments
  double visible = 0;                        ///< fragments that are seen in the same pictures
};

/// Where one side of a triangle hides something and the other one is hidden, no place in the order is right for both:
/// it should be drawn early for the one's sake, and late for the other's. Of both sides the fragments that hide
/// something and those that are hidden are counted, from each view, in the poses by turns; the lesser number is lost,
/// or half of it: in an order or in its reverse. Triangles of which both sides are `wanted` ([draw asked
/// for][triangle]) are counted among what is wanted, as the rest will not be drawn; the others among all sides. The
/// same at any number of threads.
SideGains side_gains(const Scene& scene, const std::map<DrawId, std::vector<Side>>& wanted, const Views& views,
                     const Poses& poses, SubjectUnit unit, Analyses& analyses, const Executor& executor);

}  // namespace foredraw::processors::sides

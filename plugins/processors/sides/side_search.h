#pragma once
// The sides of a scene's double-sided draws that are seen, in all poses.

#include "needed_sides.h"
#include "surface.h"

#include <foredraw/analysis/analyses.h>
#include <foredraw/scene/poses.h>
#include <foredraw/scene/subject.h>

#include <atomic>
#include <functional>
#include <map>

namespace foredraw::processors::sides {

struct SideSearchOptions {
  int rays = 16;     ///< from each side that no picture shows; shared out over the poses, two in each at least
  int checks = 150;  ///< pictures that have the last word, from sides and at times that decided nothing; of large
                     ///< meshes fewer and larger ones
  Views views;       ///< that the first pictures are drawn from; several poses share them
  Poses poses = rest_pose;
  SubjectUnit subjects = SubjectUnit::character;  ///< what hides what: parts of one subject
  std::uint64_t seed = 0;
  const std::atomic<bool>* cancel = nullptr;  ///< once it is true, what is found means nothing
  std::function<void(double)> progress = {};  ///< may be empty; the part done, 0 to 1
};

struct FoundSides {
  std::map<DrawId, std::vector<Side>> wanted;  ///< [draw asked for][triangle]
  std::map<DrawId, Surface> surfaces;          ///< [draw asked for]
  std::uint64_t wrong = 0;                     ///< pixels that the last check added a side for
  std::uint64_t shown = 0;                     ///< of all that it shows
};

/// Three ways to find what is seen, each where it is best:
/// - Pictures from the views, in the poses, find what is seen from many directions.
/// - Rays find what is seen through an opening: from backs of open components, half of them aimed into an opening
///   close to its rim; and from what touches a side that is seen, along the direction that it is seen from.
/// - Pictures from other views and in other poses check the result, few at first and more each time. Where one needs a
///   side, that is kept with what is seen beside it; and of its draw the neighbours of all that is kept, and what lies
///   at an opening. There are six checks at most. They end with one of `checks` pictures that needs nothing more.
/// Neighbours of what is seen count as seen too, before the checks and once more behind them: slivers that no sample
/// met lie there. So does what lies at an opening of a draw that moves, where any back of the draw is seen: other poses
/// uncover it. Fronts count as seen, unless only the back of the triangle is.
FoundSides find_sides(const Scene& scene, std::span<const DrawId> asked, const SideSearchOptions& options,
                      Analyses& analyses, const Executor& executor);

}  // namespace foredraw::processors::sides

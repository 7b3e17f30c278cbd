#pragma once
// How far the draws of a mesh lie from what they were, proved. Each draw is measured from itself, as evaluators and
// engines do it, although the draws of a mesh become coarser together.

#include <foredraw/analysis/farthest_distance.h>
#include <foredraw/collapses/cut.h>

#include <memory>

namespace foredraw {

class DrawDistances {
 public:
  /// The mesh shall live as long.
  explicit DrawDistances(const JoinedMesh& mesh);

  /// Of the draw that is farthest, either way. Nothing where a draw has no triangle left.
  std::optional<Farthest> farthest(const Collapsed& after, const FarthestOptions& options,
                                   const Executor& executor) const;
  /// Whether each draw is proved to be within the distance, either way.
  bool are_within(const Collapsed& after, double distance, const FarthestOptions& options,
                  const Executor& executor) const;

 private:
  Surface full(std::size_t draw) const;

  const JoinedMesh& mesh_;
  std::vector<std::unique_ptr<const ClosestPoints>> points_;  ///< [draw] of full detail
};

}  // namespace foredraw

#pragma once
// How well the cost model can foretell the frames of a walk, with constants that come from other frames of it.

#include "frame_ways.h"

#include <foredraw/frames/cost_fit.h>

#include <vector>

namespace foredraw::evaluators::lod_walk {

/// Adds up what a frame draws: objects by one rendering and with the same slower stage are one.
class SummedWork {
 public:
  explicit SummedWork(const RenderingCosts& costs) : costs_(costs) {}
  void add(const ObjectWork& work);
  std::vector<ObjectWork> drawn() const;  ///< those that there are

 private:
  const RenderingCosts& costs_;
  std::array<std::array<ObjectWork, 2>, all_renderings.size()> sums_{};  // [rendering][whether pixels are slower]
};

/// The errors of both forms of the model on every second sample, fitted to the others (levels by the slower stage, and
/// by the sum of both).
struct WalkFit {
  FitError max, sum;
};
WalkFit walk_fit(const std::vector<FrameSample>& samples);

}  // namespace foredraw::evaluators::lod_walk

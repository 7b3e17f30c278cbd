#pragma once
// A run between two stages: somebody may keep it, so that a later run of the same beginning goes on from there.

#include <foredraw/pipeline/plan.h>
#include <foredraw/technique/run.h>

#include <optional>
#include <string>
#include <vector>

namespace foredraw {

/// What a stage or a measurement came to, beside the scene.
struct Step {
  StageRecord record;
  std::vector<Measured> measured;
};

struct Milestone {
  std::vector<Step> measures;  ///< of the input; none where they are not known
  std::vector<Step> stages;    ///< those that are behind
  Scene scene;                 ///< as the last of them left it
};

/// Who keeps the milestones of one run.
class Milestones {
 public:
  virtual ~Milestones() = default;
  /// Of an earlier run with the same beginning, the one that is furthest on; nothing: begin at the beginning.
  virtual std::optional<Milestone> furthest(const Plan& plan, const Scene& input) = 0;
  /// Asked behind each stage that did not fail, but the last. What it answers stands in the report: why what was worth
  /// to be kept can not be. Empty: it is kept, or not worth it.
  virtual std::string reached(const Plan& plan, const Milestone& milestone) = 0;
};

}  // namespace foredraw

#pragma once
// Where a sequence of collapses is cut so that levels of detail come out: by shares of the triangles, or by distances.

#include <foredraw/collapses/joined_mesh.h>
#include <foredraw/collapses/replay.h>

#include <foredraw/base/parallel.h>

#include <atomic>

namespace foredraw {

/// Of levels from fine to coarse: either list, not both.
struct LevelGoals {
  std::vector<double> ratios;  ///< of the mesh's triangles that are left at most: above 0, below 1, falling
  std::vector<double> errors;  ///< largest distance from full detail, either way, in units: 0 or more, rising
};

/// std::invalid_argument where there is no goal, or they are of both kinds or not as told above.
void check(const LevelGoals& goals);

struct LevelCut {
  std::size_t collapses = 0;      ///< until the level
  std::optional<double> largest;  ///< the error that ended it, which is proved; none where something else did
};

/// [goal] where the level begins; the same as before where no more edges may go. Each draw of the mesh keeps a
/// triangle. `run` is that of the sequence. Distances are proved, not sampled.
std::vector<LevelCut> level_cuts(const JoinedMesh& mesh, const CollapseSequence& sequence, const Replay& run,
                                 const LevelGoals& goals, const Executor& executor,
                                 const std::atomic<bool>* cancel = nullptr);

struct Plugin;
Plugin levels_plugin();

}  // namespace foredraw

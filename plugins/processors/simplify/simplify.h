#pragma once
// How far a sequence of collapses runs until a mesh is as coarse as is wanted.

#include <foredraw/collapses/joined_mesh.h>
#include <foredraw/collapses/replay.h>

#include <foredraw/base/parallel.h>

#include <atomic>

namespace foredraw {

/// What ends it, whichever comes first. Where nothing is set a half of the triangles is left.
struct SimplifyOptions {
  std::optional<double> ratio;             ///< of the triangles that shall be left, 0 to 1
  std::optional<std::uint32_t> triangles;  ///< that shall be left
  std::optional<double> error;             ///< the largest distance of the two surfaces, either way, in units
};

struct Simplified {
  enum class End { goal, error, sequence };
  std::size_t collapses = 0;
  std::uint32_t triangles = 0;  ///< that are left
  End end = End::goal;          ///< reached the number of triangles, or the error, or the end of the sequence
};

/// `run` is that of the sequence. Distances are proved, not sampled, so that an error of 0 allows what changes nothing
/// alone. The distance hardly ever falls as edges collapse: the answer is found by halving.
Simplified simplify(const JoinedMesh& mesh, const CollapseSequence& sequence, const Replay& run,
                    const SimplifyOptions& options, const Executor& executor,
                    const std::atomic<bool>* cancel = nullptr);

struct Plugin;
Plugin simplify_plugin();

}  // namespace foredraw

#pragma once
// Work shared out over threads. What a task computes never depends on how many threads there are: a task is one index,
// writes only what belongs to that index, and whoever asked merges in index order.

#include <cstddef>
#include <functional>

namespace foredraw {

/// Calls task(i) once for each i below `count`, in any order, from any threads, and returns when all calls have ended.
/// The task never throws. It may ask for a loop of its own; a thread that waits for the end of a loop works on that
/// loop's tasks alone meanwhile, for it may hold a lock that another task wants.
using ParallelLoop = std::function<void(std::size_t count, const std::function<void(std::size_t)>& task)>;

class Executor {
 public:
  /// At most `threads` of oneTBB's at once, and never more than there are processors; 0: one for each processor.
  explicit Executor(int threads = 0);
  /// Shares work out by the caller's own scheduler, which uses about so many threads, at least 1.
  Executor(int threads, ParallelLoop loop);

  int threads() const { return threads_; }

  /// Calls task(i) once for each i below `count`, in any order, from any of the threads. May be nested. The first
  /// exception that a task throws is thrown again here, after all running tasks have ended; tasks that have not begun
  /// by then are left out.
  void for_each(std::size_t count, const std::function<void(std::size_t)>& task) const;

 private:
  int threads_;
  ParallelLoop loop_;
};

}  // namespace foredraw

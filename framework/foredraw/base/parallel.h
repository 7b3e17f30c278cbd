#pragma once
// Work shared out over threads. What a task computes never depends on how many threads there are: a task is one index,
// writes only what belongs to that index, and whoever asked merges in index order.

#include <cstddef>
#include <functional>
#include <memory>

namespace foredraw {

class Executor {
 public:
  /// At most `threads` at once, and never more than there are processors; 0: one for each processor.
  explicit Executor(int threads = 0);
  ~Executor();
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;

  int threads() const { return threads_; }

  /// Calls task(i) once for each i below `count`, in any order, from any of the threads. May be nested. The first
  /// exception that a task throws is thrown again here, after all running tasks have ended.
  void for_each(std::size_t count, const std::function<void(std::size_t)>& task) const;

 private:
  struct Arena;
  int threads_;
  std::unique_ptr<Arena> arena_;
};

}  // namespace foredraw

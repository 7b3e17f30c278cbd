#include <foredraw/base/parallel.h>

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <new>
#include <stdexcept>
#include <thread>
#include <vector>

namespace foredraw {

struct Executor::Arena {
  tbb::task_arena arena;
};

Executor::Executor(int threads)
    : threads_(threads > 0 ? std::min(threads, tbb::info::default_concurrency()) : tbb::info::default_concurrency()),
      arena_(new Arena{tbb::task_arena(threads_)}) {}

Executor::~Executor() = default;

#ifdef __SANITIZE_THREAD__

// ThreadSanitizer sees nothing of TBB's library and calls every hand-over in it a race. Under it, plain threads keep the
// same promise, so that what it reports is ours.
void Executor::for_each(std::size_t count, const std::function<void(std::size_t)>& task) const {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr first;
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        task(i);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!first) first = std::current_exception();
        next = count;
      }
    }
  };
  std::vector<std::thread> others;
  for (int i = 1; i < threads_; ++i) others.emplace_back(work);
  work();
  for (std::thread& other : others) other.join();
  if (first) std::rethrow_exception(first);
}

#else

void Executor::for_each(std::size_t count, const std::function<void(std::size_t)>& task) const {
  std::atomic<bool> task_failed = false;
  const auto loop = [&] {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1), [&](const auto& range) {
      try {
        for (std::size_t i = range.begin(); i != range.end(); ++i) task(i);
      } catch (...) {
        task_failed = true;
        throw;
      }
    }, tbb::simple_partitioner());
  };
  try {
    // Isolated: who waits here holds perhaps a lock, and must not be given a task from outside that wants the same one.
    arena_->arena.execute([&] { tbb::this_task_arena::isolate(loop); });
  } catch (const std::runtime_error&) {
    if (!task_failed) throw std::bad_alloc();  // TBB's own: there was no memory for the stack of a thread
    throw;
  }
}

#endif

}  // namespace foredraw

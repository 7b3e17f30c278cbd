#include <foredraw/base/parallel.h>

#if defined(__SANITIZE_THREAD__) && !defined(FOREDRAW_PLAIN_THREADS)
#define FOREDRAW_PLAIN_THREADS
#endif
#ifndef FOREDRAW_PLAIN_THREADS
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <new>
#include <stdexcept>
#include <thread>
#include <vector>

namespace foredraw {

namespace {

#ifdef FOREDRAW_PLAIN_THREADS

// ThreadSanitizer sees nothing of TBB's library and calls every hand-over in it a race. Under it, plain threads keep
// the same promise, so that what it reports is ours. And libraries that shall need no other one ask for them.
int processors() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

ParallelLoop loop_over(int threads) {
  return [threads](std::size_t count, const std::function<void(std::size_t)>& task) {
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
      for (std::size_t i = next++; i < count; i = next++) task(i);
    };
    std::vector<std::thread> others;
    for (int i = 1; i < threads; ++i) others.emplace_back(work);
    work();
    for (std::thread& other : others) other.join();
  };
}

#else

int processors() { return tbb::info::default_concurrency(); }

ParallelLoop loop_over(int threads) {
  return [arena = std::make_shared<tbb::task_arena>(threads)](std::size_t count,
                                                              const std::function<void(std::size_t)>& task) {
    const auto loop = [&] {
      tbb::parallel_for(
          tbb::blocked_range<std::size_t>(0, count, 1),
          [&](const auto& range) {
            for (std::size_t i = range.begin(); i != range.end(); ++i) task(i);
          },
          tbb::simple_partitioner());
    };
    try {
      // Isolated: who waits here holds perhaps a lock, and must be given no task from outside that wants the same one.
      arena->execute([&] { tbb::this_task_arena::isolate(loop); });
    } catch (const std::runtime_error&) {
      throw std::bad_alloc();  // TBB's own: there was no memory for the stack of a thread
    }
  };
}

#endif

int threads_for(int wanted) { return wanted > 0 ? std::min(wanted, processors()) : processors(); }

}  // namespace

Executor::Executor(int threads) : Executor(threads_for(threads), loop_over(threads_for(threads))) {}

Executor::Executor(int threads, ParallelLoop loop) : threads_(std::max(threads, 1)), loop_(std::move(loop)) {}

void Executor::for_each(std::size_t count, const std::function<void(std::size_t)>& task) const {
  std::atomic<bool> task_failed = false;
  std::mutex mutex;
  std::exception_ptr first;
  loop_(count, [&](std::size_t i) {
    if (task_failed.load(std::memory_order_relaxed)) return;
    try {
      task(i);
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!first) first = std::current_exception();
      task_failed = true;
    }
  });
  if (first) std::rethrow_exception(first);
}

}  // namespace foredraw

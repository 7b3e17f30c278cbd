#include <foredraw/base/parallel.h>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace foredraw::parallel_test {
namespace {

TEST(Executor, CallsEveryIndexOnce) {
  for (const int threads : {1, 2, 7}) {
    const Executor executor(threads);
    EXPECT_GE(executor.threads(), 1);
    EXPECT_LE(executor.threads(), threads);
    for (const std::size_t count : {0, 1, 2, 1000}) {
      std::vector<std::atomic<int>> calls(count);
      executor.for_each(count, [&](std::size_t i) { ++calls.at(i); });
      for (const auto& each : calls) EXPECT_EQ(each, 1);
    }
  }
}

TEST(Executor, TakesAThreadForEachProcessorUnlessTold) {
  EXPECT_GE(Executor().threads(), 1);
  EXPECT_EQ(Executor(0).threads(), Executor().threads());
}

TEST(Executor, NeverUsesMoreThreadsThanAsked) {
  const Executor executor(2);
  std::atomic<int> running{0}, most{0};
  executor.for_each(64, [&](std::size_t) {
    const int now = ++running;
    for (int seen = most; now > seen && !most.compare_exchange_weak(seen, now);) continue;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    --running;
  });
  EXPECT_LE(most, 2);
}

TEST(Executor, OneThreadGoesInOrder) {
  std::vector<std::size_t> seen;
  std::set<std::thread::id> threads;
  Executor(1).for_each(100, [&](std::size_t i) {
    seen.push_back(i);
    threads.insert(std::this_thread::get_id());
  });
  EXPECT_EQ(threads.size(), 1u);
  for (std::size_t i = 0; i < seen.size(); ++i) EXPECT_EQ(seen[i], i);
}

TEST(Executor, ThreadsWorkAtTheSameTime) {
  // Each of two tasks waits for the other: with one thread alone this would never end.
  std::atomic<int> arrived{0};
  Executor(2).for_each(2, [&](std::size_t) {
    ++arrived;
    while (arrived < 2) std::this_thread::yield();
  });
  EXPECT_EQ(arrived, 2);
}

TEST(Executor, PassesAnExceptionOnAfterAllHaveEnded) {
  const Executor executor(4);
  std::atomic<int> running{0};
  try {
    executor.for_each(100, [&](std::size_t i) {
      ++running;
      if (i == 13) {
        --running;
        throw std::runtime_error("thirteen");
      }
      std::this_thread::sleep_for(std::chrono::microseconds(200));
      --running;
    });
    FAIL() << "the exception was lost";
  } catch (const std::runtime_error& problem) {
    EXPECT_STREQ(problem.what(), "thirteen");
    EXPECT_EQ(running, 0);
  }
  std::atomic<int> after{0};
  executor.for_each(10, [&](std::size_t) { ++after; });
  EXPECT_EQ(after, 10) << "an executor works on after an exception";
}

void one_after_the_other(std::size_t count, const std::function<void(std::size_t)>& task) {
  for (std::size_t i = count; i-- > 0;) task(i);
}

/// A scheduler such as an engine brings along: every third task to each of three threads.
void on_threads(std::size_t count, const std::function<void(std::size_t)>& task) {
  std::vector<std::thread> threads;
  for (std::size_t first = 0; first < 3; ++first) {
    threads.emplace_back([&task, first, count] {
      for (std::size_t i = first; i < count; i += 3) task(i);
    });
  }
  for (std::thread& thread : threads) thread.join();
}

std::vector<Executor> executors_of_every_kind() {
  return {Executor(1), Executor(3), Executor(1, one_after_the_other), Executor(3, on_threads)};
}

TEST(Executor, MayBeNested) {
  for (const Executor& executor : executors_of_every_kind()) {
    std::vector<std::vector<int>> calls(20, std::vector<int>(30, 0));
    executor.for_each(
        20, [&](std::size_t outer) { executor.for_each(30, [&](std::size_t inner) { ++calls[outer][inner]; }); });
    EXPECT_EQ(calls, std::vector<std::vector<int>>(20, std::vector<int>(30, 1)));
  }
}

TEST(Executor, ACallersLoopNeedNotKnowOfExceptions) {
  for (const Executor& executor : executors_of_every_kind()) {
    std::atomic<int> ended{0};
    EXPECT_THROW(executor.for_each(50,
                                   [&](std::size_t i) {
                                     if (i % 10 == 3) throw std::runtime_error("three");
                                     ++ended;
                                   }),
                 std::runtime_error);
    EXPECT_LT(ended, 45) << "the rest is left out";
    ended = 0;
    executor.for_each(50, [&](std::size_t) { ++ended; });
    EXPECT_EQ(ended, 50);
  }
}

TEST(Executor, AskedForNoThreadsTellsOfOne) { EXPECT_EQ(Executor(0, one_after_the_other).threads(), 1); }

}  // namespace
}  // namespace foredraw::parallel_test

// Threads, a caller's loop and runs at once change nothing.

#include "runs_stages.h"

#include <foredraw/measuring/overdraw_evaluator.h>

#include <functional>
#include <thread>

namespace foredraw::runner_threads_test {
namespace {

class RunnerThreads : public testing::RunsStages {
 protected:
  static void expect_same(const Result& a, const Result& b) {
    for (DrawId id = 0; id < b.scene.draws.size(); ++id) {
      EXPECT_EQ(indices(a.scene, id), indices(b.scene, id));
      EXPECT_EQ(a.scene.draws[id].levels[0].vertices->stamp(), b.scene.draws[id].levels[0].vertices->stamp());
    }
  }
};

/// 39 draws of up to 195 triangles.
Scene many_draws() {
  std::vector<Draw> draws;
  for (std::uint32_t i = 1; i < 40; ++i) {
    draws.push_back(testing::draw_of(testing::soup(i * 5, i), "Soup " + std::to_string(i)));
  }
  return testing::scene_of(std::move(draws));
}

constexpr const char* every_shape = "pairs, reverse-draw, two-orders, reverse-vertices";

TEST_F(RunnerThreads, GivesTheSameAtAnyThreadCount) {
  const Scene scene = many_draws();
  const Result one = run(every_shape, scene, "count-triangles", Executor(1));
  const Result many = run(every_shape, scene, "count-triangles", Executor(7));
  expect_same(many, one);
}

TEST_F(RunnerThreads, GivesTheSameWithACallersLoop) {
  const Scene scene = many_draws();
  const Result expected = run(every_shape, scene, "count-triangles");
  const Executor backwards(1, [](std::size_t count, const std::function<void(std::size_t)>& task) {
    for (std::size_t i = count; i-- > 0;) task(i);
  });
  const Executor on_threads(4, [](std::size_t count, const std::function<void(std::size_t)>& task) {
    std::vector<std::thread> threads;
    for (std::size_t first = 0; first < 4; ++first) {
      threads.emplace_back([&task, first, count] {
        for (std::size_t i = first; i < count; i += 4) task(i);
      });
    }
    for (std::thread& thread : threads) thread.join();
  });
  for (const Executor* executor : {&backwards, &on_threads}) {
    const Result result = run(every_shape, scene, "count-triangles", *executor);
    expect_same(result, expected);
    EXPECT_EQ(result.report.threads, executor->threads());
  }
}

/// Counts that scatter over the views, so that who wants a small error asks for more of them.
struct ScatteredOverdraw final : OverdrawService {
  OverdrawCounts draw(std::span<const RasterPart> parts, const Views& views, Run&) const override {
    std::vector<OverdrawCount> counts;
    for (std::size_t view = 0; view < views.views.size(); ++view) counts.push_back({10 + view * view % 7, 10, 0});
    return OverdrawCounts(parts.size(), counts);
  }
};

TEST_F(RunnerThreads, OnePlanRunsTwiceAtOnce) {
  registry_.add(overdraw_plugin<OverdrawOptions>(
      {.name = "scattered", .summary = "For tests", .reference = "own"}, [](auto&) {},
      [](const OverdrawOptions&) { return std::make_unique<ScatteredOverdraw>(); }));
  const Plan plan = planned(std::string(every_shape) + ", add-draw", two_, "count-triangles, scattered(error=0.02)");
  const Executor executor(2);
  Analyses analyses;
  const auto run = [&] { return foredraw::optimize(plan, two_, {executor, analyses}); };
  const Result alone = run();
  ASSERT_FALSE(alone.failed);
  ASSERT_NE(alone.report.after.metrics.find("scattered", "ratio"), nullptr);
  std::vector<Result> at_once(2);
  std::vector<std::thread> threads;
  for (Result& result : at_once) threads.emplace_back([&result, &run] { result = run(); });
  for (std::thread& thread : threads) thread.join();
  for (const Result& result : at_once) {
    expect_same(result, alone);
    for (const StateRecord Report::*state : {&Report::before, &Report::after}) {
      const Figure* ratio = (result.report.*state).metrics.find("scattered", "ratio");
      ASSERT_NE(ratio, nullptr);
      EXPECT_EQ(ratio->value(), (alone.report.*state).metrics.find("scattered", "ratio")->value());
    }
  }
}

}  // namespace
}  // namespace foredraw::runner_threads_test

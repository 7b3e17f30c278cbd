// A run that is cancelled ends soon, whatever a module does meanwhile.
#include "left_behind.h"
#include "support/meshes.h"
#include "support/program.h"

#include <foredraw/modules/load_modules.h>
#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/runner.h>

#include <gmock/gmock.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace foredraw::testing {
namespace {

class CancelModules : public InFolder {};

TEST_F(CancelModules, EndsThoseThatDoNotLook) {
  Registry registry;
  Diagnostics diagnostics;
  const Executor executor(2);
  add_modules({.places = {module_in(folder_, "spins")}, .limits = {.worker = FOREDRAW_WORKER}}, executor, registry,
              diagnostics);
  ASSERT_TRUE(diagnostics.empty()) << to_text(diagnostics);
  const Scene scene = scene_of({draw_of(grid(3, 3), "grid"), draw_of(sphere(8, 6), "sphere")});
  const auto plan = foredraw::plan(*parse_line("hostile-spins", diagnostics), registry, scene, diagnostics);
  ASSERT_TRUE(plan) << to_text(diagnostics);
  std::atomic<bool> cancel = false;
  std::thread canceller([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    cancel = true;
  });
  Analyses analyses;
  const auto begin = std::chrono::steady_clock::now();
  const Result result = optimize(*plan, scene, {executor, analyses, &cancel});
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  canceller.join();
  EXPECT_TRUE(result.failed);
  EXPECT_LT(taken.count(), 5);
  EXPECT_THAT(to_text(result.report.diagnostics.front()), ::testing::HasSubstr("cancelled"));
  EXPECT_THAT(workers_alive_after(1000, folder_), ::testing::IsEmpty());
}

}  // namespace
}  // namespace foredraw::testing

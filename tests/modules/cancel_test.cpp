// A run that is cancelled ends, whatever a module does meanwhile.
#include "left_behind.h"
#include "support/meshes.h"
#include "support/program.h"

#include <foredraw/modules/load_modules.h>
#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/runner.h>

#include <gmock/gmock.h>

#include <atomic>
#include <thread>

namespace foredraw::testing::modules_cancel_test::cancel_test {
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
    EXPECT_TRUE(a_worker_spins(folder_));
    cancel = true;
  });
  Analyses analyses;
  const Result result = optimize(*plan, scene, {executor, analyses, &cancel});
  canceller.join();
  EXPECT_TRUE(result.failed);
  EXPECT_THAT(to_text(result.report.diagnostics.front()), ::testing::HasSubstr("cancelled"));
  EXPECT_THAT(workers_left(folder_), ::testing::IsEmpty());
}

}  // namespace
}  // namespace foredraw::testing::modules_cancel_test::cancel_test

// Modules in a context of the library for C, in a program that lives on: whatever they do, nothing of them is left.

#include <foredraw/c/foredraw.h>

#include "left_behind.h"
#include "support/program.h"

#include <c/bumpy_sheet.h>
#include <c/handles.h>

#include <gmock/gmock.h>

#include <sys/wait.h>

#include <cerrno>
#include <cstdlib>
#include <map>
#include <thread>

namespace foredraw::testing::through_c_test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// What this process has open, by number.
std::map<std::string, std::string> descriptors() {
  std::map<std::string, std::string> open;
  std::error_code gone;  // that of the folder itself
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
    const auto target = std::filesystem::read_symlink(entry.path(), gone).string();
    if (!target.ends_with("/fd")) open[entry.path().filename().string()] = target;
  }
  return open;
}

bool has_children() { return ::waitpid(-1, nullptr, WNOHANG) != -1 || errno != ECHILD; }

class ThroughC : public InFolder, public ::testing::WithParamInterface<const char*> {
 protected:
  ThroughC() {
    ::setenv("FOREDRAW_MODULE_WORKER", FOREDRAW_WORKER, 1);
    const std::vector<std::uint32_t> indices(sheet_.indices.begin(), sheet_.indices.end());
    const std::vector<glm::vec3> places = sheet_.places();
    foredraw_draw draw{.size = sizeof draw};
    draw.vertex_count = static_cast<std::uint32_t>(places.size());
    draw.triangle_count = indices.size() / 3;
    draw.indices = indices.data();
    draw.positions = &places[0].x;
    foredraw_scene* scene = nullptr;
    const Context context(foredraw_context_new(nullptr));
    EXPECT_EQ(foredraw_make_scene(context.get(), &draw, 1, &scene, nullptr), FOREDRAW_DONE);
    scene_.reset(scene);
    EXPECT_EQ(status_of("tipsify", context.get(), expected_), FOREDRAW_DONE);
  }

  /// Runs the stages; what becomes of the draw's indices.
  int status_of(const std::string& stages, foredraw_context* context, std::vector<std::uint32_t>& indices) {
    foredraw_scene* made = nullptr;
    const int status = foredraw_optimize(context, scene_.get(), stages.c_str(), &made, nullptr);
    const SceneHandle held(made);
    foredraw_draw draw{.size = sizeof draw};
    if (made != nullptr && foredraw_scene_draw(made, 0, &draw) == FOREDRAW_DONE)
      indices.assign(draw.indices, draw.indices + 3 * draw.triangle_count);
    return status;
  }

  const BumpySheet sheet_{8};
  SceneHandle scene_;
  std::vector<std::uint32_t> expected_;  ///< of tipsify alone
};

TEST_P(ThroughC, NothingIsLeft) {
  if (is_sanitized) GTEST_SKIP() << "sanitizers have words of their own for what ends a process";
  const std::string name = GetParam();
  const auto before = descriptors();
  {
    const Context context(foredraw_context_new(nullptr));
    ASSERT_EQ(foredraw_load_module(context.get(), module_in(folder_, name).c_str(), 0, nullptr), FOREDRAW_DONE);
    for (int run = 0; run < 3; ++run) {
      std::vector<std::uint32_t> made;
      const int status = status_of("hostile-" + name + ", tipsify", context.get(), made);
      EXPECT_EQ(status, name == "forks" || name == "closes" || name == "upsets" ? FOREDRAW_DONE : FOREDRAW_FAILED);
      EXPECT_EQ(made, expected_) << "the stage changed what others make";
    }
  }
  EXPECT_THAT(workers_left(folder_), IsEmpty());
  EXPECT_FALSE(has_children());
  EXPECT_EQ(descriptors(), before);
}

INSTANTIATE_TEST_SUITE_P(Hostile, ThroughC,
                         ::testing::Values("twin", "aborts", "exits", "kills-itself", "writes-input", "forks", "closes",
                                           "upsets", "fails"),
                         [](const auto& module) {
                           std::string name = module.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST_F(ThroughC, ACancelledCallEndsAndLeavesNothing) {
  const auto before = descriptors();
  {
    const Context context(foredraw_context_new(nullptr));
    ASSERT_EQ(foredraw_load_module(context.get(), module_in(folder_, "spins").c_str(), 0, nullptr), FOREDRAW_DONE);
    std::thread canceller([&] {
      EXPECT_TRUE(a_worker_spins(folder_));
      foredraw_cancel(context.get());
    });
    std::vector<std::uint32_t> made;
    EXPECT_EQ(status_of("hostile-spins, tipsify", context.get(), made), FOREDRAW_CANCELLED);
    EXPECT_TRUE(made.empty());
    canceller.join();
  }
  EXPECT_THAT(workers_left(folder_), IsEmpty());
  EXPECT_FALSE(has_children());
  EXPECT_EQ(descriptors(), before);
}

TEST_F(ThroughC, WhatIsNoModuleIsToldAndTheOthersAreAdded) {
  const Context context(foredraw_context_new(nullptr));
  put(folder_ / "text.so", "no library\n");
  module_in(folder_, "radial");
  Told problems, missing;
  EXPECT_EQ(foredraw_load_module(context.get(), folder_.c_str(), 0, problems.out()), FOREDRAW_MISTAKE);
  EXPECT_THAT(problems.json().at("diagnostics").at(0).dump(), HasSubstr("text.so"));
  std::vector<std::uint32_t> made;
  EXPECT_EQ(status_of("acme-radial", context.get(), made), FOREDRAW_DONE);
  EXPECT_FALSE(made.empty());
  EXPECT_EQ(foredraw_load_module(context.get(), "none.so", 1, missing.out()), FOREDRAW_MISTAKE);
  EXPECT_THAT(missing.json().dump(), HasSubstr("there is no such file"));
  EXPECT_EQ(foredraw_load_module(context.get(), nullptr, 0, nullptr), FOREDRAW_NULL_POINTER);
}

}  // namespace
}  // namespace foredraw::testing::through_c_test

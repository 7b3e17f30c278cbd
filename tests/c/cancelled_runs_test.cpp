// A call that is cancelled ends in the stage at work, in whichever stage of whichever preset it is.
#include "handles.h"

#include <benchmarks/cancelled_runs/preset_scenes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

namespace foredraw::testing::cancelled_runs_test {
namespace {

const std::string source = FOREDRAW_SOURCE_DIR;

class CancelledRuns : public ::testing::TestWithParam<std::string> {
 protected:
  CancelledRuns() {
    foredraw_settings settings{};
    settings.size = sizeof settings;
    settings.threads = 1;
    settings.user = this;
    settings.progress = [](void* self, const char* what, double) {
      static_cast<CancelledRuns*>(self)->begins(what);
      return 0;
    };
    context_.reset(foredraw_context_new(&settings));
  }

  /// From another thread, as callers cancel.
  void begins(const std::string& what) {
    if (!stages_.empty() && stages_.back() == what) return;
    stages_.push_back(what);
    if (stages_.size() == cancelled_at_) std::thread([this] { foredraw_cancel(context_.get()); }).join();
  }

  /// Cancels the stage with this number, from 1 on; with 0 none.
  int run(const foredraw_scene* scene, std::size_t cancelled_at) {
    stages_.clear();
    cancelled_at_ = cancelled_at;
    return foredraw_optimize(context_.get(), scene, ("@" + GetParam()).c_str(), nullptr, nullptr);
  }

  Context context_;
  std::vector<std::string> stages_;  ///< those that began
  std::size_t cancelled_at_ = 0;
};

TEST_P(CancelledRuns, EndInTheStageAtWork) {
  const SceneHandle scene(bench::scene_for(context_.get(), GetParam(), source + "/benchmarks/corpus/", 16));
  ASSERT_EQ(run(scene.get(), 0), FOREDRAW_DONE);
  const std::vector<std::string> all = stages_;
  ASSERT_GT(all.size(), 1u);
  for (std::size_t i = 1; i <= all.size(); ++i) {
    EXPECT_EQ(run(scene.get(), i), FOREDRAW_CANCELLED) << all[i - 1];
    EXPECT_EQ(stages_, std::vector<std::string>(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(i)));
  }
}

std::vector<std::string> presets() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(source + "/framework/presets")) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Presets, CancelledRuns, ::testing::ValuesIn(presets()), [](const auto& preset) {
  std::string name = preset.param;
  std::ranges::replace(name, '-', '_');
  return name;
});

}  // namespace
}  // namespace foredraw::testing::cancelled_runs_test

// How long a run goes on after it was cancelled from another thread, in each stage of each preset:
//   cancelled-runs-bench CORPUS PRESETS...
// Seconds are the processor's.

#include "preset_scenes.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <ctime>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace {

using namespace foredraw::bench;

/// Processor seconds of this process: elapsed time says nothing on a machine with other work.
double seconds_worked() {
  std::timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Cancels from a thread of its own, so long after a stage began.
class Canceller {
 public:
  Canceller(foredraw_context* context, std::string stage, double after)
      : context_(context), stage_(std::move(stage)), after_(after), thread_([this] { wait(); }) {}
  ~Canceller() {
    {
      const std::lock_guard lock(mutex_);
      is_over_ = true;
    }
    changed_.notify_all();
    thread_.join();
  }

  void begins(const std::string& what) {
    const std::lock_guard lock(mutex_);
    has_begun_ = has_begun_ || what == stage_;
    changed_.notify_all();
  }
  /// Processor time when it cancelled; below 0: it did not.
  double moment() const { return moment_; }

 private:
  void wait() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return has_begun_ || is_over_; });
    const double begin = seconds_worked();
    while (!is_over_ && seconds_worked() < begin + after_) changed_.wait_for(lock, std::chrono::milliseconds(2));
    if (is_over_) return;
    moment_ = seconds_worked();
    foredraw_cancel(context_);
  }

  foredraw_context* context_;
  std::string stage_;
  double after_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool has_begun_ = false, is_over_ = false;
  std::atomic<double> moment_ = -1;
  std::thread thread_;
};

class Runs {
 public:
  using Stages = std::vector<std::pair<std::string, double>>;

  Runs() {
    foredraw_settings settings{};
    settings.size = sizeof settings;
    settings.threads = 1;
    settings.user = this;
    settings.progress = [](void* self, const char* what, double) {
      static_cast<Runs*>(self)->begins(what);
      return 0;
    };
    context_.reset(foredraw_context_new(&settings));
  }

  foredraw_context* context() const { return context_.get(); }

  /// The stages of a run, and how long each takes.
  Stages stages(const foredraw_scene* scene, const std::string& preset) {
    run(scene, preset);
    const double end = seconds_worked();
    Stages stages = stages_;
    for (std::size_t i = 0; i < stages.size(); ++i) {
      stages[i].second = (i + 1 < stages.size() ? stages[i + 1].second : end) - stages[i].second;
    }
    return stages;
  }

  /// Seconds from the cancel to the end of the run; below 0 if the run was over before.
  double cancelled(const foredraw_scene* scene, const std::string& preset, const std::string& stage, double after) {
    Canceller canceller(context(), stage, after);
    canceller_ = &canceller;
    run(scene, preset);
    const double end = seconds_worked();
    canceller_ = nullptr;
    return canceller.moment() < 0 ? -1 : end - canceller.moment();
  }

 private:
  void begins(const std::string& what) {
    if (stages_.empty() || stages_.back().first != what) stages_.emplace_back(what, seconds_worked());
    if (canceller_ != nullptr) canceller_->begins(what);
  }
  void run(const foredraw_scene* scene, const std::string& preset) {
    stages_.clear();
    foredraw_optimize(context(), scene, ("@" + preset).c_str(), nullptr, nullptr);
  }

  struct Free {
    void operator()(foredraw_context* context) const { foredraw_context_free(context); }
  };
  std::unique_ptr<foredraw_context, Free> context_;
  Stages stages_;  ///< those that began, and when
  Canceller* canceller_ = nullptr;
};

/// The stages before the one that is cancelled run each time, which takes minutes if several are slow.
std::uint32_t size_for(const std::string& preset) {
  if (preset == "levels" || preset == "simplify" || preset == "displaced") return 100;
  return preset == "crowd" || preset == "walk" ? 150 : 400;
}

void print_times(const std::string& preset, const std::string& corpus) {
  Runs runs;
  foredraw_scene* scene = scene_for(runs.context(), preset, corpus, size_for(preset));
  for (const auto& [stage, seconds] : runs.stages(scene, preset)) {
    constexpr double worth_cancelling = 0.1;
    if (seconds < worth_cancelling) continue;
    double longest = -1;
    for (const double part : {0.1, 0.35, 0.6, 0.85}) {
      longest = std::max(longest, runs.cancelled(scene, preset, stage, part * seconds));
    }
    std::printf("@%-12s %-40s %7.2f s; after a cancel at most %5.3f s\n", preset.c_str(), stage.c_str(), seconds,
                longest);
    std::fflush(stdout);
  }
  foredraw_scene_free(scene);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return std::fputs("cancelled-runs-bench CORPUS PRESETS...\n", stderr), 1;
  for (int i = 2; i < argc; ++i) print_times(argv[i], argv[1] + std::string("/"));
}

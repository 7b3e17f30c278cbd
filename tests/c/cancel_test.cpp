// A call that is cancelled from another thread ends within a second, in whichever stage of whichever preset it is.
// Seconds are the processor's.
#include "handles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <mutex>
#include <thread>
#include <vector>

namespace foredraw::testing {
namespace {

const std::string source = FOREDRAW_SOURCE_DIR;
const std::string corpus = source + "/benchmarks/corpus/";

/// Of the process: on a machine that does other things besides, a second of the clock says nothing.
double seconds_worked() {
  std::timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

struct Mesh {
  std::vector<float> positions, normals, texcoords;
  std::vector<std::uint32_t> indices;
};

/// A bumpy torus of 2 * n * n triangles, in an order that no cache likes.
struct Ring : Mesh {
  explicit Ring(std::uint32_t n) {
    constexpr float turn = 6.2831853f;
    for (std::uint32_t i = 0; i < n * n; ++i) {
      const float u = turn * static_cast<float>(i / n) / static_cast<float>(n);
      const float v = turn * static_cast<float>(i % n) / static_cast<float>(n);
      const float radius = 0.4f + 0.02f * std::sin(9 * u) * std::sin(7 * v);
      for (const float value :
           {(1 + radius * std::cos(v)) * std::cos(u), radius * std::sin(v), (1 + radius * std::cos(v)) * std::sin(u)}) {
        positions.push_back(value);
      }
      for (const float value : {std::cos(v) * std::cos(u), std::sin(v), std::cos(v) * std::sin(u)}) {
        normals.push_back(value);
      }
      texcoords.push_back(u / turn), texcoords.push_back(v / turn);
    }
    constexpr std::uint64_t stride = 2654435761u;  // prime to every n * n here
    for (std::uint64_t k = 0; k < std::uint64_t{n} * n; ++k) {
      const auto i = static_cast<std::uint32_t>(k * stride % (std::uint64_t{n} * n));
      const std::uint32_t row = i / n, column = i % n;
      const std::uint32_t b = (row + 1) % n * n + column, c = row * n + (column + 1) % n;
      const std::uint32_t d = (row + 1) % n * n + (column + 1) % n;
      for (const std::uint32_t corner : {i, c, b, b, c, d}) indices.push_back(corner);
    }
  }
};

/// So many wires beside each other, of 720 triangles each.
struct Wires : Mesh {
  explicit Wires(std::uint32_t count) {
    constexpr std::uint32_t sides = 6, rings = 61;
    constexpr float turn = 6.2831853f, radius = 0.01f;
    for (std::uint32_t i = 0; i < count * rings * sides; ++i) {
      const auto wire = static_cast<float>(i / (rings * sides)), ring = static_cast<float>(i / sides % rings);
      const float angle = turn * static_cast<float>(i % sides) / sides;
      const float x = std::cos(angle), y = std::sin(angle);
      for (const float value : {wire + radius * x, 0.1f * std::sin(0.1f * ring) + radius * y, 0.1f * ring}) {
        positions.push_back(value);
      }
      for (const float value : {x, y, 0.0f}) normals.push_back(value);
      texcoords.push_back(angle / turn), texcoords.push_back(ring / rings);
      if (i / sides % rings + 1 == rings) continue;
      const std::uint32_t beside = i / sides * sides + (i + 1) % sides;
      for (const std::uint32_t corner : {i, beside, i + sides, i + sides, beside, beside + sides}) {
        indices.push_back(corner);
      }
    }
  }
};

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

  void begins(const std::string& what) {
    if (stages_.empty() || stages_.back().first != what) stages_.emplace_back(what, seconds_worked());
    if (canceller_ != nullptr) canceller_->begins(what);
  }

  SceneHandle read(const std::string& path) {
    foredraw_scene* scene = nullptr;
    EXPECT_EQ(foredraw_read(context_.get(), path.c_str(), &scene, nullptr), FOREDRAW_DONE) << path;
    return SceneHandle(scene);
  }

  SceneHandle scene_of(const Mesh& mesh) {
    const foredraw_stream streams[] = {{"NORMAL", mesh.normals.data(), 0, FOREDRAW_FLOAT32, 3, 0},
                                       {"TEXCOORD_0", mesh.texcoords.data(), 0, FOREDRAW_FLOAT32, 2, 0}};
    foredraw_draw draw{};
    draw.size = sizeof draw;
    draw.vertex_count = static_cast<std::uint32_t>(mesh.positions.size() / 3);
    draw.triangle_count = mesh.indices.size() / 3;
    draw.indices = mesh.indices.data();
    draw.positions = mesh.positions.data();
    draw.streams = streams;
    draw.stream_count = 2;
    foredraw_scene* scene = nullptr;
    EXPECT_EQ(foredraw_make_scene(context_.get(), &draw, 1, &scene, nullptr), FOREDRAW_DONE);
    return SceneHandle(scene);
  }

  /// The stages before the one that is cancelled run each time, which takes minutes where several are slow. Then a
  /// scene of a quarter has to end in a quarter of the time: a stretch that hears nothing grows with the scene.
  static bool is_smaller(const std::string& preset) { return preset == "levels" || preset == "simplify"; }

  /// One that has something to do for every stage of the preset, and a good while of it.
  SceneHandle scene_for(const std::string& preset) {
    if (preset == "sprites") return read(corpus + "particles/atlas_smoke15frames.json");
    if (preset == "character") return read(corpus + "animated/cesium_man_notex.glb");
    if (preset == "city") return read(corpus + "scenes/house.glb");
    if (preset == "wires") return scene_of(Wires(2000));
    if (is_smaller(preset)) return scene_of(Ring(100));
    if (preset != "displaced") return scene_of(Ring(preset == "crowd" || preset == "walk" ? 150 : 400));
    const SceneHandle plain = scene_of(Ring(100));
    const std::string pipeline = "displacement(map=\"" + corpus + "particles/kenney_dirt_03.png\")";
    foredraw_scene* displaced = nullptr;
    Told report;
    EXPECT_EQ(foredraw_optimize(context_.get(), plain.get(), pipeline.c_str(), &displaced, report.out()), FOREDRAW_DONE)
        << report.json();
    return SceneHandle(displaced);
  }

  int run(const foredraw_scene* scene, const std::string& preset) {
    stages_.clear();
    return foredraw_optimize(context_.get(), scene, ("@" + preset).c_str(), nullptr, nullptr);
  }

  Context context_;
  std::vector<std::pair<std::string, double>> stages_;  ///< which began, and when
  Canceller* canceller_ = nullptr;
};

TEST_P(CancelledRuns, EndWithinASecondInEveryStage) {
  const SceneHandle scene = scene_for(GetParam());
  ASSERT_TRUE(scene);
  ASSERT_EQ(run(scene.get(), GetParam()), FOREDRAW_DONE);
  std::vector<std::pair<std::string, double>> stages = stages_;  // now how long each took
  for (std::size_t i = 0; i < stages.size(); ++i) {
    stages[i].second = (i + 1 < stages.size() ? stages[i + 1].second : seconds_worked()) - stages[i].second;
  }
  const double allowed = is_smaller(GetParam()) ? 0.25 : 1;
  const double worth_cancelling = 0.3 * allowed;
  std::size_t cancelled = 0;
  for (const auto& [stage, seconds] : stages) {
    if (seconds < worth_cancelling) continue;
    for (const double part : {0.1, 0.35, 0.6, 0.85}) {
      Canceller canceller(context_.get(), stage, part * seconds);
      canceller_ = &canceller;
      const int status = run(scene.get(), GetParam());
      canceller_ = nullptr;
      if (canceller.moment() < 0) continue;  // it was faster this time
      EXPECT_EQ(status, FOREDRAW_CANCELLED) << stage;
      EXPECT_LT(seconds_worked() - canceller.moment(), allowed)
          << stage << ", after " << part << " of " << seconds << " s";
      ++cancelled;
    }
  }
  std::printf("%zu of %zu stages take long; cancelled %zu times\n",
              static_cast<std::size_t>(
                  std::ranges::count_if(stages, [&](const auto& s) { return s.second >= worth_cancelling; })),
              stages.size(), cancelled);
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
}  // namespace foredraw::testing

#include "lod_walk.h"

#include <foredraw/base/random.h>
#include <foredraw/frames/unhidden_objects.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace foredraw {

namespace {

using evaluators::lod_walk::FrameWays;
using evaluators::lod_walk::LevelChooser;
using evaluators::lod_walk::MeshWays;
using evaluators::lod_walk::Method;
using evaluators::lod_walk::WayName;

constexpr double nanoseconds_a_millisecond = 1e6;

/// Runs the work and answers with how many milliseconds it took.
template <class Work>
double milliseconds_of(const Work& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

/// What frames of the path cost before anything is chosen: nanoseconds of the objects in the mean over the path.
struct PathCosts {
  static constexpr int sizes = 81;
  static double size_of(int number) { return std::exp2((number - 48) / 4.0); }  // pixels of a triangle

  double full = 0;
  std::vector<double> of_frame;              ///< [frame] in full detail
  std::vector<std::vector<double>> by_size;  ///< [frame][size]
};

/// What it is to walk: everything that does not depend on the method.
class Walker {
 public:
  Walker(const FrameScene& scene, const CameraPath& path, FrameSize size, const LodWalkOptions& options,
         const Executor& executor, const std::atomic<bool>* cancel)
      : scene_(scene),
        path_(path),
        size_(size),
        options_(options),
        executor_(executor),
        cancel_(cancel),
        meshes_(evaluators::lod_walk::mesh_ways(
            scene, frame_moment(scene, path.empty() ? 0 : path.front().seconds),
            options.renderings || options.accuracy == evaluators::lod_walk::Accuracy::pictures, executor)),
        places_(scene.objects().size(), glm::vec2(std::nanf(""))) {}

  std::optional<LodWalk> walk(const std::function<void(double)>& progress) {
    prepare();
    for (std::size_t frame = 0; frame < path_.size(); ++frame) {
      if (is_cancelled()) return std::nullopt;
      show(frame);
      if (progress) progress(static_cast<double>(frame + 1) / static_cast<double>(path_.size()));
    }
    if (is_cancelled()) return std::nullopt;  // in the last one
    return std::move(walk_);
  }

 private:
  struct Walking {
    std::unique_ptr<LevelChooser> chooser;
    std::vector<WayName> last;  // [object]
  };

  bool is_cancelled() const { return cancel_ != nullptr && cancel_->load(std::memory_order_relaxed); }

  const MeshWays& mesh_of(const SeenObject& object) const { return meshes_[scene_.objects()[object.object].mesh]; }

  FrameWays ways_of(std::vector<SeenObject> seen, const std::vector<float>& speeds) const {
    return evaluators::lod_walk::frame_ways(scene_, meshes_, std::move(seen), speeds, options_.costs, options_,
                                            options_.renderings);
  }

  std::vector<SeenObject> seen_in(const FrameMoment& moment, std::size_t frame) const {
    std::vector<SeenObject> seen = seen_objects(scene_, moment, path_[frame].camera, size_);
    if (!options_.occlusion) return seen;
    return unhidden_objects(scene_, moment, path_[frame].camera, size_, std::move(seen));
  }

  PathCosts path_costs() const {
    PathCosts costs;
    costs.of_frame.resize(path_.size());
    costs.by_size.assign(path_.size(), std::vector<double>(PathCosts::sizes));
    executor_.for_each(path_.size(), [&](std::size_t frame) {
      if (is_cancelled()) return;
      std::vector<SeenObject> seen = seen_in(frame_moment(scene_, path_[frame].seconds), frame);
      const std::vector<float> at_rest(seen.size(), 0);
      const FrameWays ways = ways_of(std::move(seen), at_rest);
      for (std::size_t i = 0; i < ways.seen.size(); ++i) {
        const MeshWays& mesh = mesh_of(ways.seen[i]);
        std::vector<double> of_level;
        for (std::uint32_t level = 0; level < mesh.levels.size(); ++level) {
          const std::uint32_t way = evaluators::lod_walk::way_of(ways, i, {level, Rendering::full});
          of_level.push_back(ways.ways[ways.first[i] + way].cost);
        }
        costs.of_frame[frame] += of_level.front();
        for (int size = 0; size < PathCosts::sizes; ++size) {
          costs.by_size[frame][static_cast<std::size_t>(size)] +=
              of_level[evaluators::lod_walk::level_by_size(mesh, ways.seen[i].pixels, PathCosts::size_of(size))];
        }
      }
    });
    for (const double cost : costs.of_frame) costs.full += cost / static_cast<double>(path_.size());
    return costs;
  }

  /// The smallest size at which `static` costs, in the mean, no more than frames within the budget can.
  double static_pixels(const PathCosts& costs, double budget) const {
    double allowed = 0;
    for (const double cost : costs.of_frame) allowed += std::min(cost, budget);
    for (int size = 0; size < PathCosts::sizes; ++size) {
      double sum = 0;
      for (const std::vector<double>& of_frame : costs.by_size) sum += of_frame[static_cast<std::size_t>(size)];
      if (sum <= allowed) return PathCosts::size_of(size);
    }
    return PathCosts::size_of(PathCosts::sizes - 1);
  }

  void prepare() {
    const PathCosts costs = path_costs();
    const double full = (costs.full + options_.costs.frame) / nanoseconds_a_millisecond;
    walk_.budget = options_.budget.value_or(options_.share * full);
    budget_ = std::max(0.0, walk_.budget * nanoseconds_a_millisecond - options_.costs.frame);
    walk_.pixels = options_.pixels.value_or(static_pixels(costs, budget_));
    walk_.replay_size = {std::max(1, size_.width / 4), std::max(1, size_.height / 4)};
    for (const Method method : options_.methods) {
      walk_.methods.push_back({method});
      walking_.push_back(
          {evaluators::lod_walk::level_chooser(method, scene_, meshes_, {budget_, walk_.pixels, options_.hysteresis}),
           std::vector<WayName>(scene_.objects().size(), {evaluators::lod_walk::not_seen, Rendering::full})});
    }
  }

  /// Whether the frame is one of so many, evenly over the path.
  bool is_one_of(std::size_t frame, int count) const {
    const auto parts = static_cast<std::size_t>(std::max(count, 0));
    return (frame + 1) * parts / path_.size() != frame * parts / path_.size();
  }

  void show(std::size_t frame) {
    const FrameMoment moment = frame_moment(scene_, path_[frame].seconds);
    std::vector<SeenObject> seen = seen_in(moment, frame);
    std::uint32_t seen_again = 0;
    const std::vector<float> speeds = speeds_of(seen, seen_again);
    const FrameWays ways = ways_of(std::move(seen), speeds);
    walk_.seen.push_back(static_cast<std::uint32_t>(ways.seen.size()));
    walk_.seen_again.push_back(seen_again);
    std::uint64_t triangles = 0;
    for (const SeenObject& object : ways.seen) triangles += mesh_of(object).triangles.front();
    walk_.triangles.push_back(triangles);
    find_bound(ways);
    std::vector<std::vector<DrawnObject>> drawn;
    for (std::size_t m = 0; m < walking_.size(); ++m) drawn.push_back(choose(m, frame, ways, moment));
    if (is_one_of(frame, options_.pictures)) compare_pictures(frame, moment, drawn);
    if (options_.replay) add_to_replay(frame, moment, drawn);
  }

  /// Pixels a frame that each object has moved over the picture.
  std::vector<float> speeds_of(const std::vector<SeenObject>& seen, std::uint32_t& seen_again) {
    std::vector<float> speeds;
    std::vector<glm::vec2> places(places_.size(), glm::vec2(std::nanf("")));
    for (const SeenObject& object : seen) {
      const glm::vec2 moved = object.place - places_[object.object];
      const float speed = std::sqrt(glm::dot(moved, moved));
      const bool was_seen = speed == speed;
      seen_again += was_seen ? 1 : 0;
      speeds.push_back(was_seen ? speed : 0);
      places[object.object] = object.place;
    }
    places_ = std::move(places);
    return speeds;
  }

  void find_bound(const FrameWays& ways) {
    const foredraw_lod_scene scene = ways.scene(ways.ways);
    std::vector<std::uint32_t> chosen(ways.seen.size());
    memory_.resize(foredraw_lod_memory(&scene) / sizeof(std::uint64_t) + 1);
    const foredraw_lod_result best =
        foredraw_lod_select(&scene, static_cast<std::uint64_t>(budget_), chosen.data(), memory_.data());
    walk_.bound.push_back(static_cast<double>(best.bound));
    walk_.is_over.push_back(best.is_over != 0);
  }

  std::vector<DrawnObject> choose(std::size_t m, std::size_t frame, const FrameWays& ways, const FrameMoment& moment) {
    Walking& walking = walking_[m];
    MethodWalk& result = walk_.methods[m];
    std::vector<std::uint32_t> chosen;
    result.selecting.push_back(milliseconds_of([&] { chosen = walking.chooser->choose(ways, walking.last); }));
    double cost = 0, benefit = 0;
    std::uint32_t switched = 0;
    std::uint64_t triangles = 0;
    std::vector<WayName> now(walking.last.size(), {evaluators::lod_walk::not_seen, Rendering::full});
    std::vector<DrawnObject> drawn;
    evaluators::lod_walk::SummedWork work(options_.costs);
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      const std::uint32_t way = ways.first[i] + chosen[i], object = ways.seen[i].object;
      cost += ways.ways[way].cost;
      benefit += ways.ways[way].benefit;
      const WayName& before = walking.last[object];
      switched += before.level != evaluators::lod_walk::not_seen && before != ways.names[way] ? 1 : 0;
      now[object] = ways.names[way];
      drawn.push_back({object, ways.names[way].level, ways.names[way].rendering});
      triangles += mesh_of(ways.seen[i]).triangles[ways.names[way].level];
      work.add(evaluators::lod_walk::work_of(mesh_of(ways.seen[i]), ways.names[way], ways.seen[i],
                                             scene_.objects()[object].is_posed));
    }
    walking.last = std::move(now);
    const double model = (cost + options_.costs.frame) / nanoseconds_a_millisecond;
    Random random(derive_seed(options_.seed, frame, m));
    double took = model * (1 + options_.noise * (2 * random.unit() - 1));
    if (options_.timer) {
      const double nanoseconds = options_.timer(moment, path_[frame].camera, drawn);
      result.samples.push_back({work.drawn(), nanoseconds});
      took = nanoseconds / nanoseconds_a_millisecond;
    }
    walking.chooser->took(took * nanoseconds_a_millisecond - options_.costs.frame);
    result.model.push_back(model);
    result.milliseconds.push_back(took);
    result.benefit.push_back(benefit);
    result.triangles.push_back(triangles);
    result.switched.push_back(switched);
    return drawn;
  }

  void compare_pictures(std::size_t frame, const FrameMoment& moment,
                        const std::vector<std::vector<DrawnObject>>& drawn) {
    std::vector<FramePicture> pictures(drawn.size());
    FrameTruth truth;
    executor_.for_each(drawn.size() + 1, [&](std::size_t i) {
      if (is_cancelled()) return;
      if (i == 0) {
        truth = frame_truth(scene_, moment, path_[frame].camera, size_, options_.samples);
        return;
      }
      ReferenceRenderer renderer(size_, options_.samples);
      renderer.draw(scene_, moment, path_[frame].camera, drawn[i - 1]);
      pictures[i - 1] = renderer.picture();
    });
    if (is_cancelled()) return;
    walk_.floors.push_back(truth.floor);
    for (std::size_t m = 0; m < drawn.size(); ++m) {
      walk_.methods[m].errors.push_back(picture_error(pictures[m], truth.picture));
    }
  }

  void add_to_replay(std::size_t frame, const FrameMoment& moment, const std::vector<std::vector<DrawnObject>>& drawn) {
    std::vector<std::vector<std::uint8_t>> pictures(drawn.size());
    executor_.for_each(drawn.size(), [&](std::size_t m) {
      if (is_cancelled()) return;
      ReferenceRenderer renderer(walk_.replay_size, 2);
      renderer.draw(scene_, moment, path_[frame].camera, drawn[m], FrameStyle::levels);
      pictures[m] = as_rgb(renderer.picture());
    });
    for (std::size_t m = 0; m < drawn.size(); ++m) walk_.methods[m].replay.push_back(std::move(pictures[m]));
  }

  const FrameScene& scene_;
  const CameraPath& path_;
  const FrameSize size_;
  const LodWalkOptions& options_;
  const Executor& executor_;
  const std::atomic<bool>* cancel_;
  std::vector<MeshWays> meshes_;
  std::vector<glm::vec2> places_;  // [object] in the last frame; not a number where it was not seen
  double budget_ = 0;              // nanoseconds of the objects of a frame
  std::vector<Walking> walking_;   // [method]
  std::vector<std::uint64_t> memory_;
  LodWalk walk_;
};

}  // namespace

std::optional<LodWalk> lod_walk(const FrameScene& scene, const CameraPath& path, FrameSize size,
                                const LodWalkOptions& options, const Executor& executor,
                                const std::atomic<bool>* cancel, const std::function<void(double)>& progress) {
  return Walker(scene, path, size, options, executor, cancel).walk(progress);
}

}  // namespace foredraw

#include "antialiasing.h"

#include <algorithm>
#include <cmath>

namespace foredraw {

namespace {

using evaluators::antialiasing::PixelMask;
using evaluators::antialiasing::Sum;
using evaluators::antialiasing::Way;

/// What a way comes to in one view.
struct ViewSums {
  Sum errors, flicker, broken, ink;
};

/// The pictures of one frame.
struct FramePictures {
  SampledPicture truth;
  PixelMask touched;
  std::vector<SampledPicture> ways;
};

/// f(sum of all views), and how far it moves where one view is left out.
template <class Value>
AntialiasingFigure figure(const std::vector<Sum>& views, Value value) {
  Sum all;
  for (const Sum& view : views) all += view;
  const double whole = value(all), n = static_cast<double>(views.size());
  double squares = 0;
  for (const Sum& view : views) {
    const double without = value(Sum{all.value - view.value, all.of - view.of});
    squares += (without - whole) * (without - whole);
  }
  return {whole, views.size() < 2 ? 0 : std::sqrt(squares * (n - 1) / n)};
}

double root(const Sum& sum) { return std::sqrt(std::max(0.0, sum.mean())); }

bool has_wires(const FrameScene& scene) {
  return std::ranges::any_of(scene.objects(), [&](const PlacedObject& object) {
    const FrameMesh& mesh = scene.mesh_of(static_cast<std::size_t>(&object - scene.objects().data()));
    return std::ranges::any_of(mesh.draws, [](const FrameDraw& draw) { return !draw.levels.front().wires.empty(); });
  });
}

/// Draws one view after another, and sums up.
class Contest {
 public:
  Contest(const FrameScene& scene, const FrameMoment& moment, const AntialiasingOptions& options)
      : scene_(scene), moment_(moment), options_(options) {
    found_.has_wires = has_wires(scene);
    for (const Way way : options.ways) {
      if (evaluators::antialiasing::is_for_wires(way) && !found_.has_wires) continue;
      if (way == Way::second_depth && options.closed == nullptr) continue;
      found_.ways.push_back({.way = way, .rmse = {}, .flicker = {}, .broken = {}, .ink = {}, .picture = {}});
    }
    sums_.resize(found_.ways.size());
  }

  /// How many pictures a frame has.
  std::size_t pictures() const { return 1 + found_.ways.size(); }

  void draw(const FrameCamera& camera, std::size_t picture, FramePictures& to) const {
    const auto objects = seen(camera);
    const evaluators::antialiasing::Frame frame{scene_, moment_, camera, options_.size, objects, options_.closed};
    if (picture == 0) {
      to.truth = truth(frame, false);
      to.touched = evaluators::antialiasing::touched_pixels(to.truth);
    } else {
      to.ways[picture - 1] = evaluators::antialiasing::picture_of(frame, found_.ways[picture - 1].way);
    }
  }

  void add_view(const std::vector<FrameCamera>& cameras, const std::vector<FramePictures>& frames) {
    const auto objects = seen(cameras.front());
    const evaluators::antialiasing::Frame first{scene_,        moment_, cameras.front(),
                                                options_.size, objects, options_.closed};
    floors_.push_back(evaluators::antialiasing::squared_errors(truth(first, true).picture, frames.front().truth.picture,
                                                               frames.front().touched));
    for (std::size_t w = 0; w < found_.ways.size(); ++w) {
      ViewSums sums;
      for (std::size_t f = 0; f < frames.size(); ++f) {
        const FramePictures& frame = frames[f];
        sums.errors +=
            evaluators::antialiasing::squared_errors(frame.ways[w].picture, frame.truth.picture, frame.touched);
        sums.broken += evaluators::antialiasing::broken_pixels(frame.ways[w], frame.truth);
        sums.ink += evaluators::antialiasing::ink(frame.ways[w], frame.truth);
        if (f == 0) continue;
        const FramePictures& before = frames[f - 1];
        sums.flicker += evaluators::antialiasing::squared_flicker(
            before.ways[w].picture, frame.ways[w].picture, before.truth.picture, frame.truth.picture,
            evaluators::antialiasing::both(before.touched, frame.touched));
      }
      if (sums_[w].empty()) found_.ways[w].picture = frames.front().ways[w].picture;
      sums_[w].push_back(sums);
    }
    if (found_.truth.colours.empty()) found_.truth = frames.front().truth.picture;
    for (const FramePictures& frame : frames) {
      touched_ +=
          {static_cast<double>(std::ranges::count(frame.touched, true)), static_cast<double>(frame.touched.size())};
    }
  }

  Antialiasing found() {
    found_.floor = figure(floors_, root);
    found_.touched = touched_.mean();
    for (std::size_t w = 0; w < found_.ways.size(); ++w) {
      const auto of = [&](Sum ViewSums::*member, auto value) {
        std::vector<Sum> views;
        for (const ViewSums& sums : sums_[w]) views.push_back(sums.*member);
        return figure(views, value);
      };
      Antialiasing::OfWay& way = found_.ways[w];
      way.rmse = of(&ViewSums::errors, root);
      way.flicker = of(&ViewSums::flicker, root);
      way.broken = of(&ViewSums::broken, [](const Sum& sum) { return sum.mean(); });
      way.ink = of(&ViewSums::ink, [](const Sum& sum) { return sum.of > 0 ? sum.value / sum.of - 1 : 0; });
    }
    return std::move(found_);
  }

 private:
  std::vector<DrawnObject> seen(const FrameCamera& camera) const {
    std::vector<DrawnObject> objects;
    for (const SeenObject& object : seen_objects(scene_, moment_, camera, options_.size)) {
      objects.push_back({object.object, 0, options_.rendering});
    }
    return objects;
  }

  SampledPicture truth(const evaluators::antialiasing::Frame& frame, bool other) const {
    return sampled_picture(scene_, moment_, frame.camera, frame.size, frame.objects,
                           hammersley_places(options_.truth_samples, other), {.marks_wires = true});
  }

  const FrameScene& scene_;
  const FrameMoment& moment_;
  const AntialiasingOptions& options_;
  Antialiasing found_;
  std::vector<std::vector<ViewSums>> sums_;  // [way][view]
  std::vector<Sum> floors_;                  // [view]
  Sum touched_;
};

}  // namespace

std::optional<Antialiasing> antialiasing(const FrameScene& scene, const FrameMoment& moment, const SlidingViews& views,
                                         const AntialiasingOptions& options, const Executor& executor,
                                         const std::atomic<bool>* cancel, const std::function<void(double)>& progress) {
  const auto is_cancelled = [&] { return cancel != nullptr && cancel->load(std::memory_order_relaxed); };
  Contest contest(scene, moment, options);
  std::size_t done = 0, all = 0;
  for (const auto& view : views) all += view.size();
  for (const auto& view : views) {
    std::vector<FramePictures> frames(view.size());
    for (FramePictures& frame : frames) frame.ways.resize(contest.pictures() - 1);
    executor.for_each(view.size() * contest.pictures(), [&](std::size_t i) {
      // Truths first: they take the longest.
      const std::size_t frame = i % view.size(), picture = i / view.size();
      if (!is_cancelled()) contest.draw(view[frame], picture, frames[frame]);
    });
    if (is_cancelled()) return std::nullopt;
    contest.add_view(view, frames);
    done += view.size();
    if (progress) progress(static_cast<double>(done) / static_cast<double>(all));
  }
  return contest.found();
}

}  // namespace foredraw

#include "surface_error.h"

#include <foredraw/geometry/finite.h>
#include <foredraw/technique/plugin.h>
#include <foredraw/viewing/displaced_draw.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <string>

namespace foredraw {

namespace {

/// Of the box around what is finite of the triangles; 0 where nothing is.
double diagonal_of(const Surface& surface) {
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high(-low);
  for (const std::uint32_t v : surface.indices) {
    const glm::dvec3 p(surface.positions[v]);
    if (!is_finite(p)) continue;
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  return low.x <= high.x ? glm::length(high - low) : 0;
}

/// Of a draw's own triangles, where they lie in its own space, they are kept.
std::shared_ptr<const ClosestPoints> points_of(const SeenSurface& seen, const Level& level, bool is_own_space,
                                               Analyses& analyses) {
  if (!seen.displaced && is_own_space) return closest_points_of(analyses, *level.vertices, level.stream().indices);
  return std::make_shared<const ClosestPoints>(Surface{seen.positions, seen.indices});
}

/// Over poses, each by its weight.
class PosedError {
 public:
  void add(const SurfaceError& error, double weight) {
    const Sampled rms = error.rms();
    weight_ += weight;
    squares_ += weight * rms.value * rms.value;
    variance_ += weight * weight * rms.value * rms.value * rms.error * rms.error;
    found_ = std::max(found_, error.found());
    largest_ = std::max(largest_, error.largest());
  }

  void measure(const Run& run, double unit) const {
    const double rms = std::sqrt(squares_ / weight_);
    run.measure("posed.rms", rms, unit, rms > 0 ? std::sqrt(variance_) / (rms * weight_ * unit) : 0);
    run.measure("posed.largest", largest_, unit);
    run.measure("posed.found", found_, unit);
  }

 private:
  double weight_ = 0, squares_ = 0, variance_ = 0, found_ = 0, largest_ = 0;
};

void measure(const Run& run, const std::string& metric, const Sampled& figure, double unit) {
  run.measure(metric, figure.value, unit, unit > 0 ? figure.error / unit : 0);
}

void measure(const Run& run, const std::string& way, const OneWayError& error, double unit) {
  measure(run, way + "rms", error.rms, unit);
  measure(run, way + "mean", error.mean, unit);
  measure(run, way + "p99", error.p99, unit);
  run.measure(way + "largest", error.largest, unit);
  run.measure(way + "found", error.found, unit);
}

class SurfaceErrorEvaluator final : public DrawEvaluator {
 public:
  explicit SurfaceErrorEvaluator(const SurfaceErrorOptions& options) : options_(options) {}

  void evaluate(const DrawView& draw, Run& run) const override {
    const Scene& original = run.original != nullptr ? *run.original : draw.scene;
    if (draw.id >= original.draws.size() || original.draws[draw.id].topology != Topology::triangles) {
      return run.note("no-original", "the scene that the run began with has no such draw to compare it with");
    }
    at_rest(draw, original, run);
    if (draw.draw().traits.has(traits::animated)) in_poses(draw, original, run);
  }

 private:
  void at_rest(const DrawView& draw, const Scene& original, Run& run) const {
    const SubjectPart part{draw.id, {}};
    const SeenSurface before = seen_surface(original, part, {}, run.analyses);
    SeenSurface now = seen_surface(draw.scene, part, {}, run.analyses);
    const DrawSpace &space = draw.draw().space, &space_before = original.draws[draw.id].space;
    for (glm::vec3& position : now.positions) position = position_in(space_before, space, position);
    const Surface from{before.positions, before.indices};
    const auto of_original = points_of(before, original.draws[draw.id].full(), true, run.analyses);
    const auto of_draw = points_of(now, draw.draw().full(), space == space_before, run.analyses);
    const auto error = surface_error({{now.positions, now.indices}, *of_draw}, {from, *of_original}, options_, run.seed,
                                     run.executor, run.cancel);
    if (!error)
      return run.note("nothing-left", "only one of the draw and its original has triangles with finite positions");
    const double unit = diagonal_of(from) / 100;
    measure(run, "rms", error->rms(), unit);
    measure(run, "mean", error->mean(), unit);
    measure(run, "p99", error->p99(), unit);
    run.measure("largest", error->largest(), unit);
    run.measure("found", error->found(), unit);
    measure(run, "to-original.", error->to_original, unit);
    measure(run, "from-original.", error->from_original, unit);
  }

  void in_poses(const DrawView& draw, const Scene& original, Run& run) const {
    const auto now = shown_part(draw.scene, draw.id), before = shown_part(original, draw.id);
    if (!now || !before) return;
    PosedError over_poses;
    for (const Pose& pose : run.poses.poses) {
      if (run.cancelled()) return;
      const SeenSurface from = seen_surface(original, *before, posed_nodes(original, pose), run.analyses);
      const SeenSurface to = seen_surface(draw.scene, *now, posed_nodes(draw.scene, pose), run.analyses);
      const auto error = surface_error(Surface{to.positions, to.indices}, Surface{from.positions, from.indices},
                                       options_, run.seed, run.executor, run.cancel);
      if (!error) return;
      over_poses.add(*error, pose.weight);
    }
    const SeenSurface bind = seen_surface(original, *before, posed_nodes(original), run.analyses);
    over_poses.measure(run, diagonal_of({bind.positions, bind.indices}) / 100);
  }

  SurfaceErrorOptions options_;
};

}  // namespace

Plugin surface_error_plugin() {
  OptionTable<SurfaceErrorOptions> table;
  table.row(&SurfaceErrorOptions::samples, "samples", "Points on each surface that rms, mean and p99 are measured from",
            {1, 1'000'000, "points"});
  table.row(&SurfaceErrorOptions::tolerance, "tolerance", "How much largest may exceed found, as a part of it",
            {0.0001, 1, ""});

  Plugin plugin;
  plugin.kind = Kind::evaluator;
  const std::string unit = "% of the diagonal";
  plugin.card = {
      .name = "surface-error",
      .summary = "Measures how far surfaces lie from full detail of the scene that the run began with, level by level",
      .reference = "Cignoni, Rocchini, Scopigno 1998 (Metro); the bound after Tang, Lee, Kim 2009",
      .acts_on = {traits::triangles},
      .metrics =
          {
              {"rms", unit, "Root mean square distance, over both surfaces"},
              {"mean", unit, "Mean distance, over both surfaces"},
              {"p99", unit, "Distance that 99 of 100 points do not exceed; the larger one of the two ways"},
              {"largest", unit, "Proved: no point of either surface is farther from the other one", true, true},
              {"found", unit, "Largest distance that was found, either way; the true one lies between it and largest",
               true, true},
          },
  };
  bind_options(plugin, std::move(table),
               [](const SurfaceErrorOptions& options) { return std::make_unique<SurfaceErrorEvaluator>(options); });
  return plugin;
}

}  // namespace foredraw

#pragma once
// A camera walks through a scene, and methods that choose levels of detail are compared: what their frames take, how
// much of what can be shown they show, and how their pictures differ from full detail.
//
// T. Funkhouser, C. Sequin: Adaptive Display Algorithm for Interactive Frame Rates, SIGGRAPH 1993, section 8.

#include "level_choosers.h"
#include "walk_fit.h"

#include <foredraw/frames/camera_path.h>
#include <foredraw/frames/picture_error.h>

#include <atomic>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace foredraw {

/// Draws a frame, and gives the nanoseconds that it took.
using FrameTimer = std::function<double(const FrameMoment&, const FrameCamera&, std::span<const DrawnObject>)>;

struct LodWalkOptions : evaluators::lod_walk::BenefitOptions {
  std::vector<evaluators::lod_walk::Method> methods{evaluators::lod_walk::all_methods.begin(),
                                                    evaluators::lod_walk::all_methods.end()};
  RenderingCosts costs = example_costs();
  std::optional<double> budget;  ///< milliseconds a frame; none: a share of what full detail takes in the mean
  double share = 0.25;           ///< of that
  double noise = 0.03;           ///< how far a frame's time is off what the model says, at most, as a part of it
  FrameTimer timer;              ///< frames take what it says; none: what the model says, with noise
  bool occlusion = false;        ///< what something hides is not seen
  bool renderings = true;        ///< cheaper renderings are ways too
  std::optional<double> pixels;  ///< of a triangle, of `static`; none: so that it costs what the budget allows
  int pictures = 6;              ///< frames whose pictures are compared, evenly over the path
  int samples = 4;               ///< along each edge of their pixels
  bool replay = false;           ///< levels are shown as pictures of a quarter of the size
  std::uint64_t seed = 0;        ///< of the noise
};

/// What one method did, [frame].
struct MethodWalk {
  evaluators::lod_walk::Method method = evaluators::lod_walk::Method::budget;
  std::vector<double> milliseconds;               ///< of the frame, by the model with noise or as it was drawn
  std::vector<FrameSample> samples;               ///< what was drawn, and its time, where there is a timer
  std::vector<double> model;                      ///< of the frame by the model
  std::vector<double> selecting;                  ///< milliseconds that the choice took
  std::vector<double> benefit;                    ///< in 64ths of a pixel; without hysteresis
  std::vector<std::uint64_t> triangles;           ///< [frame] that were drawn
  std::vector<std::uint32_t> switched;            ///< objects that were drawn otherwise than in the frame before
  std::vector<double> errors;                     ///< [picture] against full detail
  std::vector<std::vector<std::uint8_t>> replay;  ///< [frame] RGB: white full detail, black the coarsest
};

struct LodWalk {
  double budget = 0;                      ///< milliseconds a frame
  double pixels = 0;                      ///< of a triangle, of `static`
  std::vector<std::uint32_t> seen;        ///< [frame] objects
  std::vector<std::uint32_t> seen_again;  ///< of these, that were seen in the frame before too
  std::vector<std::uint64_t> triangles;   ///< [frame] of these objects in full detail
  std::vector<double> bound;              ///< [frame] no choice within the budget has more benefit
  std::vector<bool> is_over;              ///< [frame] even the cheapest ways cost more than the budget
  std::vector<double> floors;  ///< [picture] of a second picture of full detail, from samples in other places
  FrameSize replay_size;
  std::vector<MethodWalk> methods;
};

/// Walks along the path with every method. Nothing where it was cancelled. Times are those of this machine; all else is
/// the same everywhere, unless frames are drawn and feedback hears of their times.
std::optional<LodWalk> lod_walk(const FrameScene& scene, const CameraPath& path, FrameSize size,
                                const LodWalkOptions& options, const Executor& executor,
                                const std::atomic<bool>* cancel = nullptr,
                                const std::function<void(double)>& progress = {});

struct Plugin;
Plugin lod_walk_plugin();

}  // namespace foredraw

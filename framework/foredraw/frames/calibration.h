#pragma once
// What a machine takes to draw, found by having it draw.

#include <foredraw/frames/cost_fit.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <vector>

namespace foredraw {

/// A frame to be measured: objects that are alike and hide nothing of one another. Each is a square of triangles.
struct CalibrationFrame {
  Rendering rendering = Rendering::full;
  std::uint32_t objects = 0;
  std::uint32_t squares = 1;    ///< along each edge of an object, of two triangles each
  bool shares_vertices = true;  ///< between triangles; else each has three of its own
  std::uint32_t pixels = 1;     ///< along each edge of an object in the picture
  bool is_posed = false;        ///< four joints move each vertex
  friend bool operator==(const CalibrationFrame&, const CalibrationFrame&) = default;
};

/// Pictures are so many pixels high and wide.
inline constexpr std::uint32_t calibration_picture = 512;

/// The frames from which costs can be told: few and many objects, triangles and pixels in every combination that fits
/// into the picture, by each rendering; some that joints move; and a frame of nothing.
std::vector<CalibrationFrame> calibration_frames();

/// Draws a frame once: what it did, and how long it took in nanoseconds.
using MeasuredMachine = std::function<FrameSample(const CalibrationFrame&)>;

struct CalibrationOptions {
  int rounds = 7;  ///< how often each frame is drawn; its median counts; at least 1
  const std::atomic<bool>* cancel = nullptr;
  std::function<void(double)> progress = {};  ///< may be empty; the part done, 0 to 1
};

struct Calibration {
  RenderingCosts costs;  ///< of the form that foretells better, fitted to all frames; without a name
  FitError max_error;    ///< each form, fitted to one half of the frames, on the other half
  FitError sum_error;
  std::size_t frames = 0;  ///< 0: it was cancelled
};

/// Draws all calibration_frames(), in rounds, so that what disturbs the machine for a while disturbs one round; fits
/// both forms of the cost model to half of the medians, and holds them against the other half. Of equal forms `max`
/// stands. The halves are drawn by lot, always alike.
Calibration calibrate(const MeasuredMachine& machine, const CalibrationOptions& options = {});

}  // namespace foredraw

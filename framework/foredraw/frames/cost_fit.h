#pragma once
// The constants of the cost model, from frames that were measured.

#include <foredraw/frames/rendering_costs.h>

#include <cstddef>
#include <span>
#include <vector>

namespace foredraw {

/// What a frame drew, and how long it took. With `Stages::max` each entry has a slower stage of its own: so entries are
/// objects, or objects at once that are alike.
struct FrameSample {
  std::vector<ObjectWork> drawn;
  double nanoseconds = 0;
};

/// The costs that come nearest to the samples: of least squares of relative errors, none below 0. `machine` is empty.
///
/// - Samples are left out whose time is not finite and above 0, or whose work is not finite and 0 or more. Of none the
///   costs are all 0.
/// - Times that something else disturbed weigh as much as the others: take the median of several for each sample.
/// - What samples do not tell apart goes to the frame first, then to draw calls, then to pixels, vertices and
/// triangles.
/// - With `Stages::max` an object that is never the slower in its pixels tells nothing of what pixels cost, and the
///   other way round. What no sample tells is 0. A rendering of which there is no sample costs what the one before it
///   does (or behind it, where there is none before): never too little.
/// - The slower stage counts for each object, not for the frame: as in Funkhouser and Sequin, and because only so do
///   costs of objects add up. Which stage it is, is assumed, fitted and assumed anew until it stays, from several
///   beginnings; so it is the best only of what is found so.
///
/// O(samples + objects) for each beginning and round. The same bits at every call.
RenderingCosts fit_costs(std::span<const FrameSample> samples, Stages stages);

/// How far costs are off, relative to the measured times.
struct FitError {
  double mean = 0;
  double most = 0;
  std::size_t samples = 0;  ///< that can be used, as above; 0: both errors are 0 and mean nothing
};
FitError fit_error(const RenderingCosts& costs, std::span<const FrameSample> samples);

}  // namespace foredraw

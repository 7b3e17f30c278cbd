#pragma once
// From counted fragments to the figures that are reported.

#include <foredraw/overdraw/overdraw_count.h>
#include <foredraw/scene/views.h>

#include <cstddef>
#include <span>

namespace foredraw {

/// Pictures of one thing from the same side, one for each pose, each as heavy as its pose. Whole weights sum exactly.
struct ViewTally {
  double shaded = 0;
  double visible = 0;
  double ratios = 0;    ///< of the pictures that show something
  double pictures = 0;  ///< that show something

  void add(const OverdrawCount& picture, double weight = 1);
  ViewTally& operator+=(const ViewTally& other);
};

/// numerator / denominator, with the standard error that the choice of views leaves.
struct Estimate {
  double numerator = 0;
  double denominator = 0;
  double error = 0;
};

/// Passing over visible fragments, summed over the pictures, each as heavy as its view. `tallies`: of each view in
/// turn, once or several times over (one round for each subject, say). The error is that of a ratio estimator (Cochran,
/// Sampling Techniques, 3rd ed., section 2.11), whose samples are the tallies: of their deviations from the ratio. 0
/// where there are less than 2.
Estimate overdraw_ratio(std::span<const ViewTally> tallies, std::span<const View> views);

/// The mean of the pictures' ratios; those with nothing visible are left out. The error is that of a mean over samples
/// of several pictures each.
Estimate overdraw_view_mean(std::span<const ViewTally> tallies, std::span<const View> views);

/// Whether the first has the higher ratio; what shows nothing has none.
bool is_worse(const OverdrawCount& picture, const OverdrawCount& than);

}  // namespace foredraw

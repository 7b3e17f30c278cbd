#pragma once
#include "overdraw_raster.h"

#include <span>

namespace foredraw {

/// numerator / denominator, with the standard error that the choice of views leaves.
struct Estimate {
  double numerator = 0;
  double denominator = 0;
  double error = 0;
};

/// Passing over visible fragments, summed over the views. The error is that of a ratio estimator (Cochran, Sampling
/// Techniques, 3rd ed., section 2.11): of the views' deviations from the ratio. 0 where there are less than 2 views.
Estimate overdraw_ratio(std::span<const OverdrawCount> views);

/// The mean of the views' ratios; views with nothing visible are left out.
Estimate overdraw_view_mean(std::span<const OverdrawCount> views);

}  // namespace foredraw

#pragma once
// From counted fragments to the figures that are reported.

#include <foredraw/analysis/overdraw_count.h>
#include <foredraw/scene/views.h>

#include <cstddef>
#include <optional>
#include <span>

namespace foredraw {

/// numerator / denominator, with the standard error that the choice of views leaves.
struct Estimate {
  double numerator = 0;
  double denominator = 0;
  double error = 0;
};

/// Passing over visible fragments, summed over the pictures, each as heavy as its view. `counts`: of each view in turn,
/// once or several times over (one round for each subject, say). The error is that of a ratio estimator (Cochran,
/// Sampling Techniques, 3rd ed., section 2.11): of the pictures' deviations from the ratio. 0 where there are less than
/// 2.
Estimate overdraw_ratio(std::span<const OverdrawCount> counts, std::span<const View> views);

/// The mean of the pictures' ratios; those with nothing visible are left out.
Estimate overdraw_view_mean(std::span<const OverdrawCount> counts, std::span<const View> views);

/// The number of the picture with the highest ratio, the first of them; nothing where all are empty.
std::optional<std::size_t> worst_picture(std::span<const OverdrawCount> counts);

}  // namespace foredraw

#pragma once
// Figures of samples, each with its standard error.

#include <span>
#include <vector>

namespace foredraw {

struct Sampled {
  double value = 0;
  double error = 0;  ///< one standard error
};

// Of independent values; the error of samples that are spread evenly is less. 0 of none.
Sampled mean_of(std::span<const double> values);
/// Root of the mean square.
Sampled rms_of(std::span<const double> values);
/// What that part of the values is no larger than, 0 to 1. The error by order statistics: how many values lie below is
/// binomial.
Sampled quantile_of(std::vector<double> values, double part);

// Of two sets that weigh the same, of what each of them has.
Sampled mean_of_both(const Sampled& a, const Sampled& b);
Sampled rms_of_both(const Sampled& a, const Sampled& b);

}  // namespace foredraw

#pragma once
#include "seam_rows.h"

#include <atomic>
#include <vector>

namespace foredraw::processors::displacement_seams {

struct EqualHeightsWeights {
  double along = 1e6;                  ///< of the squared gap all along the seams, beside the squared change of a texel
  double points = 1e9;                 ///< of the squared gap at the points
  double most_multiplications = 2e10;  ///< with more, rows along seams are left out: a network of seams without order
  const std::atomic<bool>* cancel = nullptr;  ///< once it is set, what comes out is of no use, and comes soon
};

/// Texels changed as little as possible, in the sense of least squares, so that the rows come out 0: those of the
/// points nearly exactly, those along seams as far as the weights say. `texels` in any unit, by the rows' numbers.
/// Points that need nearly the same texels for nearly the same place are what a solution in two steps, first one and
/// then the other, breaks at; this is one step.
std::vector<double> equal_heights(std::vector<double> texels, std::vector<EqualityRow> along,
                                  std::vector<EqualityRow> points, const EqualHeightsWeights& weights = {});

}  // namespace foredraw::processors::displacement_seams

#pragma once
#include "seam_rows.h"

#include <span>
#include <vector>

namespace foredraw::seams {

struct EqualHeightsWeights {
  double along = 1e4;   ///< of the squared gap all along the seams, beside the squared change of a texel
  double points = 1e8;  ///< of the squared gap at the points
};

/// Texels changed as little as possible, in the sense of least squares, so that the rows come out 0: those of the points
/// nearly exactly, those along seams as far as the weights say. `texels` in any unit, by the rows' numbers.
std::vector<double> equal_heights(std::span<const double> texels, std::span<const EqualityRow> along,
                                  std::span<const EqualityRow> points, const EqualHeightsWeights& weights = {});

}  // namespace foredraw::seams

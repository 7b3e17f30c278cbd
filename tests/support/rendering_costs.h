#pragma once
#include <foredraw/frames/rendering_costs.h>

#include <algorithm>
#include <cmath>

namespace foredraw::testing {

/// The largest relative difference of a constant.
inline double apart(const RenderingCosts& a, const RenderingCosts& b) {
  double most = std::max(std::abs(a.frame / b.frame - 1), std::abs(a.draw / b.draw - 1));
  if (b.posed > 0) most = std::max(most, std::abs(a.posed / b.posed - 1));
  for (const Rendering rendering : all_renderings) {
    const RenderingCost &x = a.of(rendering), &y = b.of(rendering);
    most = std::max({most, std::abs(x.triangle / y.triangle - 1), std::abs(x.vertex / y.vertex - 1),
                     std::abs(x.pixel / y.pixel - 1)});
  }
  return most;
}

}  // namespace foredraw::testing

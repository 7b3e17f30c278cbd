#pragma once
#include "footprint.h"

namespace foredraw::processors::particle_trim {

/// The square between the centres of four texels, in which a sampler blends them: f = (1 - u)(1 - v) f00 + u (1 - v)
/// f10 + (1 - u) v f01 + u v f11. Where f is one number lies a hyperbola.
struct BlendCell {
  Point corner;                           ///< the centre of the upper left texel
  std::array<std::uint16_t, 4> alphas{};  ///< upper left, upper right, lower left, lower right; 0 to 65535

  /// Adds points round that part of the cell and the frame in which the blend is above the threshold (0 to 65535):
  /// where the hyperbola crosses their edges and, where it bulges outwards between, where its tangents meet. They are
  /// rounded to steps, outwards.
  void add_shown(double threshold, const Box& frame, std::vector<Point>& points) const;
};

}  // namespace foredraw::processors::particle_trim

#pragma once
// How far and how steeply a material moves the surface of a draw.

#include <foredraw/analysis/analyses.h>
#include <foredraw/scene/scene.h>

#include <optional>

namespace foredraw::processors::vertex_pack {

struct Relief {
  double displacement = 0;           ///< the largest one along the normal, inwards or outwards, in the draw's units
  std::optional<double> slope = {};  ///< the steepest one between two texels, in the draw's units for 1 of uv; nothing
                                     ///< where the map can not be read
};

/// Nothing where the draw's material moves nothing.
std::optional<Relief> relief_of(const Scene& scene, DrawId draw, Analyses& analyses);

}  // namespace foredraw::processors::vertex_pack

#pragma once
// Ribbons that are painted on something.

#include "wire_run.h"

#include <foredraw/analysis/ray_tree.h>

namespace foredraw::wiring {

/// A place on a ribbon.
struct RibbonSample {
  glm::dvec3 at, normal;  ///< the normal has length 1
  double breadth = 0;
};

/// At most so many places along the run of flat sections.
std::vector<RibbonSample> ribbon_samples(const Chain& chain, const WireRun& run);
std::vector<RibbonSample> ribbon_samples(const WeldedMesh& mesh, std::span<const std::uint32_t> triangles,
                                         double breadth);

/// Whether at half of the places or more something stands within `reach` breadths before or behind them.
bool is_decal(std::span<const RibbonSample> samples, double reach, const RayTree& surfaces);

}  // namespace foredraw::wiring

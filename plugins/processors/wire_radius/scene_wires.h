#pragma once
// Wires of a scene: which draws are looked at together, and what becomes of them.

#include "wire_radius.h"

#include <foredraw/analysis/analyses.h>
#include <foredraw/scene/scene.h>

#include <string>

namespace foredraw::wiring {

/// Draws of a mesh, and those that share vertices with them. They lie in one space.
struct WireUnit {
  std::vector<DrawId> draws;  ///< rising; of these wires may be taken
  std::vector<DrawId> fixed;  ///< that stay as they are; what joins them is held by them
};

struct LeftDraw {
  DrawId draw = 0;
  std::string why;  ///< the rest of a sentence that begins with "its wires are left alone: "
};

struct WireUnits {
  std::vector<WireUnit> units;
  std::vector<LeftDraw> left;
};

/// The units that have one of the draws, which are rising.
WireUnits wire_units(const Scene& scene, const std::vector<DrawId>& draws);

struct UnitWires {
  FoundWires found;
  std::vector<std::size_t> first_vertex, first_triangle;  ///< [draw of the unit] in what was found
  std::vector<std::uint32_t> bent;  ///< wires of which skins bend sections: they are not in what was found any more
};

UnitWires find_unit_wires(const Scene& scene, const WireUnit& unit, const WireOptions& options,
                          const WireSearch& search, Analyses& analyses);

/// Writes streams and orders of triangles; answers with the draws that have wires. The product is the caller's.
std::vector<DrawWires> put_wires(Scene& scene, const WireUnit& unit, const UnitWires& wires);

}  // namespace foredraw::wiring

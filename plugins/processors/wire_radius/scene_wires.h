#pragma once
// Wires of a scene: which draws are looked at together, and what becomes of them.

#include "wire_radius.h"

#include <foredraw/analysis/analyses.h>
#include <foredraw/scene/scene.h>

#include <string>

namespace foredraw::processors::wire_radius {

/// Draws of a mesh, those that share vertices with them, and those of meshes that follow the same skin. They lie in one
/// space.
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
  std::vector<bool> is_torn;        ///< [triangle] of no wire, but it hangs together with one by positions
  std::vector<std::uint32_t> bent;  ///< wires of which skins bend sections: they are not in what was found any more
};

UnitWires find_unit_wires(const Scene& scene, const WireUnit& unit, const WireOptions& options,
                          const WireSearch& search, Analyses& analyses);

/// Writes streams and orders of triangles; answers with the draws that it changed, of which some may have no wire. The
/// product is the caller's.
/// `ranged`: [draw of the unit] so many first triangles are in ranges of other products. What wires are torn from
/// leaves these ranges too: a range of whole shells, as second depth has, stays one.
/// `as_texcoords`: streams are the next four sets of texture coordinates, for importers that know no others.
std::vector<DrawWires> put_wires(Scene& scene, const WireUnit& unit, const UnitWires& wires,
                                 std::span<const std::uint32_t> ranged, bool as_texcoords);

}  // namespace foredraw::processors::wire_radius

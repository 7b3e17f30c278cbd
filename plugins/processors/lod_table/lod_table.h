#pragma once
// The facts from which an engine knows, ahead of each frame, what it costs to draw something at a level by a rendering,
// and which of these ways are worth a look.
//
// T. Funkhouser, C. Sequin: Adaptive Display Algorithm for Interactive Frame Rates, SIGGRAPH 1993, sections 3 to 5.

#include <foredraw/frames/lod_table.h>

namespace foredraw {

/// What one of a draw's levels takes. A draw of triangles. O(indices + vertices).
LodTable::OfLevel lod_level(const Level& level);

/// In the types of runtime/lod_table.h. The costs' machine has no name there.
foredraw_lod_machine lod_machine(const RenderingCosts& costs);

/// Which ways lie on the upper hull of cost and benefit, from all else that is known of the draw. The same bits
/// everywhere: it is runtime/lod_table.h that computes them. O(levels^2).
LodTable::Hulls lod_hulls(const RenderingCosts& costs, const LodTable::OfDraw& draw);

struct Plugin;
Plugin lod_table_plugin();

}  // namespace foredraw

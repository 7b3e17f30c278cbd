#pragma once
// The levels at which instances of a crowd can be drawn: tessellated, plain and simplified, what each takes, and how
// far it is off.
//
// N. Tatarchuk, J. Barczak, B. Purnomo: Real-Time Tessellation on GPU, SIGGRAPH 2008 course notes.

#include <foredraw/analysis/analyses.h>
#include <foredraw/base/parallel.h>
#include <foredraw/crowds/crowd_levels.h>
#include <foredraw/scene/scene.h>

#include <span>
#include <string>

namespace foredraw {

struct CrowdLevelsOptions {
  int characters = 10;  ///< at the finest level, whose triangles are the budget
  int most = 15;        ///< parts of an edge at the finest level
  foredraw_spacing spacing = FOREDRAW_SPACING_EQUAL;
  int samples = 4096;  ///< points on each surface from which distances of simplified levels are measured
};

/// What rows the draws have together, from the finest one on, without counts: every whole level that the spacing has up
/// to the most where one of them is displaced, the plain draws, and as many levels as one of them has. What is
/// displaced: [draw of `draws`].
std::vector<CrowdLevel> crowd_rows(const Scene& scene, std::span<const DrawId> draws,
                                   const std::vector<bool>& is_displaced, const CrowdLevelsOptions& options);

/// Fills in what the draw takes at a row, and what that is exactly: triangles and vertices, no distances.
CrowdLevel counted(const CrowdLevel& row, const Draw& draw, bool is_displaced);

/// Why the draw's material does not move it, as the rest of a sentence; empty: it does.
std::string why_not_displaced(const Scene& scene, DrawId draw, Analyses& analyses);

/// Of one draw, at these rows. Distances of simplified levels from a displaced surface are those from full detail and
/// full detail's own, added up: no true one is larger. The same bits everywhere.
CrowdLevels::OfDraw crowd_levels(const Scene& scene, DrawId draw, std::span<const CrowdLevel> rows,
                                 const CrowdLevelsOptions& options, Analyses& analyses, const Executor& executor);

struct Plugin;
Plugin crowd_levels_plugin();

}  // namespace foredraw

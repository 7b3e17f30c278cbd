#pragma once
// Orders by measured visibility: the pieces of an order are drawn in the sequence in which least is drawn that
// something nearer hides later, within a budget of vertices shaded. Source: own; in place of the guess of Sander,
// Nehab, Barczak 2007 and of the sorting by distance of Han, Sander 2016.

#include "atoms.h"
#include "occlusions.h"

#include <foredraw/overdraw/subject_layers.h>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// How much is tried, against time.
enum class OcclusionQuality { fast, balanced, high };

struct OcclusionOrderOptions {
  OcclusionQuality quality = OcclusionQuality::balanced;
  bool fine_atoms = false;    ///< atoms of one triangle, but for large draws and `fast`: less overdraw, more time
  double acmr_budget = 1.05;  ///< ACMR of the answer at most so many times that of the order that came in; 1 at least.
                              ///< Infinity: vertices are not looked at
  std::uint32_t cache_size = 16;  ///< entries of the FIFO cache that the budget is reckoned for
  double vertex_cost = 0;         ///< of a vertex that is shaded again, in the occlusions' weights: what saves less is
                                  ///< not bought, whatever the budget
};

/// Vertices that the cache shades where ranges of the draw's triangles are drawn in this order.
std::uint64_t shaded_vertices(const AtomicDraw& draw, const Clusters& ranges, std::span<const std::uint32_t> order,
                              std::uint32_t cache_size);

/// The size of atoms that suits the options and a draw of so many triangles: of a small one they may be finer.
AtomSize atom_size(const OcclusionOrderOptions& options, std::size_t triangles);

/// The sequence of the draw's atoms ([rank] = atom) that draws least of what does not stay, as far as a local search
/// finds it. Atoms move one at a time to where they cost least; then those that came in one behind the other are joined
/// where that costs least for each vertex that need not be shaded again, and the larger pieces move, until the budget
/// is kept. `occlusions`: of the draw's atoms. O(what the occlusions hold * log atoms * log pieces in a row).
std::vector<std::uint32_t> occlusion_order(const AtomicDraw& draw, Occlusions occlusions,
                                           const OcclusionOrderOptions& options = {});

struct Plugin;
Plugin occlusion_order_plugin();

}  // namespace foredraw

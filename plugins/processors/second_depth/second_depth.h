#pragma once
// The closed shells of a mesh, over all of its draws that may go into a pass with front faces culled.

#include "shells.h"

#include <foredraw/analysis/analyses.h>
#include <foredraw/scene/scene.h>

#include <optional>
#include <string>
#include <vector>

namespace foredraw {

struct SecondDepthOptions {
  bool skinned = true;  ///< what follows joints may go
};

/// Of a draw that may go, in its order that stands alone.
struct DrawShells {
  DrawId draw = 0;
  std::vector<processors::second_depth::Kind> kinds;  ///< [triangle]
  std::vector<double> areas;                          ///< [triangle] in the draw's units; 0 where it is not finite
};

/// Why a draw may not go into a pass that draws its back faces alone, as the rest of a sentence that begins with it;
/// empty: it may.
std::string why_not_in_second_depth(const Scene& scene, DrawId draw, const SecondDepthOptions& options = {});

/// The shells that the first `triangles[i]` triangles of the draws `draws[i]` make together. They are of one mesh, so
/// that every node shows them in one place. Vertices are one where they lie at one position, bit by bit, and, of
/// skinned draws, joints move them alike: they stay together in every pose.
std::vector<DrawShells> shells_of(const Scene& scene, std::span<const DrawId> draws,
                                  std::span<const std::uint32_t> triangles, Analyses& analyses,
                                  const processors::second_depth::Limits& limits = {});

/// Of all triangles of the draw, in its units; those that are not finite have none.
double area_of(const Draw& draw, Analyses& analyses);

struct Plugin;
Plugin second_depth_plugin();

}  // namespace foredraw

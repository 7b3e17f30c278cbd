#pragma once
// A scene as viewers show it, where triangles are all that can be drawn.

#include <foredraw/analysis/analyses.h>
#include <foredraw/scene/scene.h>

#include <memory>

namespace foredraw {

/// The scene whose displaced draws are, in full detail, the triangles of displaced_draw_of(): with all streams of their
/// vertices, interpolated, so that they move and are textured as before. Coarser levels stay as they are stored. Null
/// where nothing is displaced, or no map can be read: it is shown as it is.
std::unique_ptr<const Scene> shown_scene(const Scene& scene, Analyses& analyses);

}  // namespace foredraw

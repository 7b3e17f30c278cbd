#pragma once
#include <foredraw/scene/scene.h>

namespace foredraw::testing {

/// Draws that break what is written in haste: empty, one triangle, degenerate, non-manifold, not finite, quantised,
/// morphed, with vertices that nothing uses, shared between draws, points; ordinary ones; and a sprite with its image.
Scene odd_scene();

}  // namespace foredraw::testing

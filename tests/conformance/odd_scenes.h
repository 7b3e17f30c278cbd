#pragma once
#include <foredraw/scene/scene.h>

namespace foredraw::testing {

/// Draws that break what is written in haste: empty, one triangle, degenerate, non-manifold, not finite, quantised,
/// morphed, with vertices that nothing uses, shared between draws, points; ordinary ones; a sprite with its image; and
/// a square that a map of heights moves.
Scene odd_scene();

}  // namespace foredraw::testing

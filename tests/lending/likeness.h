#pragma once
// An evaluator whose options name a scene and an image.

#include <foredraw/technique/plugin.h>

namespace foredraw::testing {

/// Counts the triangles that the scene has more than the one called `reference`, and the texels of `picture`; each
/// where it is named.
Plugin likeness_plugin();

}  // namespace foredraw::testing

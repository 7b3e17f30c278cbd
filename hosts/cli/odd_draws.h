#pragma once
#include <foredraw/scene/scene.h>

namespace foredraw::cli {

/// Draws that break what is written in haste: without triangles, of one, degenerate, non-manifold, of no finite
/// position, huge and tiny, with vertices that nothing uses or that lie on each other; and ordinary ones.
Scene odd_draws();

/// A sphere of about so many triangles, in an order that chance made.
Scene shuffled_sphere(std::size_t triangles);

}  // namespace foredraw::cli

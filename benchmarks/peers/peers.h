#pragma once
// The peers that Foredraw is measured against, as plugins, so that one run compares like with like.

#include <foredraw/technique/registry.h>

namespace foredraw {

/// meshopt-vertex-cache, meshopt-vertex-cache-fifo, meshopt-overdraw: meshoptimizer's orders, from Debian's
/// libmeshoptimizer. energy-collapse: the simplifier of Hoppe's progressive meshes.
void add_peers(Registry& registry);

}  // namespace foredraw

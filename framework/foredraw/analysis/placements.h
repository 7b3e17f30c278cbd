#pragma once
// What a scene's nodes show, and where: for stages that place the same draws by other nodes.

#include <foredraw/scene/scene.h>

#include <string>

namespace foredraw {

/// How what is shown of two scenes differs, as a whole sentence; empty: every draw is shown as often, by the same
/// transforms to 1e-5 of a row's greatest element, by the same skins, whatever nodes and instances do it. O(n log n) of
/// what is placed. Takes little where no node changed.
std::string placement_difference(const Scene& before, const Scene& after);

}  // namespace foredraw

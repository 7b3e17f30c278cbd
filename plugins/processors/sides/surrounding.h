#pragma once
// What surrounds other things: sky domes, rooms, tunnels, cockpits. A camera stands within, so their backs are seen.

#include <foredraw/base/parallel.h>
#include <foredraw/scene/scene.h>

#include <vector>

namespace foredraw::processors::sides {

/// [draw] whether the draw's backs are what half of the rays hit first from a camera of the file, or from the centre of
/// another subject that is at most half as large: as the nodes stand. A helmet that fits a head surrounds nothing.
std::vector<bool> surrounding_draws(const Scene& scene, const Executor& executor);

}  // namespace foredraw::processors::sides

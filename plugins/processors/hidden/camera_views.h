#pragma once
// The pictures that are taken of what cameras outside may see.

#include "hidden.h"
#include "sight.h"

#include <foredraw/scene/views.h>

namespace foredraw::processors::hidden {

/// Those that decide first: along the axes, evenly from all sides, and a quarter as many with perspective, as far as
/// cameras may be there. Any beginning of them looks from all sides.
std::vector<View> deciding_views(const Cameras& cameras, const HiddenOptions& options);

/// Others, each round others again; a third of them with perspective.
std::vector<View> checking_views(const Cameras& cameras, const HiddenOptions& options, int round);

}  // namespace foredraw::processors::hidden

#pragma once
// Pictures of a crowd, by who chooses how its characters are drawn.

#include "pictures.h"

namespace foredraw::bench {

/// A crowd of a displaced draw within a budget of triangles: by the paper's formula, and by crowd_select.h. Tessellated
/// instances are red, plain ones green, simplified ones blue (Tatarchuk, Barczak, Purnomo 2008). Prints what each
/// takes.
std::vector<FramePicture> crowd_pictures(const Scene& moved, FrameSize size);

}  // namespace foredraw::bench

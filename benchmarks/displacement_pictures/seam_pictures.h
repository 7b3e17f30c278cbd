#pragma once
// Pictures of the seams of a displacement map: as it came, as the paper averages it, and as `displacement-seams`
// repairs it. Each is given one draw with its map.

#include "pictures.h"

namespace foredraw::bench {

/// The seams as lines, by the largest gap of each edge as part of the map's range: green up to .001, yellow to .01,
/// orange to .1, red beyond.
std::vector<FramePicture> seam_lines(const Scene& moved, const FrameCamera& camera, FrameSize size);

/// The surface from its front alone, and what is seen through its cracks in red.
std::vector<FramePicture> seam_cracks(const Scene& moved, const FrameCamera& camera, FrameSize size);

}  // namespace foredraw::bench

#pragma once
// Second-depth anti-aliasing of a frame: what runtime/second_depth.h answers for each of its pixels.

#include "offset_picture.h"
#include "ways.h"

namespace foredraw::evaluators::antialiasing {

/// Draws the frame's depth and its second depth, of `frame.closed`, and resolves both axes of each pixel. Depth is that
/// of a reversed projection with its far plane at infinity, in floats.
PixelOffsets second_depth_offsets(const Frame& frame);

}  // namespace foredraw::evaluators::antialiasing

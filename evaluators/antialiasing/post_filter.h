#pragma once
// A filter of finished pictures, of the kind of FXAA (Lottes 2009) and of our own making: what such filters do, without
// being any one of them.

#include "offset_picture.h"

namespace foredraw::evaluators::antialiasing {

/// Finds edges by luminance, as it is stored (by its square root), follows each to both of its ends up to 12 pixels
/// away, and fetches from across the edge by how far the pixel is from the nearer end. A pixel that differs from all of
/// its neighbours fetches some of them as well.
PixelOffsets post_offsets(const FramePicture& picture);

}  // namespace foredraw::evaluators::antialiasing

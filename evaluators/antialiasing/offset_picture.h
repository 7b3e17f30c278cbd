#pragma once
#include <foredraw/frames/sampled_picture.h>

#include <glm/vec2.hpp>

#include <vector>

namespace foredraw::evaluators::antialiasing {

/// What filters answer: from where each pixel fetches its colour, from its middle to the right and downwards in pixels.
using PixelOffsets = std::vector<glm::vec2>;  ///< [pixel] rows from the top

/// One bilinear fetch a pixel; beyond the edges the picture goes on as it ends. `spreads` are not moved.
SampledPicture offset_picture(const SampledPicture& picture, const PixelOffsets& offsets);

}  // namespace foredraw::evaluators::antialiasing

#include "sprite_frames.h"

#include <foredraw/c/checked_input.h>

#include <algorithm>
#include <stdexcept>

using namespace foredraw;

int foredraw_sprite_frames(foredraw_rectangle* frames, uint32_t* frame_count, const foredraw_alpha* image,
                           double threshold, uint32_t gutter) {
  return c::guarded([&]() -> int {
    if (frame_count == nullptr || (frames == nullptr && *frame_count > 0)) return FOREDRAW_NULL_POINTER;
    if (const int status = c::alpha_status(image)) return status;
    SpriteFramesOptions options;
    if (const int status = c::take_option(gutter, 1, 65535, options.gutter)) return status;
    if (!(threshold >= 0 && threshold <= 1)) return FOREDRAW_OPTION_RANGE;
    options.threshold = threshold;
    const AlphaImage alpha{image->width, image->height, c::numbers_of(*image)};
    std::vector<SpriteFrame> found;
    try {
      found = found_frames(alpha, {0, 0, image->width, image->height}, options);
    } catch (const std::runtime_error&) {  // too many
      *frame_count = 0;
      return FOREDRAW_TOO_LARGE;
    }
    const std::uint32_t room = *frame_count;
    *frame_count = static_cast<std::uint32_t>(found.size());
    if (found.size() > room) return FOREDRAW_TOO_LARGE;
    std::ranges::transform(found, frames, [](const SpriteFrame& frame) -> foredraw_rectangle {
      return {frame.x, frame.y, frame.width, frame.height};
    });
    return FOREDRAW_DONE;
  });
}

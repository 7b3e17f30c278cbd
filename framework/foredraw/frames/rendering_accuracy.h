#pragma once
// How near a cheaper rendering comes to the full one, by pictures.

#include <foredraw/frames/reference_renderer.h>

#include <array>

namespace foredraw {

/// Of an object in full detail, [rendering]: 1 - (error of its picture) / (error of a picture without the object), 0 to
/// 1; the full rendering has 1. Seen from eight sides, in pictures of 64 x 64 pixels that the object fills.
std::array<double, all_renderings.size()> rendering_accuracies(const FrameScene& scene, const FrameMoment& moment,
                                                               std::uint32_t object);

}  // namespace foredraw

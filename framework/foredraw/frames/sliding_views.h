#pragma once
#include <foredraw/frames/frame_moment.h>

#include <cstdint>
#include <vector>

namespace foredraw {

/// A place to look from, and the camera's frames there: so near each other that what changes is how edges lie among
/// pixels.
using SlidingViews = std::vector<std::vector<FrameCamera>>;

/// Views from all around the scene, from eye level to well above it, the camera sliding sideways by `step` pixels a
/// frame. `across`: pixels of the sphere around everything. None of a scene without objects. The same bits on every
/// machine.
SlidingViews sliding_views(const FrameScene& scene, const FrameMoment& moment, FrameSize size, double across, int views,
                           int frames, double step, std::uint64_t seed);

}  // namespace foredraw

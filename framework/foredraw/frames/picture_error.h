#pragma once
// How far two pictures of a frame are apart, and what a picture of it could be told from at all.

#include <foredraw/frames/reference_renderer.h>

#include <cstdint>
#include <vector>

namespace foredraw {

/// 8 bits a channel, RGB, rows from the top. A colour is stored by its square root, which is nearly sRGB.
std::vector<std::uint8_t> as_rgb(const FramePicture& picture);

/// Root mean square difference over all pixels and channels as they are stored, 0 to 1. The pictures have one size.
double picture_error(const FramePicture& a, const FramePicture& b);

/// What a frame looks like in full detail.
struct FrameTruth {
  FramePicture picture;
  double floor = 0;  ///< the error of a second picture, from samples in other places
};

/// Draws what is seen twice, with samples x samples a pixel.
FrameTruth frame_truth(const FrameScene& scene, const FrameMoment& moment, const FrameCamera& camera, FrameSize size,
                       int samples);

}  // namespace foredraw

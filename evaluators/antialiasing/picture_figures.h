#pragma once
// How far pictures of frames are from the truth, over the pixels that edges touch.

#include <foredraw/frames/sampled_picture.h>

#include <cstddef>
#include <vector>

namespace foredraw::evaluators::antialiasing {

/// A sum over pixels, and how many or what they are held against.
struct Sum {
  double value = 0, of = 0;
  Sum& operator+=(const Sum& other) {
    value += other.value;
    of += other.of;
    return *this;
  }
  double mean() const { return of > 0 ? value / of : 0; }
};

using PixelMask = std::vector<bool>;  ///< [pixel]

/// Those whose samples differ by more than 1/64 in one channel, and their neighbours, corners too.
PixelMask touched_pixels(const SampledPicture& truth);
PixelMask both(const PixelMask& a, const PixelMask& b);  ///< in one, or in the other

/// Squares of differences from the truth, of linear channels.
Sum squared_errors(const FramePicture& picture, const FramePicture& truth, const PixelMask& mask);

/// Squares of what the picture changes from one frame to the next, beside what the truth does.
Sum squared_flicker(const FramePicture& before, const FramePicture& after, const FramePicture& truth_before,
                    const FramePicture& truth_after, const PixelMask& mask);

/// Of the pixels that wires touch in the truth: where wires have less than half of the contrast that they have there in
/// the 3 x 3 pixels around. Of share, so that what lies behind does not matter.
Sum broken_pixels(const SampledPicture& picture, const SampledPicture& truth);

/// The share of wires, and that in the truth.
Sum ink(const SampledPicture& picture, const SampledPicture& truth);

}  // namespace foredraw::evaluators::antialiasing

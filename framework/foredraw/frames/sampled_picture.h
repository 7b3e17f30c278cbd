#pragma once
// A frame from any number of samples a pixel, wherever they are.

#include <foredraw/frames/reference_renderer.h>
#include <foredraw/frames/sample_places.h>

#include <span>
#include <vector>

namespace foredraw {

/// The mean of each pixel's samples.
struct SampledPicture {
  FramePicture picture;
  std::vector<float> wires;    ///< [pixel] what share is wires', rows from the top; with FrameDetail::marks_wires
  std::vector<float> spreads;  ///< [pixel] largest difference between samples, in one channel
};

/// Draws the frame once for each place, with one sample a pixel there, and takes the mean of linear colours. Corners
/// are snapped to 1/256 pixel, as devices do.
SampledPicture sampled_picture(const FrameScene& scene, const FrameMoment& moment, const FrameCamera& camera,
                               FrameSize size, std::span<const DrawnObject> objects, std::span<const glm::dvec2> places,
                               const FrameDetail& detail = {});

}  // namespace foredraw

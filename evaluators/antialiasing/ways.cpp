#include "ways.h"

#include "offset_picture.h"
#include "post_filter.h"
#include "second_depth_filter.h"

namespace foredraw::evaluators::antialiasing {

bool is_for_wires(Way way) {
  return way == Way::wire_clamp || way == Way::wire_clamp_msaa_4 || way == Way::wire_coverage ||
         way == Way::wire_coverage_msaa_4;
}

int samples_of(Way way) {
  switch (way) {
    case Way::msaa_2: return 2;
    case Way::msaa_4:
    case Way::wire_clamp_msaa_4:
    case Way::wire_coverage_msaa_4: return 4;
    case Way::msaa_8: return 8;
    default: return 1;
  }
}

SampledPicture picture_of(const Frame& frame, Way way) {
  FrameDetail detail{.marks_wires = true, .shades_middles = true};
  if (is_for_wires(way)) {
    const bool is_clamp = way == Way::wire_clamp || way == Way::wire_clamp_msaa_4;
    detail.wires = is_clamp ? FrameWires::widened : FrameWires::covering;
    detail.wire_samples = samples_of(way);
  }
  SampledPicture picture = sampled_picture(frame.scene, frame.moment, frame.camera, frame.size, frame.objects,
                                           standard_places(samples_of(way)), detail);
  if (way == Way::post) return offset_picture(picture, post_offsets(picture.picture));
  if (way == Way::second_depth) return offset_picture(picture, second_depth_offsets(frame));
  return picture;
}

}  // namespace foredraw::evaluators::antialiasing

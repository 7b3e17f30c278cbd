#pragma once
// Ways against jagged edges, and the picture that each makes of a frame.

#include <foredraw/frames/sampled_picture.h>

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace foredraw::evaluators::antialiasing {

enum class Way : std::uint8_t {
  none,
  msaa_2,
  msaa_4,
  msaa_8,
  post,                  ///< post_filter.h
  wire_clamp,            ///< wires are a pixel wide at least, and fade; one sample
  wire_clamp_msaa_4,     ///< the same with four
  wire_coverage,         ///< wires compute their coverage; one sample
  wire_coverage_msaa_4,  ///< the same with four, for what is no wire
  second_depth,          ///< runtime/second_depth.h
};

inline constexpr std::array all_ways = {Way::none,
                                        Way::msaa_2,
                                        Way::msaa_4,
                                        Way::msaa_8,
                                        Way::post,
                                        Way::wire_clamp,
                                        Way::wire_clamp_msaa_4,
                                        Way::wire_coverage,
                                        Way::wire_coverage_msaa_4,
                                        Way::second_depth};

constexpr std::string_view to_text(Way way) {
  constexpr std::string_view texts[] = {"none",
                                        "msaa-2",
                                        "msaa-4",
                                        "msaa-8",
                                        "post",
                                        "wire-clamp",
                                        "wire-clamp-msaa-4",
                                        "wire-coverage",
                                        "wire-coverage-msaa-4",
                                        "second-depth"};
  return texts[static_cast<std::size_t>(way)];
}

/// Which wires it draws, and with how many samples.
bool is_for_wires(Way way);
int samples_of(Way way);

/// A frame, and what of it may be in the second depth.
struct Frame {
  const FrameScene& scene;
  const FrameMoment& moment;
  const FrameCamera& camera;
  FrameSize size;
  std::span<const DrawnObject> objects;
  const std::vector<std::uint32_t>* closed = nullptr;  ///< [draw] so many first triangles are closed; null: not known
};

/// Linear colours, and the share of wires, rows from the top. `closed` has to be there for second_depth.
SampledPicture picture_of(const Frame& frame, Way way);

}  // namespace foredraw::evaluators::antialiasing

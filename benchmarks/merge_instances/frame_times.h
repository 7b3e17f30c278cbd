#pragma once
// How long frames take; words that need no header of Vulkan, so that the bench is built without it too.

#include "frame/frame_content.h"

#include <optional>
#include <string>
#include <vector>

namespace foredraw::bench {

struct TimedWay {
  const Scene* scene = nullptr;
  FrameContent content;
};

struct FrameTime {
  std::string why_not;              ///< empty: it was timed
  std::optional<double> recording;  ///< milliseconds of the processor: the median
  std::optional<double> frame;      ///< milliseconds of the device: the median; only if asked for
};

struct FrameTimes {
  std::string device;         ///< its name, or why there is none
  std::vector<FrameTime> of;  ///< [way]
};

/// All ways are recorded one behind the other in each round, so that a noisy moment hits all alike. `ways` is emptied,
/// one by one. `frames`: how often frames are drawn, 0: not at all.
FrameTimes frame_times(std::vector<TimedWay>& ways, int rounds, int frames);

}  // namespace foredraw::bench

#include "frame_times.h"

#ifdef FOREDRAW_BENCH_HAS_VULKAN
#include "frame/frame_camera.h"
#include "frame/recording_time.h"
#include "frame/shader_compiler.h"

#include <algorithm>
#include <memory>
#include <stdexcept>
#endif

namespace foredraw::bench {

#ifdef FOREDRAW_BENCH_HAS_VULKAN

namespace {

constexpr int picture_size = 1024;

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

/// A frame that can be timed, or why it can not.
struct Contestant {
  std::unique_ptr<Frame> frame;
  std::unique_ptr<RecordingTime> clock;  ///< of its own: what many commands leave in a pool, others would stumble over
  std::string why_not;
  glm::mat4 view{1};
  std::vector<double> recording, drawing;
};

Contestant contestant(FrameDevice& device, TimedWay&& way, bool is_drawn) {
  Contestant made;
  const TimedWay own = std::move(way);  // gone when it is uploaded
  try {
    made.frame = std::make_unique<Frame>(device, *own.scene, own.content);
    made.clock = std::make_unique<RecordingTime>(device);
    if (is_drawn) made.view = overview(bounds_of(*own.scene), {-0.3f, -0.5f});
  } catch (const std::runtime_error& problem) {
    made.why_not = problem.what();
  }
  return made;
}

}  // namespace

FrameTimes frame_times(std::vector<TimedWay>& ways, int rounds, int frames) {
  FrameTimes times;
  times.of.resize(ways.size());
  if (const auto reason = gpu::why_no_device()) {
    times.device = *reason;
    return times;
  }
  if (!has_shader_compiler()) {
    times.device = "none: glslangValidator is not installed (Debian: glslang-tools)";
    return times;
  }
  FrameDevice device(picture_size);
  times.device = device.device().name();
  std::vector<Contestant> contestants;
  for (TimedWay& way : ways) contestants.push_back(contestant(device, std::move(way), frames > 0));
  for (int round = 0; round <= rounds; ++round) {  // the first wakes everything up
    for (Contestant& one : contestants) {
      if (!one.frame) continue;
      const double time = one.clock->milliseconds(*one.frame);
      if (round > 0) one.recording.push_back(time);
    }
  }
  for (int round = 0; round < frames; ++round) {
    for (Contestant& one : contestants) {
      if (!one.frame) continue;
      if (const auto time = one.frame->milliseconds(one.view)) one.drawing.push_back(*time);
    }
  }
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    times.of[i].why_not = contestants[i].why_not;
    if (!contestants[i].recording.empty()) times.of[i].recording = median(contestants[i].recording);
    if (!contestants[i].drawing.empty()) times.of[i].frame = median(contestants[i].drawing);
  }
  return times;
}

#else

FrameTimes frame_times(std::vector<TimedWay>& ways, int, int) {
  return {"built without Vulkan", std::vector<FrameTime>(ways.size())};
}

#endif

}  // namespace foredraw::bench

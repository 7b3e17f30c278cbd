#include "frame_timers_plugin.h"

#ifdef FOREDRAW_DRAWS_BY_VULKAN
#include <foredraw/frames_gpu/vulkan_frames.h>
#endif

#include <ctime>
#include <memory>
#include <stdexcept>

namespace foredraw {

FrameTimer reference_timer(const FrameScene& scene, FrameSize size) {
  const auto renderer = std::make_shared<ReferenceRenderer>(size);
  return
      [&scene, renderer](const FrameMoment& moment, const FrameCamera& camera, std::span<const DrawnObject> objects) {
        const std::clock_t begin = std::clock();  // of this process alone, as calibrate has it
        renderer->draw(scene, moment, camera, objects);
        return 1e9 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
      };
}

#ifdef FOREDRAW_DRAWS_BY_VULKAN

bool has_vulkan_timer() { return true; }

std::string vulkan_device() { return gpu::device_text(); }

NamedTimer vulkan_timer(const FrameScene& scene, FrameSize size) {
  try {
    const auto frames = std::make_shared<VulkanFrames>(gpu::DeviceChoice{}, scene, size);
    const auto draw = [frames](const FrameMoment& moment, const FrameCamera& camera,
                               std::span<const DrawnObject> objects) { return frames->draw(moment, camera, objects); };
    return {draw, frames->device_name() + (frames->is_processor() ? ", which runs on the processor" : "")};
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(std::string("times = vulkan: ") + error.what());
  }
}

#else

bool has_vulkan_timer() { return false; }

std::string vulkan_device() { return "none"; }

NamedTimer vulkan_timer(const FrameScene&, FrameSize) {
  throw std::runtime_error("times = vulkan: this program was built without Vulkan");
}

#endif

}  // namespace foredraw

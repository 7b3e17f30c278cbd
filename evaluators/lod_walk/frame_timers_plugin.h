#pragma once
// Who draws the frames of a walk, and says how long that took.

#include "lod_walk.h"

#include <string>

namespace foredraw {

/// ReferenceRenderer, on one thread: processor time of this process. The scene has to live longer.
FrameTimer reference_timer(const FrameScene& scene, FrameSize size);

/// Whether this program was built with what vulkan_timer() needs.
bool has_vulkan_timer();

/// The device of vulkan_timer(), and its driver; or why there is none.
std::string vulkan_device();

struct NamedTimer {
  FrameTimer timer;
  std::string name;  ///< of the device
};

/// VulkanFrames on the first device that there is, by the device's own clock. The scene has to live longer. Throws
/// std::runtime_error with the reason where no device draws frames of that size.
NamedTimer vulkan_timer(const FrameScene& scene, FrameSize size);

}  // namespace foredraw

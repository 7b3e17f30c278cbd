#pragma once
#include "frame.h"

namespace foredraw::bench {

/// How long the processor takes to record a frame, without handing it in: into a command buffer that is used again and
/// again, as engines do it.
class RecordingTime {
 public:
  explicit RecordingTime(FrameDevice& device);

  /// From the beginning of the command buffer to its end.
  double milliseconds(const Frame& frame);

 private:
  FrameDevice& device_;
  gpu::OwnedCommandPool pool_;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
};

}  // namespace foredraw::bench

#pragma once
#include "frame_device.h"

namespace foredraw::bench {

/// Draws a part's calls: depth test "less", back faces culled. `frequency`: of merged draws. `is_mirrored`: front faces
/// wind clockwise. Throws std::runtime_error where an attribute that is read is not made of floats.
gpu::OwnedPipeline frame_pipeline(FrameDevice& device, const Scene& scene, const FramePart& part,
                                  std::uint32_t frequency, bool is_mirrored);

}  // namespace foredraw::bench

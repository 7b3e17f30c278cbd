#pragma once
#include <foredraw/scene/views.h>

#include <glm/mat4x4.hpp>

namespace foredraw::gpu {

/// From positions in radii from the sphere's centre to Vulkan's clip space: the camera of viewing/camera.h. The
/// picture stands upright, so the framebuffer's y, which runs downwards, is up turned over. Depth 0 lies a hair before
/// the sphere and 1 a hair behind it, lest rounding clips what touches it.
glm::mat4 clip_from_position(const View& view);

}  // namespace foredraw::gpu

#pragma once
#include <foredraw/frames/reference_renderer.h>
#include <foredraw/gpu/memory.h>

namespace foredraw {

/// The picture on the device that frames are drawn into, with its depths: linear colours of 16-bit floats. Depths are
/// 1 / distance times the near plane's, so that nearer is greater and far away loses nothing.
class FrameTarget {
 public:
  /// Throws std::runtime_error where the device does not draw pictures of so many samples.
  FrameTarget(const gpu::Device& device, FrameSize size, int samples);

  VkRenderPass render_pass() const { return render_pass_.get(); }
  /// Begins the render pass; the picture shows the sky alone then.
  void begin(VkCommandBuffer commands) const;
  /// What was drawn last, the mean of each pixel's samples. Only after a render pass.
  FramePicture picture(gpu::Device& device) const;

 private:
  FrameSize size_;
  std::uint32_t samples_;
  VkExtent2D sampled_;  // in samples
  gpu::OwnedRenderPass render_pass_;
  gpu::LayeredImage colours_, depths_;
  gpu::OwnedImageView colour_view_, depth_view_;
  gpu::OwnedFramebuffer framebuffer_;
};

}  // namespace foredraw

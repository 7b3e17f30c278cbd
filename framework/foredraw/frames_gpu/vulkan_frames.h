#pragma once
// Draws frames on a Vulkan device, and tells how long that takes there.

#include <foredraw/frames/reference_renderer.h>
#include <foredraw/gpu/choice.h>

#include <memory>
#include <span>
#include <string>

namespace foredraw {

/// Draws what ReferenceRenderer draws: the same objects, levels and renderings, light, textures, masks, blends and
/// sides. Pictures differ from its own as follows:
///   - A texture's mip level is that of each sample, not of its triangle: large triangles that lean away look sharper
///     in front and smoother behind.
///   - Colours are floats of 16 bits, and the device blends texels in its own precision.
///   - What is nearly equally far away may change places.
///   - The near plane cuts where it is; the reference's cuts a hundredth behind.
/// What is not finite is left out where it is stored so; where a pose makes it so, the device shows what it will.
/// Keeps all levels and textures on the device. Used by one thread at a time.
class VulkanFrames {
 public:
  /// `samples`: along each edge of a pixel, 1 to 16; each is drawn and shaded, as the reference does. The scene must
  /// outlive this. Throws std::runtime_error where there is no such device (with what gpu::why_no_device() says), where
  /// it has no clock or no room, or where it draws no pictures of that size.
  VulkanFrames(const gpu::DeviceChoice& choice, const FrameScene& scene, FrameSize size, int samples = 1);
  VulkanFrames(VulkanFrames&&) noexcept;
  VulkanFrames& operator=(VulkanFrames&&) noexcept;
  ~VulkanFrames();

  const std::string& device_name() const;
  bool is_processor() const;  ///< the device is software

  /// The objects in their sequence, those with blended surfaces last, the farthest first. Gives the nanoseconds that
  /// the device took, by its own clock: moved vertices and pixels, but neither poses of vertices, which the processor
  /// makes, nor recording. A frame with a kind of surface that was not drawn before is drawn twice, and the second time
  /// counts: drivers compile late. Throws std::runtime_error where the device is lost or out of memory.
  double draw(const FrameMoment& moment, const FrameCamera& camera, std::span<const DrawnObject> objects);

  /// Of the last frame, the mean of each pixel's samples; the sky, where none was drawn.
  FramePicture picture() const;

 private:
  class Device;
  std::unique_ptr<Device> device_;
};

}  // namespace foredraw

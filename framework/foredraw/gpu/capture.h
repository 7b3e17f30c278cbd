#pragma once
// What shaders put out, read back.

#include <foredraw/gpu/memory.h>
#include <foredraw/gpu/queries.h>

#include <cstdint>

namespace foredraw::gpu {

/// The outputs of the last stage before the rasteriser, for each corner of each triangle in the sequence in which they
/// are drawn: those that the shader declares with xfb_buffer = 0, as its xfb_offset and xfb_stride lay them out. For
/// devices that capture.
class Capture {
 public:
  /// Room for `bytes`. The device has to live longer. Throws std::runtime_error where it does not capture.
  Capture(const Device& device, VkDeviceSize bytes);

  /// Within a render pass, with a pipeline bound: what is drawn from here on is captured, from the front of the buffer.
  void begin(VkCommandBuffer commands) const;
  void end(VkCommandBuffer commands) const;
  /// Before the render pass.
  void reset(VkCommandBuffer commands) const { counts_.reset(commands); }
  /// After the render pass: so that the functions below see what was captured, once the commands have run.
  void let_read(VkCommandBuffer commands) const;

  struct Triangles {
    std::uint64_t written = 0;
    std::uint64_t drawn = 0;  ///< more, where there was no room for all
  };
  Triangles triangles() const;

  template <class T>
  std::span<const T> as() const {
    return outputs_.as<const T>();
  }

 private:
  VisibleBuffer outputs_;
  Queries counts_;
  PFN_vkCmdBindTransformFeedbackBuffersEXT bind_;
  PFN_vkCmdBeginTransformFeedbackEXT begin_;
  PFN_vkCmdEndTransformFeedbackEXT end_;
};

}  // namespace foredraw::gpu

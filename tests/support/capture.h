#pragma once
// Outputs of shaders, read back.

#include <foredraw/gpu/memory.h>
#include <foredraw/gpu/queries.h>

#include <array>
#include <cstdint>
#include <stdexcept>

namespace foredraw::testing {

/// The outputs of the last stage before the rasteriser, for each corner of each triangle in the sequence in which they
/// are drawn: those that the shader declares with xfb_buffer = 0, as its xfb_offset and xfb_stride lay them out. For
/// devices that capture.
class Capture {
 public:
  /// Room for `bytes`. The device has to live longer. Throws std::runtime_error where it does not capture.
  Capture(const gpu::Device& device, VkDeviceSize bytes)
      : outputs_(capturing(device), bytes, VK_BUFFER_USAGE_TRANSFORM_FEEDBACK_BUFFER_BIT_EXT),
        counts_(device, VK_QUERY_TYPE_TRANSFORM_FEEDBACK_STREAM_EXT, 1),
        bind_(named<PFN_vkCmdBindTransformFeedbackBuffersEXT>(device, "vkCmdBindTransformFeedbackBuffersEXT")),
        begin_(named<PFN_vkCmdBeginTransformFeedbackEXT>(device, "vkCmdBeginTransformFeedbackEXT")),
        end_(named<PFN_vkCmdEndTransformFeedbackEXT>(device, "vkCmdEndTransformFeedbackEXT")) {}

  /// Within a render pass, with a pipeline bound: what is drawn from here on is captured, from the front of the buffer.
  void begin(VkCommandBuffer commands) const {
    const VkBuffer buffer = outputs_.get();
    const VkDeviceSize offset = 0;
    bind_(commands, 0, 1, &buffer, &offset, nullptr);
    vkCmdBeginQuery(commands, counts_.get(), 0, 0);
    begin_(commands, 0, 0, nullptr, nullptr);
  }
  void end(VkCommandBuffer commands) const {
    end_(commands, 0, 0, nullptr, nullptr);
    vkCmdEndQuery(commands, counts_.get(), 0);
  }
  /// Before the render pass.
  void reset(VkCommandBuffer commands) const { counts_.reset(commands); }
  /// After the render pass: so that the functions below see what was captured, once the commands have run.
  void let_read(VkCommandBuffer commands) const {
    gpu::let_see(commands, VK_PIPELINE_STAGE_TRANSFORM_FEEDBACK_BIT_EXT, VK_ACCESS_TRANSFORM_FEEDBACK_WRITE_BIT_EXT,
                 VK_PIPELINE_STAGE_HOST_BIT, VK_ACCESS_HOST_READ_BIT);
  }

  struct Triangles {
    std::uint64_t written = 0;
    std::uint64_t drawn = 0;  ///< more, where there was no room for all
  };
  Triangles triangles() const {
    std::array<std::uint64_t, 2> counts{};
    counts_.read(0, counts, counts.size());
    return {counts[0], counts[1]};
  }

  template <class T>
  std::span<const T> as() const {
    return outputs_.as<const T>();
  }

 private:
  /// A function of an extension, which the loader knows by name alone.
  template <class Function>
  static Function named(const gpu::Device& device, const char* name) {
    return reinterpret_cast<Function>(vkGetDeviceProcAddr(device.get(), name));
  }
  static const gpu::Device& capturing(const gpu::Device& device) {
    if (device.captures()) return device;
    throw std::runtime_error(device.name() + " lacks VK_EXT_transform_feedback; choose another device");
  }

  gpu::VisibleBuffer outputs_;
  gpu::Queries counts_;
  PFN_vkCmdBindTransformFeedbackBuffersEXT bind_;
  PFN_vkCmdBeginTransformFeedbackEXT begin_;
  PFN_vkCmdEndTransformFeedbackEXT end_;
};

}  // namespace foredraw::testing

#pragma once
// Overdraw as a Vulkan device counts it: the real index buffers, drawn by a real driver.

#include <foredraw/gpu/choice.h>
#include <foredraw/overdraw/overdraw_count.h>
#include <foredraw/scene/views.h>
#include <foredraw/viewing/raster_part.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace foredraw {

class VulkanPainter;

/// A Vulkan device with what drawing needs on it, kept from call to call. Used by one thread at a time.
class OverdrawDevice {
 public:
  /// Throws std::runtime_error with what gpu::why_no_device() says.
  explicit OverdrawDevice(const gpu::DeviceChoice& choice = {});
  ~OverdrawDevice();

  const std::string& name() const;  ///< "llvmpipe (LLVM 15.0.6, 256 bits)"
  bool is_processor() const;        ///< a program on the processor that does as if it were a device
  int depth_bits() const;           ///< 32, of a float; 24 where the device has no such depth
  VulkanPainter& painter() { return *painter_; }

 private:
  std::unique_ptr<VulkanPainter> painter_;
};

/// Draws the parts one after the other from every view, one draw call a part, with depth test `less`, into pictures of
/// views.size x views.size pixels that just hold the bounding sphere of all parts. Distance 0 (orthographic) or more
/// than 1.
///
/// What is covered and how near it is are as the device rounds, which is not as overdraw_raster() does, and another
/// device may count otherwise. A view's counts do not depend on the other views. Triangles with a position that is not
/// finite are left out. How many fragments masks discard is not counted. Throws std::runtime_error where the device
/// fails.
OverdrawCounts overdraw_vulkan(OverdrawDevice& device, std::span<const RasterPart> parts, const Views& views);

/// How often the device runs the vertex shader for each part: what its own vertex cache leaves. Nothing where the
/// device does not say.
std::optional<std::vector<std::uint64_t>> vertex_shader_invocations(OverdrawDevice& device,
                                                                    std::span<const RasterPart> parts);

/// Milliseconds on the device to draw the parts from all views, as they are measured: the median of several times.
struct GpuTime {
  double light = 0;  ///< fragments that cost next to nothing
  double heavy = 0;  ///< fragments that wait for 256 sines in a row
};

/// Nothing where the device has no clock. On a processor it would be the time of a program that imitates a device.
std::optional<GpuTime> gpu_time(OverdrawDevice& device, std::span<const RasterPart> parts, const Views& views);

struct Plugin;
Plugin overdraw_vulkan_plugin();

}  // namespace foredraw

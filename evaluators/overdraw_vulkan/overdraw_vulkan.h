#pragma once
// Overdraw as a Vulkan device counts it: the real index buffers, drawn by a real driver.

#include "fragment_counters.h"
#include "vulkan_painter.h"

#include <foredraw/analysis/overdraw_count.h>
#include <foredraw/analysis/raster_part.h>
#include <foredraw/scene/views.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace foredraw {

/// Draws the parts one after the other from every view, one draw call a part, with depth test `less`, into pictures of
/// views.size x views.size pixels that just hold the bounding sphere of all parts. Distance 0 (orthographic) or more than
/// 1. Both methods count the same on one device; `atomics` up to 2^32 - 1 fragments of a part in a view.
///
/// What is covered and how near it is are as the device rounds, which is not as overdraw_raster() does, and another
/// device may count otherwise. A view's counts do not depend on the other views. Triangles with a position that is not
/// finite are left out. Throws std::runtime_error where the device fails.
OverdrawCounts overdraw_vulkan(VulkanPainter& painter, std::span<const RasterPart> parts, const Views& views,
                               CountMethod method = CountMethod::queries);

/// How often the device runs the vertex shader for each part: what its own vertex cache leaves. Nothing where the device
/// does not say.
std::optional<std::vector<std::uint64_t>> vertex_shader_invocations(VulkanPainter& painter,
                                                                    std::span<const RasterPart> parts);

/// Milliseconds on the device to draw the parts from all views, as they are measured: the median of several times.
struct GpuTime {
  double light = 0;  ///< fragments that cost next to nothing
  double heavy = 0;  ///< fragments that wait for 256 sines in a row
};

/// Nothing where the device has no clock. On a processor it would be the time of a program that imitates a device.
std::optional<GpuTime> gpu_time(VulkanPainter& painter, std::span<const RasterPart> parts, const Views& views);

struct Plugin;
Plugin overdraw_vulkan_plugin();

}  // namespace foredraw

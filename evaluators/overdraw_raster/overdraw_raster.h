#pragma once
// Overdraw counted by drawing: an exact rasteriser on the processor, whose figures are the same on every machine.

#include <foredraw/base/parallel.h>
#include <foredraw/overdraw/overdraw_count.h>
#include <foredraw/scene/views.h>
#include <foredraw/viewing/raster_part.h>

#include <span>

namespace foredraw {

/// Draws the parts one after the other from every view, with depth test `less`, into pictures of views.size x
/// views.size pixels that just hold the bounding sphere of all parts. Size 1 to 4096; distance 0 (orthographic) or more
/// than 1.
///
/// A pixel is covered where its centre is inside of the triangle (top-left rule), exactly, once the corners are snapped
/// to 1/256 pixel. Depth is along the axis of view; that of the corners, and then of the fragment, is quantised to
/// 2^-24 of the sphere's diameter. Triangles that repeat a corner or have no area in the picture cover nothing, nor do
/// those with a position that is not finite. O(views * (triangles + fragments)).
OverdrawCounts overdraw_raster(std::span<const RasterPart> parts, const Views& views);

/// The same with the views shared out over the threads. The counts are the same however they are.
OverdrawCounts overdraw_raster(std::span<const RasterPart> parts, const Views& views, const Executor& executor);

struct Plugin;
Plugin overdraw_raster_plugin();

}  // namespace foredraw

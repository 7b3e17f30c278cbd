#pragma once
#include <foredraw/overdraw/overdraw_count.h>
#include <foredraw/scene/views.h>
#include <foredraw/viewing/raster_part.h>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// How often each pixel of a view is shaded.
struct HeatMap {
  int size = 0;
  std::vector<std::uint32_t> times;  ///< [row * size + column], rows from the top
  OverdrawCount count;               ///< of all parts
};

/// Draws the parts one after the other as overdraw_raster() does: a fragment that is not nearer than what its pixel
/// holds is not shaded.
HeatMap heat_map(std::span<const RasterPart> parts, const View& view, int size);

}  // namespace foredraw

#pragma once
// Triangles of a few pixels: a stamp of pixels at a time.

#include <foredraw/overdraw/corners.h>
#include <foredraw/overdraw/fragments.h>

namespace foredraw {

/// Along x and y, in subpixels: edge functions stay exact in 32 bits, beside the box by a stamp too.
inline constexpr std::int32_t most_small_extent = 128 * subpixels;

/// Draws triangles, one after the other, up to the first that is too large for it or until the batch is full. Returns
/// how many.
std::size_t draw_small(const PreparedPart& part, const Corners& corners, const Camera& camera,
                       std::span<const std::uint32_t> triangles, Fragments& fragments);

}  // namespace foredraw

#pragma once
// Triangles of a few pixels: a stamp of pixels at a time.

#include <foredraw/analysis/corners.h>
#include <foredraw/analysis/fragments.h>

namespace foredraw {

/// Draws triangles, one after the other, up to the first that is not small or until the batch is full. Returns how many.
std::size_t draw_small(const PreparedPart& part, const Corners& corners, const Camera& camera,
                       std::span<const std::uint32_t> triangles, Fragments& fragments);

}  // namespace foredraw

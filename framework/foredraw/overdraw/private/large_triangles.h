#pragma once
// Triangles of any size: row by row.

#include <foredraw/overdraw/corners.h>
#include <foredraw/overdraw/fragments.h>

namespace foredraw {

/// Hands full batches over to `take`.
void draw_large(const PreparedPart& part, const Corners& corners, const Camera& camera, std::uint32_t triangle,
                Fragments& fragments, const TakeFragments& take);

}  // namespace foredraw

#pragma once
// Coverage found without cleverness.

#include <foredraw/viewing/coverage.h>

namespace foredraw {

/// Whether the pixel's centre is inside, asked of each pixel: nudged to the right by an infinitely small step, and down
/// by one smaller still, it lies in the triangle and on no edge.
inline bool covers_pixel(const Corner& a, const Corner& b, const Corner& c, int x, int y) {
  const auto is_left = [&](const Corner& p, const Corner& q) {
    const __int128 dx = q.x - p.x;
    const __int128 dy = q.y - p.y;
    const __int128 side = dx * (256 * y + 128 - p.y) - dy * (256 * x + 128 - p.x);
    if (side != 0) return side > 0;
    return dy != 0 ? dy < 0 : dx < 0;
  };
  return is_left(a, b) && is_left(b, c) && is_left(c, a);
}

}  // namespace foredraw

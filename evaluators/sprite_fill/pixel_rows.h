#pragma once
// The pixels of a triangle, row by row.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace foredraw {

/// In 1/256 pixel; no further from 0 than 2^28, so that products fit.
struct PixelPlace {
  std::int64_t x = 0;
  std::int64_t y = 0;
};

/// The largest whole number not above the quotient; divisor > 0.
inline std::int64_t quotient_down(std::int64_t number, std::int64_t divisor) {
  const std::int64_t quotient = number / divisor;
  return number % divisor < 0 ? quotient - 1 : quotient;
}

/// Calls row(y, first, last) for every row of pixels in which centres lie in the triangle, with the first and the last
/// of these. Exact: a centre on an edge lies in the triangle below it or to the right of it, so each centre of two
/// triangles that share an edge is in one of them. Triangles of either winding; without area they hold none.
template <class Row>
void for_each_row(std::array<PixelPlace, 3> corners, const Row& row) {
  const auto cross = [](const PixelPlace& a, const PixelPlace& b, const PixelPlace& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  };
  const std::int64_t area = cross(corners[0], corners[1], corners[2]);
  if (area == 0) return;
  if (area < 0) std::swap(corners[1], corners[2]);
  // The centre of pixel i lies at 256 i + 128.
  const auto [top, bottom] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
  const std::int64_t last_row = quotient_down(bottom - 128, 256);
  for (std::int64_t y = quotient_down(top - 128 + 255, 256); y <= last_row; ++y) {
    std::int64_t first = std::numeric_limits<std::int64_t>::min();
    std::int64_t last = std::numeric_limits<std::int64_t>::max();
    for (std::size_t i = 0; i < 3; ++i) {
      const PixelPlace &a = corners[i], &b = corners[(i + 1) % 3];
      const std::int64_t along_x = b.x - a.x, along_y = b.y - a.y;
      // A centre is inside where at_zero - 256 x along_y >= least. With y downwards and the inside on the right hand,
      // left edges go up and top edges go right.
      const std::int64_t at_zero = along_x * (256 * y + 128 - a.y) - along_y * (128 - a.x);
      const std::int64_t least = along_y < 0 || (along_y == 0 && along_x > 0) ? 0 : 1;
      if (along_y == 0) {
        if (at_zero < least) last = std::numeric_limits<std::int64_t>::min();
      } else if (along_y > 0) {
        last = std::min(last, quotient_down(at_zero - least, 256 * along_y));
      } else {
        first = std::max(first, -quotient_down(at_zero - least, -256 * along_y));
      }
    }
    if (first <= last) row(y, first, last);
  }
}

}  // namespace foredraw

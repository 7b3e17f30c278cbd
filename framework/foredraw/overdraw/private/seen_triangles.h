#pragma once
// Which triangles a view draws at all.

#include <foredraw/overdraw/corners.h>

#include <span>

namespace foredraw {

/// Of the triangles [begin, end) those that the view may see a fragment of, ascending: no back face where they are
/// culled, with area, and with a pixel's centre in the box of the corners. begin and end are multiples of the padding;
/// `seen` has room for all. Returns how many.
std::size_t find_seen(const PreparedPart& part, const Corners& corners, std::size_t begin, std::size_t end,
                      std::span<std::uint32_t> seen);

}  // namespace foredraw

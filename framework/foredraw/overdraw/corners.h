#pragma once
// All vertices of a part in one picture.

#include <foredraw/viewing/camera.h>
#include <foredraw/viewing/raster_part.h>

#include <vector>

namespace foredraw {

/// [vertex]. Apart, because most triangles turn out to be unseen by their places alone.
struct Corners {
  std::vector<std::uint64_t> points;  ///< x in the lower half, y in the upper
  std::vector<std::uint32_t> depths;

  Corner operator[](std::size_t vertex) const {
    return {static_cast<std::int32_t>(points[vertex]), static_cast<std::int32_t>(points[vertex] >> 32), depths[vertex]};
  }
};

/// camera.project() of every position, some at a time.
void project(const PreparedPart& part, const Camera& camera, Corners& corners);

}  // namespace foredraw

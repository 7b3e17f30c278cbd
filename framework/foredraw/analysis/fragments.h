#pragma once
// The fragments of a part in one view, triangle by triangle: whoever counts or keeps them says what becomes of each.

#include <foredraw/analysis/camera.h>
#include <foredraw/analysis/coverage.h>
#include <foredraw/analysis/raster_part.h>

#include <cstdlib>
#include <tuple>
#include <utility>

namespace foredraw {

namespace fragments {

inline void sort(Corner& a, Corner& b, Corner& c) {
  const auto in_order = [](Corner& p, Corner& q) {
    if (std::tie(q.x, q.y, q.depth) < std::tie(p.x, p.y, p.depth)) std::swap(p, q);
  };
  in_order(a, b);
  in_order(b, c);
  in_order(a, b);
}

template <class Depth, class Put>
void draw(const PreparedPart& part, const Camera& camera, std::span<const Corner> corners, Put put) {
  for (const PreparedPart::Triangle& triangle : part.triangles) {
    Corner a = corners[triangle.corners[0]];
    Corner b = corners[triangle.corners[1]];
    Corner c = corners[triangle.corners[2]];
    const PixelBox box(a, b, c);
    if (box.is_empty()) continue;
    const std::int64_t area = doubled_area(a, b, c);
    if (area == 0) continue;
    const bool shows_front = (area > 0) != part.is_mirrored;
    if (part.culls_back_faces && !shows_front) continue;
    // From here on nothing depends on which corner comes first or on how they turn: a triangle drawn twice, from its
    // two sides too, has the same depths and ties.
    sort(a, b, c);
    if (doubled_area(a, b, c) < 0) std::swap(b, c);
    const Depth depth(camera, a, b, c, std::abs(area));
    for_each_covered(a, b, c, box, [&](std::int32_t x, std::int32_t y, const std::array<std::int64_t, 3>& weights) {
      put(x, y, depth.at(weights), triangle.number);
    });
  }
}

}  // namespace fragments

/// Calls put(x, y, depth, triangle's number) for every fragment of the part, triangle by triangle. `corners` is scratch
/// memory, kept from call to call.
template <class Put>
void for_each_fragment(const PreparedPart& part, const Camera& camera, std::vector<Corner>& corners, Put put) {
  corners.clear();
  for (const glm::dvec3& position : part.positions) corners.push_back(camera.project(position));
  if (camera.is_perspective()) {
    fragments::draw<PerspectiveDepth>(part, camera, corners, put);
  } else {
    fragments::draw<OrthographicDepth>(part, camera, corners, put);
  }
}

}  // namespace foredraw

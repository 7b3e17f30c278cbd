#include "fragments.h"

#include "coverage.h"
#include "seen_triangles.h"
#include "small_triangles.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>
#include <utility>

namespace foredraw {

namespace {

constexpr std::size_t chunk = 1024;
static_assert(chunk % PreparedPart::padding == 0);

/// Turns counter-clockwise, and the least corner first: from here on nothing depends on how they were numbered. A
/// triangle drawn twice, from its two sides too, has the same depths and ties.
void normalise(std::array<Corner, 3>& corners) {
  if (doubled_area(corners[0], corners[1], corners[2]) < 0) std::swap(corners[1], corners[2]);
  const auto least = std::ranges::min_element(
      corners, {}, [](const Corner& corner) { return std::tuple(corner.x, corner.y, corner.depth); });
  std::rotate(corners.begin(), least, corners.end());
}

template <class Depth>
void draw_any(const PreparedPart& part, const Corners& corners, const Camera& camera, std::size_t triangle,
              Fragments& fragments, const std::function<void(const Fragments&)>& take) {
  std::array<Corner, 3> c;
  for (std::size_t i = 0; i < 3; ++i) c[i] = corners[part.corners[i][triangle]];
  normalise(c);
  const Depth depth(camera, c[0], c[1], c[2], doubled_area(c[0], c[1], c[2]));
  const std::uint32_t number = part.numbers[triangle];
  for_each_covered(c[0], c[1], c[2], PixelBox(c[0], c[1], c[2]),
                   [&](std::int32_t x, std::int32_t y, const std::array<std::int64_t, 3>& weights) {
                     if (fragments.count >= Fragments::most) {
                       take(fragments);
                       fragments.count = 0;
                     }
                     fragments.pixels[fragments.count] = static_cast<std::uint32_t>(y * camera.size() + x);
                     fragments.depths[fragments.count] = depth.at(weights);
                     fragments.triangles[fragments.count++] = number;
                   });
}

}  // namespace

void Rasteriser::draw(const PreparedPart& part, const Camera& camera,
                      const std::function<void(const Fragments&)>& take) {
  project(part, camera, corners_);
  seen_.resize(chunk + PreparedPart::padding);
  for (std::size_t begin = 0; begin < part.triangle_count(); begin += chunk) {
    const std::size_t end = std::min(begin + chunk, part.triangle_count());
    const std::size_t count = find_seen(part, corners_, begin, end, seen_);
    std::span<const std::uint32_t> left(seen_.data(), count);
    while (!left.empty()) {
      left = left.subspan(draw_small(part, corners_, camera, left, fragments_));
      if (fragments_.count >= Fragments::most) {
        take(fragments_);
        fragments_.count = 0;
      } else if (!left.empty()) {
        if (camera.is_perspective()) {
          draw_any<PerspectiveDepth>(part, corners_, camera, left[0], fragments_, take);
        } else {
          draw_any<OrthographicDepth>(part, corners_, camera, left[0], fragments_, take);
        }
        left = left.subspan(1);
      }
    }
  }
  take(fragments_);
  fragments_.count = 0;
}

}  // namespace foredraw

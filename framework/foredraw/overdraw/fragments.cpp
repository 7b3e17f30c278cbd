#include <foredraw/overdraw/fragments.h>

#include <foredraw/overdraw/private/large_triangles.h>
#include <foredraw/overdraw/private/masked_fragments.h>
#include <foredraw/overdraw/private/seen_triangles.h>
#include <foredraw/overdraw/private/small_triangles.h>

#include <algorithm>
#include <span>

namespace foredraw {

namespace {

/// Triangles that are looked at together, so that what is read of them is still at hand when they are drawn.
constexpr std::size_t chunk = 1024;
static_assert(chunk % PreparedPart::padding == 0);

}  // namespace

void Rasteriser::draw(const PreparedPart& part, const Camera& camera, const TakeFragments& take,
                      const TakeFragments& take_discarded) {
  if (!part.mask) return draw_whole(part, camera, take);
  MaskedFragments masked(part, corners_, camera);
  draw_whole(part, camera, [&](const Fragments& some) { masked.hand_over(some, take, take_discarded); });
}

void Rasteriser::draw_whole(const PreparedPart& part, const Camera& camera, const TakeFragments& take) {
  project(part, camera, corners_);
  seen_.resize(chunk + PreparedPart::padding);
  for (std::size_t begin = 0; begin < part.triangle_count(); begin += chunk) {
    const std::size_t end = std::min(begin + chunk, part.triangle_count());
    std::span<const std::uint32_t> left(seen_.data(), find_seen(part, corners_, begin, end, seen_));
    while (!left.empty()) {
      left = left.subspan(draw_small(part, corners_, camera, left, fragments_));
      if (fragments_.is_full()) fragments_.hand_over(take);
      if (left.empty()) break;
      draw_large(part, corners_, camera, left[0], fragments_, take);
      left = left.subspan(1);
    }
  }
  fragments_.hand_over(take);
}

}  // namespace foredraw

#include <foredraw/displaced/seam_heights.h>

#include <algorithm>

namespace foredraw {

const DrawSeams* seams_of(const Scene& scene, DrawId draw) {
  const SeamHeights* all = scene.products.find<SeamHeights>();
  if (all == nullptr) return nullptr;
  const auto at = std::ranges::lower_bound(all->draws, draw, {}, &DrawSeams::draw);
  return at != all->draws.end() && at->draw == draw ? &*at : nullptr;
}

}  // namespace foredraw

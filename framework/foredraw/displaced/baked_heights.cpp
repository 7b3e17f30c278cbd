#include <foredraw/displaced/baked_heights.h>

#include <algorithm>

namespace foredraw {

const DrawHeights* heights_of(const Scene& scene, DrawId draw) {
  const BakedHeights* all = scene.products.find<BakedHeights>();
  if (all == nullptr) return nullptr;
  const auto at = std::ranges::lower_bound(all->draws, draw, {}, &DrawHeights::draw);
  return at != all->draws.end() && at->draw == draw ? &*at : nullptr;
}

}  // namespace foredraw

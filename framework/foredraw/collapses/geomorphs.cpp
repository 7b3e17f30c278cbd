#include <foredraw/collapses/geomorphs.h>

#include <algorithm>

namespace foredraw {

std::span<const std::uint32_t> ancestors_of(const Scene& scene, DrawLevel level) {
  const auto* all = scene.products.find<Geomorphs>();
  if (all == nullptr) return {};
  const auto found = std::ranges::find(all->draws, level.draw, &DrawGeomorph::draw);
  if (found == all->draws.end() || level.level >= found->ancestors.size()) return {};
  return found->ancestors[level.level].view();
}

}  // namespace foredraw

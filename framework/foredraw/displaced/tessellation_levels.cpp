#include <foredraw/displaced/tessellation_levels.h>

#include <algorithm>

namespace foredraw {

const DrawTessellation* tessellation_of(const Scene& scene, DrawId draw) {
  const auto* stored = scene.products.find<StoredTessellations>();
  if (stored == nullptr) return nullptr;
  const auto found = std::ranges::find(stored->draws, draw, &DrawTessellation::draw);
  return found == stored->draws.end() ? nullptr : &*found;
}

}  // namespace foredraw

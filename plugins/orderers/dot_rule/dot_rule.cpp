#include "dot_rule.h"

#include <foredraw/overdraw/outward_sequence.h>

namespace foredraw {

std::vector<std::uint32_t> dot_rule(Strided<glm::vec3> positions, std::span<const std::uint32_t> indices,
                                    const Clusters& clusters) {
  std::vector<SurfaceSum> surfaces(clusters.count());
  SurfaceSum mesh;
  for (std::size_t c = 0; c < surfaces.size(); ++c) {
    for (std::size_t i = 3 * clusters.offsets[c]; i < 3 * clusters.offsets[c + 1]; i += 3) {
      surfaces[c].add(positions[indices[i]], positions[indices[i + 1]], positions[indices[i + 2]]);
    }
    mesh += surfaces[c];
  }
  return outward_sequence(surfaces, mesh);
}

}  // namespace foredraw

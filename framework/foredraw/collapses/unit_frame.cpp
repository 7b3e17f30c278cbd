#include <foredraw/collapses/unit_frame.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace foredraw {

UnitFrame unit_frame(std::span<const glm::vec3> positions, const CollapseRecorder& recorder) {
  glm::dvec3 least(std::numeric_limits<double>::infinity()), most(-least);
  for (const CollapseRecorder::Corners& corners : recorder.points()) {
    for (const std::uint32_t p : corners) {
      if (!recorder.is_finite(p)) continue;
      for (int k = 0; k < 3; ++k) {
        least[k] = std::min(least[k], static_cast<double>(positions[p][k]));
        most[k] = std::max(most[k], static_cast<double>(positions[p][k]));
      }
    }
  }
  UnitFrame frame;
  if (!(least.x <= most.x)) return frame;
  glm::dvec3 size = most - least;
  frame.middle = least + 0.5 * size;
  const double extent = std::max({size.x, size.y, size.z});
  if (!(extent > 0)) return frame;
  frame.unit = std::ldexp(1.0, std::ilogb(extent));
  size /= frame.unit;
  frame.diagonal = std::sqrt(size.x * size.x + size.y * size.y + size.z * size.z);
  return frame;
}

}  // namespace foredraw

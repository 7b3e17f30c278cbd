#include <foredraw/analysis/ray_samples.h>

namespace foredraw {

glm::dvec3 random_direction(Random& random) {
  for (;;) {
    const double x = 2 * random.unit() - 1, y = 2 * random.unit() - 1, z = 2 * random.unit() - 1;
    const double squared = x * x + y * y + z * z;
    if (squared <= 1 && squared >= 0.01) return {x, y, z};
  }
}

glm::dvec3 random_point(const std::array<glm::dvec3, 3>& corners, Random& random) {
  double u = random.unit(), v = random.unit();
  if (u + v > 1) {
    u = 1 - u;
    v = 1 - v;
  }
  const glm::dvec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
  const glm::dvec3 point = corners[0] + u * (corners[1] - corners[0]) + v * (corners[2] - corners[0]);
  return middle + 0.98 * (point - middle);
}

}  // namespace foredraw

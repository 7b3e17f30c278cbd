#include "local_distance.h"

#include <foredraw/analysis/closest_points.h>

#include <algorithm>
#include <limits>

namespace foredraw::collapsing {

double squared_deviation(const CollapsingMesh& mesh, std::uint32_t p, std::uint32_t q, glm::vec3 place, double enough) {
  const glm::dvec3 to(place), from_p(mesh.point(p).place), from_q(mesh.point(q).place);
  // The least over all faces around of distance(b, c), b and c being the corners beside the joined one.
  const auto least_of = [&](bool with_shared, const auto& distance) {
    double least = std::numeric_limits<double>::infinity();
    for (const std::uint32_t one : {p, q}) {
      for (const std::uint32_t f : mesh.ring(one)) {
        const Face& face = mesh.face(f);
        if (!with_shared && face.has(one == p ? q : p)) continue;
        const int k = face.corner_of(one);
        const glm::dvec3 b(mesh.point(face.point[(k + 1) % 3]).place), c(mesh.point(face.point[(k + 2) % 3]).place);
        least = std::min(least, distance(one == p ? from_p : from_q, b, c));
        if (least <= enough) return 0.0;
      }
    }
    return least;
  };
  const double of_place = least_of(true, [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return squared_distance({a, b, c}, to);
  });
  const auto of = [&](const glm::dvec3& from) {
    return least_of(false, [&](const glm::dvec3&, const glm::dvec3& b, const glm::dvec3& c) {
      return squared_distance({to, b, c}, from);
    });
  };
  return std::max({of_place, of(from_p), of(from_q)});
}

}  // namespace foredraw::collapsing

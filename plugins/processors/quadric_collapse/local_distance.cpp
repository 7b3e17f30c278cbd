#include "local_distance.h"

#include <algorithm>
#include <limits>

namespace foredraw::collapsing {

double squared_distance(const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 ab = b - a, ac = c - a, from = point - a;
  const double bb = dot(ab, ab), bc = dot(ab, ac), cc = dot(ac, ac);
  const double along_b = dot(ab, from), along_c = dot(ac, from), straight = dot(from, from);
  // Barycentric coordinates of the foot, times the area: it lies within where none is negative.
  const double of_b = cc * along_b - bc * along_c, of_c = bb * along_c - bc * along_b, area = bb * cc - bc * bc;
  const bool has_area = area > 1e-12 * bb * cc;  // less is rounding
  if (has_area && of_b >= 0 && of_c >= 0 && of_b + of_c <= area) {
    return std::max(straight - (of_b * along_b + of_c * along_c) / area, 0.0);
  }
  // On an edge: the square that is left of `from` when the part along the edge is taken out.
  const auto to_edge = [](double square, double along, double length) {
    if (!(along > 0)) return square;
    if (along >= length) return square - 2 * along + length;
    return square - along * along / length;
  };
  double least = straight;
  if (of_c < 0 || !has_area) least = std::min(least, to_edge(straight, along_b, bb));
  if (of_b < 0 || !has_area) least = std::min(least, to_edge(straight, along_c, cc));
  if (!(of_b + of_c <= area) || !has_area) {
    const double from_b = straight - 2 * along_b + bb;
    least = std::min(least, to_edge(from_b, along_c - bc - along_b + bb, bb - 2 * bc + cc));
  }
  return std::max(least, 0.0);
}

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
    return squared_distance(to, a, b, c);
  });
  const auto of = [&](const glm::dvec3& from) {
    return least_of(false, [&](const glm::dvec3&, const glm::dvec3& b, const glm::dvec3& c) {
      return squared_distance(from, to, b, c);
    });
  };
  return std::max({of_place, of(from_p), of(from_q)});
}

}  // namespace foredraw::collapsing

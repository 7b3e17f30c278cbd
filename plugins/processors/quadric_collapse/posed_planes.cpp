#include "posed_planes.h"

#include <algorithm>
#include <cmath>

namespace foredraw::processors::quadric_collapse {

namespace {

/// map^T m map
Symmetric pulled_back(const Symmetric& m, const glm::dmat3& map) {
  const glm::dvec3 x = m * map[0], y = m * map[1], z = m * map[2];
  return {dot(map[0], x), dot(map[0], y), dot(map[0], z), dot(map[1], y), dot(map[1], z), dot(map[2], z)};
}

bool has_finite_sum(const Symmetric& m) { return std::isfinite(m.xx + m.xy + m.xz + m.yy + m.yz + m.zz); }

}  // namespace

PosedPlanes::PosedPlanes(const CollapsingMesh& mesh, const PosedVertices& posed, double weight)
    : mesh_(mesh),
      poses_(weight > 0 ? posed.poses() : 0),
      points_(poses_ * mesh.point_count()),
      normals_(poses_ * mesh.face_count()),
      sums_(points_.size()),
      changes_(empty() ? 0 : mesh.point_count(), ~std::uint32_t{0}) {
  for (const double share : posed.weights) scales_.push_back(std::sqrt(weight * share));
  for (std::uint32_t p = 0; p < changes_.size(); ++p) {
    for (std::size_t i = 0; i < poses_; ++i) {
      const glm::dmat4x3& map = posed.of(mesh.name_of(p))[i];
      const glm::dmat3 linear(map[0], map[1], map[2]);
      points_[p * poses_ + i] = {linear, linear * glm::dvec3(mesh.point(p).place) + map[3]};
    }
  }
}

void PosedPlanes::measure(std::uint32_t f) {
  const Face& face = mesh_.face(f);
  for (std::size_t i = 0; i < poses_; ++i) {
    const auto place = [&](int corner) { return points_[face.point[corner] * poses_ + i].place; };
    const glm::dvec3 normal = cross(place(1) - place(0), place(2) - place(0));
    const double length = std::sqrt(dot(normal, normal));
    const bool has_area = length > 0 && std::isfinite(length);
    normals_[f * poses_ + i] = has_area ? normal * (scales_[i] * std::sqrt(0.5 / length)) : glm::dvec3(0);
  }
}

const Symmetric* PosedPlanes::sums_at(std::uint32_t point) {
  Symmetric* sums = sums_.data() + point * poses_;
  if (changes_[point] == mesh_.changes(point).faces) return sums;
  changes_[point] = mesh_.changes(point).faces;
  std::fill_n(sums, poses_, Symmetric{});
  for (const std::uint32_t f : mesh_.ring(point)) {
    for (std::size_t i = 0; i < poses_; ++i) sums[i].add(normals_[f * poses_ + i], 1);
  }
  return sums;
}

/// The joined point moves from where one end is in the pose to where the other one is as it goes along the edge; and
/// across the edge as both ends do in the mean. So it lies on both ends exactly. Between them it is as far off as its
/// way is bent.
void PosedPlanes::add_around(std::uint32_t p, std::uint32_t q, std::span<const std::uint32_t> shared, Symmetric& of_p,
                             Symmetric& of_q) {
  const Symmetric *sums_p = sums_at(p), *sums_q = sums_at(q);
  const glm::dvec3 along = glm::dvec3(mesh_.point(q).place) - glm::dvec3(mesh_.point(p).place);
  const double length = dot(along, along);
  const glm::dvec3 step = length > 0 ? along / length : glm::dvec3(0);
  Symmetric sum_p, sum_q;
  for (std::size_t i = 0; i < poses_; ++i) {
    const Posed &at_p = points_[p * poses_ + i], &at_q = points_[q * poses_ + i];
    glm::dmat3 map = (at_p.linear + at_q.linear) * 0.5;
    const glm::dvec3 rest = at_q.place - at_p.place - map * along;
    for (int k = 0; k < 3; ++k) map[k] += rest * step[k];
    // What both have counts once. Both lie on it.
    Symmetric around_p = sums_p[i], around_q = sums_q[i];
    for (const std::uint32_t f : shared) {
      around_p.add(normals_[f * poses_ + i], -0.5);
      around_q.add(normals_[f * poses_ + i], -0.5);
    }
    sum_p.add(pulled_back(around_p, map));
    sum_q.add(pulled_back(around_q, map));
  }
  if (!has_finite_sum(sum_p) || !has_finite_sum(sum_q)) return;
  of_p.add(sum_p);
  of_q.add(sum_q);
}

void PosedPlanes::join(std::uint32_t removed, std::uint32_t kept, float blend, glm::vec3 place) {
  const glm::dvec3 from_removed = glm::dvec3(place) - glm::dvec3(mesh_.point(removed).place);
  const glm::dvec3 from_kept = glm::dvec3(place) - glm::dvec3(mesh_.point(kept).place);
  for (std::size_t i = 0; i < poses_; ++i) {
    const Posed& other = points_[removed * poses_ + i];
    Posed& point = points_[kept * poses_ + i];
    const glm::dvec3 by_other = other.place + other.linear * from_removed;
    const glm::dvec3 by_own = point.place + point.linear * from_kept;
    point.place = by_own + (by_other - by_own) * double{blend};
    point.linear += (other.linear - point.linear) * double{blend};
  }
}

}  // namespace foredraw::processors::quadric_collapse

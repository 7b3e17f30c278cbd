#include "local_distance.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "plugins/processors/quadric_collapse/local_distance.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "lanes.h"

#include <algorithm>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace foredraw::processors::quadric_collapse::HWY_NAMESPACE {

HWY_INLINE Vector everywhere(const glm::dvec3& v) { return {number(v.x), number(v.y), number(v.z)}; }
HWY_INLINE Vector loaded(const std::array<LocalDistance::Row, 3>& rows, std::size_t at) {
  return {loaded(rows[0].data() + at), loaded(rows[1].data() + at), loaded(rows[2].data() + at)};
}

/// Of a point from the edge that goes from a point `way` away from it.
HWY_INLINE Number from_edge(const Vector& way, const Vector& edge) {
  const Number length = dot(edge, edge), zero = number(0);
  const Number along = hn::Div(dot(way, edge), length);
  const Number part = hn::IfThenElse(hn::Gt(length, zero), hn::Min(hn::Max(along, zero), number(1)), zero);
  const Vector rest = difference(way, times(edge, part));
  return dot(rest, rest);
}

HWY_INLINE Number from_triangle(const Vector& point, const Vector& a, const Vector& b, const Vector& c) {
  const Vector ab = difference(b, a), bc = difference(c, b), ca = difference(a, c);
  const Vector to_a = difference(point, a), to_b = difference(point, b), to_c = difference(point, c);
  const Vector normal = cross(ab, bc);
  const Number squared = dot(normal, normal), zero = number(0);
  const auto is_left_of = [&](const Vector& edge, const Vector& way) {
    return hn::Ge(dot(cross(edge, way), normal), zero);
  };
  const auto is_over = hn::And(hn::And(is_left_of(ab, to_a), is_left_of(bc, to_b)),
                               hn::And(is_left_of(ca, to_c), hn::Gt(squared, zero)));
  const Number height = dot(to_a, normal);
  const Number edges = hn::Min(from_edge(to_a, ab), hn::Min(from_edge(to_b, bc), from_edge(to_c, ca)));
  return hn::IfThenElse(is_over, hn::Div(hn::Mul(height, height), squared), edges);
}

/// Of the point from the nearest of the first `count` triangles; their first corner is `joined`, if there is one.
HWY_INLINE double least(const LocalDistance::Rows& rows, std::size_t count, const glm::dvec3& point,
                        const glm::dvec3* joined) {
  const Doubles d;
  const double infinite = std::numeric_limits<double>::infinity();
  Number found = number(infinite);
  for (std::size_t at = 0; at < count; at += hn::Lanes(d)) {
    const Vector a = joined != nullptr ? everywhere(*joined) : loaded(rows.a, at);
    const Number some = from_triangle(everywhere(point), a, loaded(rows.b, at), loaded(rows.c, at));
    found = hn::Min(found, hn::IfThenElse(hn::FirstN(d, count - at), some, number(infinite)));
  }
  return hn::GetLane(hn::MinOfLanes(d, found));
}

HWY_ATTR double farthest(const LocalDistance::Rows& rows, const glm::dvec3& p, const glm::dvec3& q,
                         const glm::dvec3& place) {
  return std::max({least(rows, rows.all, place, nullptr), least(rows, rows.staying, p, &place),
                   least(rows, rows.staying, q, &place)});
}

}  // namespace foredraw::processors::quadric_collapse::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace foredraw::processors::quadric_collapse {

HWY_EXPORT(farthest);

void LocalDistance::add(const CollapsingMesh& mesh, std::uint32_t point, const Face& face) {
  const int k = face.corner_of(point);
  const glm::vec3& b = mesh.point(face.point[(k + 1) % 3]).place;
  const glm::vec3& c = mesh.point(face.point[(k + 2) % 3]).place;
  for (int i = 0; i < 3; ++i) {
    rows_.a[i][rows_.all] = mesh.point(point).place[i];
    rows_.b[i][rows_.all] = b[i];
    rows_.c[i][rows_.all] = c[i];
  }
  ++rows_.all;
}

double LocalDistance::squared(const CollapsingMesh& mesh, std::uint32_t p, std::uint32_t q, glm::vec3 place) {
  rows_.all = 0;
  for (const std::uint32_t one : {p, q}) {
    for (const std::uint32_t f : mesh.ring(one)) {
      if (!mesh.face(f).has(one == p ? q : p)) add(mesh, one, mesh.face(f));
    }
  }
  rows_.staying = rows_.all;
  for (const std::uint32_t f : mesh.ring(p)) {
    if (mesh.face(f).has(q)) add(mesh, p, mesh.face(f));
  }
  return HWY_DYNAMIC_DISPATCH(farthest)(rows_, glm::dvec3(mesh.point(p).place), glm::dvec3(mesh.point(q).place),
                                        glm::dvec3(place));
}

}  // namespace foredraw::processors::quadric_collapse
#endif

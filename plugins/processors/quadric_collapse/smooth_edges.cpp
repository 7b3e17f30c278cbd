#include "smooth_edges.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "plugins/processors/quadric_collapse/smooth_edges.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "lanes.h"

HWY_BEFORE_NAMESPACE();
namespace foredraw::processors::quadric_collapse::HWY_NAMESPACE {

static_assert(SmoothEdges::most == most_lanes);

struct Matrix {
  Number xx, xy, xz, yy, yz, zz;
};

HWY_INLINE Number loaded(const SmoothEdges::Row& row, std::size_t at) { return loaded(row.data() + at); }
HWY_INLINE Vector loaded(const std::array<SmoothEdges::Row, 3>& rows, std::size_t at) {
  return {loaded(rows[0], at), loaded(rows[1], at), loaded(rows[2], at)};
}
HWY_INLINE Matrix loaded(const std::array<SmoothEdges::Row, 6>& rows, std::size_t at) {
  return {loaded(rows[0], at), loaded(rows[1], at), loaded(rows[2], at),
          loaded(rows[3], at), loaded(rows[4], at), loaded(rows[5], at)};
}
HWY_INLINE Matrix sum(const Matrix& a, const Matrix& b) {
  return {hn::Add(a.xx, b.xx), hn::Add(a.xy, b.xy), hn::Add(a.xz, b.xz),
          hn::Add(a.yy, b.yy), hn::Add(a.yz, b.yz), hn::Add(a.zz, b.zz)};
}
HWY_INLINE Vector product(const Matrix& m, const Vector& v) {
  return {dot({m.xx, m.xy, m.xz}, v), dot({m.xy, m.yy, m.yz}, v), dot({m.xz, m.yz, m.zz}, v)};
}
/// The matrix without weight * v v^T.
HWY_INLINE Matrix without(const Matrix& m, const Vector& v, Number weight) {
  const Vector w = times(v, weight);
  return {hn::Sub(m.xx, hn::Mul(w.x, v.x)), hn::Sub(m.xy, hn::Mul(w.x, v.y)), hn::Sub(m.xz, hn::Mul(w.x, v.z)),
          hn::Sub(m.yy, hn::Mul(w.y, v.y)), hn::Sub(m.yz, hn::Mul(w.y, v.z)), hn::Sub(m.zz, hn::Mul(w.z, v.z))};
}
/// The inverse times the determinant.
HWY_INLINE Matrix adjugate(const Matrix& m) {
  const auto minor = [](Number a, Number b, Number c, Number d) { return hn::Sub(hn::Mul(a, b), hn::Mul(c, d)); };
  return {minor(m.yy, m.zz, m.yz, m.yz), minor(m.xz, m.yz, m.xy, m.zz), minor(m.xy, m.yz, m.xz, m.yy),
          minor(m.xx, m.zz, m.xz, m.xz), minor(m.xy, m.xz, m.xx, m.yz), minor(m.xx, m.yy, m.xy, m.xy)};
}

/// As EdgeCosts::around() and least() say it, and in their sequence.
HWY_ATTR void solve(const SmoothEdges::Rows& rows, std::size_t at, SmoothEdges::Answers& answers) {
  const Number zero = number(0);
  const Vector there = loaded(rows.there, at), from = loaded(rows.from, at);
  const Matrix of_b = loaded(rows.b.matrix, at);
  const Vector b_vector = loaded(rows.b.vector, at);
  const Vector moved = sum(product(of_b, there), b_vector);
  const Vector vector = sum(loaded(rows.a.vector, at), moved);
  const Number constant =
      hn::Add(loaded(rows.a.constant, at), hn::Add(dot(there, sum(moved, b_vector)), loaded(rows.b.constant, at)));
  Matrix matrix = sum(loaded(rows.a.matrix, at), of_b);
  Vector area = loaded(rows.b.area, at);
  for (const SmoothEdges::Normal* shared : {&rows.f, &rows.g}) {
    const Vector normal = loaded(shared->normal, at);
    matrix = without(matrix, normal, loaded(shared->weight, at));
    area = difference(area, normal);
  }
  const Vector volume = sum(loaded(rows.a.area, at), area);

  const Vector preferred = times(there, number(0.5));
  const Number trace = hn::Add(hn::Add(matrix.xx, matrix.yy), matrix.zz);
  const Number tie = hn::Mul(trace, number(preference));
  Matrix tied = matrix;
  tied.xx = hn::Add(tied.xx, tie), tied.yy = hn::Add(tied.yy, tie), tied.zz = hn::Add(tied.zz, tie);
  const Matrix adjoint = adjugate(tied);
  const Number determinant = dot({tied.xx, tied.xy, tied.xz}, {adjoint.xx, adjoint.xy, adjoint.xz});
  const Vector right = product(adjoint, sum(vector, times(preferred, tie)));
  const Vector free = {hn::Div(right.x, determinant), hn::Div(right.y, determinant), hn::Div(right.z, determinant)};
  const Vector towards = product(adjoint, volume);
  const Number slope = dot(towards, volume);
  const Number steps = hn::Div(hn::Sub(dot(volume, free), dot(area, there)), slope);
  const auto is_solved = hn::And(hn::Gt(trace, zero), hn::Gt(determinant, zero));
  const Vector kept = chosen(hn::Gt(slope, zero), difference(free, times(towards, steps)), free);
  const Vector least = chosen(is_solved, kept, preferred);

  const auto in_floats = [](Number a, Number b) {
    const hn::Rebind<float, Doubles> floats;
    return hn::PromoteTo(Doubles(), hn::DemoteTo(floats, hn::Add(a, b)));
  };
  const Vector place = {in_floats(from.x, least.x), in_floats(from.y, least.y), in_floats(from.z, least.z)};
  const Vector way = difference(place, from);
  const Vector slant = difference(product(matrix, way), times(vector, number(2)));
  hn::Store(hn::Add(dot(way, slant), constant), Doubles(), answers.cost.data() + at);
  hn::Store(place.x, Doubles(), answers.place[0].data() + at);
  hn::Store(place.y, Doubles(), answers.place[1].data() + at);
  hn::Store(place.z, Doubles(), answers.place[2].data() + at);
}

HWY_ATTR void solve_edges(const SmoothEdges::Rows& rows, std::size_t count, SmoothEdges::Answers& answers) {
  for (std::size_t at = 0; at < count; at += hn::Lanes(Doubles())) solve(rows, at, answers);
}

}  // namespace foredraw::processors::quadric_collapse::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace foredraw::processors::quadric_collapse {

HWY_EXPORT(solve_edges);

namespace {

template <std::size_t count>
void put(std::array<SmoothEdges::Row, count>& rows, std::size_t at, const std::array<double, count>& values) {
  for (std::size_t i = 0; i < count; ++i) rows[i][at] = values[i];
}

void put(std::array<SmoothEdges::Row, 3>& rows, std::size_t at, const glm::dvec3& v) {
  put(rows, at, std::array{v.x, v.y, v.z});
}

void put(SmoothEdges::Surroundings& rows, std::size_t at, const Around& around) {
  const Symmetric& m = around.planes.matrix;
  put(rows.matrix, at, std::array{m.xx, m.xy, m.xz, m.yy, m.yz, m.zz});
  put(rows.vector, at, around.planes.vector);
  rows.constant[at] = around.planes.constant;
  put(rows.area, at, around.area);
}

void put(SmoothEdges::Normal& rows, std::size_t at, const FacePlane& plane) {
  put(rows.normal, at, plane.normal);
  rows.weight[at] = plane.weight;
}

}  // namespace

void SmoothEdges::add(glm::vec3 a_place, const Around& a, glm::vec3 b_place, const Around& b, const FacePlane& f,
                      const FacePlane& g) {
  const glm::dvec3 from(a_place);
  put(rows_.a, size_, a);
  put(rows_.b, size_, b);
  put(rows_.f, size_, f);
  put(rows_.g, size_, g);
  put(rows_.from, size_, from);
  put(rows_.there, size_, glm::dvec3(b_place) - from);
  ++size_;
}

std::span<const EdgeCost> SmoothEdges::costs() {
  HWY_DYNAMIC_DISPATCH(solve_edges)(rows_, size_, answers_);
  for (std::size_t i = 0; i < size_; ++i) {
    costs_[i].cost = answers_.cost[i];
    for (int k = 0; k < 3; ++k) costs_[i].place[k] = static_cast<float>(answers_.place[k][i]);
  }
  return {costs_.data(), size_};
}

}  // namespace foredraw::processors::quadric_collapse
#endif

#pragma once
// Symmetric 3 x 3 matrices of doubles, which is what is left of a quadric at a point that lies on all its planes.

#include <glm/vec3.hpp>

namespace foredraw::processors::quadric_collapse {

struct Symmetric {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

  /// Adds weight * v v^T.
  void add(const glm::dvec3& v, double weight) {
    const glm::dvec3 w = v * weight;
    xx += w.x * v.x, xy += w.x * v.y, xz += w.x * v.z;
    yy += w.y * v.y, yz += w.y * v.z, zz += w.z * v.z;
  }
  /// Adds a b^T + b a^T.
  void add_both(const glm::dvec3& a, const glm::dvec3& b) {
    xx += 2 * a.x * b.x, xy += a.x * b.y + a.y * b.x, xz += a.x * b.z + a.z * b.x;
    yy += 2 * a.y * b.y, yz += a.y * b.z + a.z * b.y, zz += 2 * a.z * b.z;
  }
  void add(const Symmetric& o, double weight = 1) {
    xx += o.xx * weight, xy += o.xy * weight, xz += o.xz * weight;
    yy += o.yy * weight, yz += o.yz * weight, zz += o.zz * weight;
  }
  double trace() const { return xx + yy + zz; }
};

inline double dot(const glm::dvec3& a, const glm::dvec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline glm::dvec3 cross(const glm::dvec3& a, const glm::dvec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline glm::dvec3 operator*(const Symmetric& m, const glm::dvec3& v) {
  return {m.xx * v.x + m.xy * v.y + m.xz * v.z, m.xy * v.x + m.yy * v.y + m.yz * v.z,
          m.xz * v.x + m.yz * v.y + m.zz * v.z};
}

/// x^T matrix x - 2 x^T vector + constant.
struct Quadric {
  Symmetric matrix;
  glm::dvec3 vector{0};
  double constant = 0;

  double at(const glm::dvec3& x) const { return dot(x, matrix * x - 2.0 * vector) + constant; }
  /// Adds weight * o.
  void add(const Quadric& o, double weight = 1) {
    matrix.add(o.matrix, weight);
    vector += o.vector * weight;
    constant += o.constant * weight;
  }
  /// Takes away weight * (slope . x + offset)^2.
  void subtract_square(const glm::dvec3& slope, double offset, double weight) {
    matrix.add(slope, -weight);
    vector += slope * (offset * weight);
    constant -= offset * offset * weight;
  }
  /// Adds o(x - from).
  void add_about(const Quadric& o, const glm::dvec3& from) {
    const glm::dvec3 moved = o.matrix * from + o.vector;
    matrix.add(o.matrix);
    vector += moved;
    constant += dot(from, moved + o.vector) + o.constant;
  }
};

/// Half of a plane: where normal . x = offset.
struct Constraint {
  glm::dvec3 normal{0};
  double offset = 0;
};

/// How much a preferred place counts beside the planes, whose trace is 1. Small enough to cost no accuracy that floats
/// can show, large enough for a determinant that is more than rounding.
inline constexpr double preference = 1e-6;

/// Where the quadric is least, on the constraint if its normal is not 0. What it leaves open, such as the directions of
/// a flat piece, is decided by `preferred`.
glm::dvec3 least(const Quadric& quadric, const Constraint& constraint, const glm::dvec3& preferred);

}  // namespace foredraw::processors::quadric_collapse

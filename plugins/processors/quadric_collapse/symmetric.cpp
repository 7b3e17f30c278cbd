#include "symmetric.h"

namespace foredraw::processors::quadric_collapse {

namespace {

/// The inverse times the determinant.
Symmetric adjugate(const Symmetric& m) {
  return {m.yy * m.zz - m.yz * m.yz, m.xz * m.yz - m.xy * m.zz, m.xy * m.yz - m.xz * m.yy,
          m.xx * m.zz - m.xz * m.xz, m.xy * m.xz - m.xx * m.yz, m.xx * m.yy - m.xy * m.xy};
}

}  // namespace

glm::dvec3 least(const Quadric& quadric, const Constraint& constraint, const glm::dvec3& preferred) {
  const double trace = quadric.matrix.trace();
  if (!(trace > 0)) return preferred;
  Symmetric m = quadric.matrix;
  const double tie = trace * preference;
  m.xx += tie, m.yy += tie, m.zz += tie;
  const Symmetric adjoint = adjugate(m);
  const double determinant = m.xx * adjoint.xx + m.xy * adjoint.xy + m.xz * adjoint.xz;
  if (!(determinant > 0)) return preferred;
  const glm::dvec3 free = (adjoint * (quadric.vector + tie * preferred)) / determinant;
  const glm::dvec3 towards = adjoint * constraint.normal;
  const double slope = dot(towards, constraint.normal);
  if (!(slope > 0)) return free;
  return free - towards * ((dot(constraint.normal, free) - constraint.offset) / slope);
}

}  // namespace foredraw::processors::quadric_collapse

// Vectors in space, several side by side: for files that Highway compiles once for each vector unit, so without a guard
// of the usual kind.
#if defined(FOREDRAW_COLLAPSING_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef FOREDRAW_COLLAPSING_LANES
#undef FOREDRAW_COLLAPSING_LANES
#else
#define FOREDRAW_COLLAPSING_LANES
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace foredraw::processors::quadric_collapse::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
constexpr std::size_t most_lanes = 8;
using Doubles = hn::CappedTag<double, most_lanes>;
using Number = hn::Vec<Doubles>;

struct Vector {
  Number x, y, z;
};

HWY_INLINE Number loaded(const double* from) { return hn::Load(Doubles(), from); }
HWY_INLINE Number number(double value) { return hn::Set(Doubles(), value); }

HWY_INLINE Vector sum(const Vector& a, const Vector& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
HWY_INLINE Vector difference(const Vector& a, const Vector& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE Vector times(const Vector& v, Number by) { return {hn::Mul(v.x, by), hn::Mul(v.y, by), hn::Mul(v.z, by)}; }
HWY_INLINE Number dot(const Vector& a, const Vector& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_INLINE Vector chosen(hn::Mask<Doubles> first, const Vector& a, const Vector& b) {
  return {hn::IfThenElse(first, a.x, b.x), hn::IfThenElse(first, a.y, b.y), hn::IfThenElse(first, a.z, b.z)};
}
HWY_INLINE Vector cross(const Vector& a, const Vector& b) {
  return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
          hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}

}  // namespace foredraw::processors::quadric_collapse::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

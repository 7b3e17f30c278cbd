// What packing and unpacking in vector registers have in common: runtime/packed_vertex.h, operation by operation.
// Included once for each vector unit.

#include <foredraw/runtime/packed_vertex.h>

#include <hwy/highway.h>

#if defined(FOREDRAW_VERTEX_PACK_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FOREDRAW_VERTEX_PACK_LANES_H
#undef FOREDRAW_VERTEX_PACK_LANES_H
#else
#define FOREDRAW_VERTEX_PACK_LANES_H
#endif

HWY_BEFORE_NAMESPACE();
namespace foredraw::processors::vertex_pack::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, 8>;
using Ints = hn::RebindToSigned<Floats>;
using Words = hn::RebindToUnsigned<Floats>;
using Number = hn::Vec<Floats>;
using Whole = hn::Vec<Ints>;
using Word = hn::Vec<Words>;

struct Three {
  Number x, y, z;
};

HWY_INLINE Number number(float value) { return hn::Set(Floats(), value); }
HWY_INLINE Whole whole(std::int32_t value) { return hn::Set(Ints(), value); }

HWY_INLINE Number rsqrt(Number x) {
  const Number half = hn::Mul(number(0.5f), x), more = number(1.5f);
  const Words u;
  const Word bits = hn::Sub(hn::Set(u, 0x5f375a86u), hn::ShiftRight<1>(hn::BitCast(u, x)));
  Number y = hn::BitCast(Floats(), bits);
  y = hn::Mul(y, hn::Sub(more, hn::Mul(hn::Mul(half, y), y)));
  y = hn::Mul(y, hn::Sub(more, hn::Mul(hn::Mul(half, y), y)));
  return hn::Mul(y, hn::Sub(more, hn::Mul(hn::Mul(half, y), y)));
}

HWY_INLINE Number reciprocal(Number x) {
  const Number root = rsqrt(x);
  return hn::Mul(root, root);
}

/// Of whole coordinates on the octahedron's square, from its middle on.
HWY_INLINE Three octahedral(Whole x, Whole y, Whole half) {
  const Whole zero = hn::Zero(Ints());
  const Whole z = hn::Sub(hn::Sub(half, hn::Abs(x)), hn::Abs(y));
  const Whole fold = hn::Max(hn::Neg(z), zero);
  x = hn::IfThenElse(hn::Lt(x, zero), hn::Add(x, fold), hn::Sub(x, fold));
  y = hn::IfThenElse(hn::Lt(y, zero), hn::Add(y, fold), hn::Sub(y, fold));
  const Floats f;
  const Whole squared = hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
  const Number per_length = rsqrt(hn::ConvertTo(f, squared));
  return {hn::Mul(hn::ConvertTo(f, x), per_length), hn::Mul(hn::ConvertTo(f, y), per_length),
          hn::Mul(hn::ConvertTo(f, z), per_length)};
}

}  // namespace foredraw::processors::vertex_pack::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

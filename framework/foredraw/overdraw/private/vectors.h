// What the rasteriser's files say of vector registers, once for every width: registers of 32-bit integers, and pairs of
// registers of doubles with as many lanes.

#if defined(FOREDRAW_VECTORS) == defined(HWY_TARGET_TOGGLE)
#ifdef FOREDRAW_VECTORS
#undef FOREDRAW_VECTORS
#else
#define FOREDRAW_VECTORS
#endif

#include <hwy/highway.h>

#include <array>
#include <cstdint>

#ifndef FOREDRAW_FRONT_LANES
#define FOREDRAW_FRONT_LANES
namespace foredraw {

/// [bits]: the numbers of the set bits, ascending, and then of the others.
inline constexpr auto front_lanes = [] {
  std::array<std::array<std::uint8_t, 8>, 256> table{};
  for (std::size_t bits = 0; bits < 256; ++bits) {
    std::size_t count = 0;
    for (const std::size_t wanted : {1u, 0u}) {
      for (std::uint8_t i = 0; i < 8; ++i) {
        if ((bits >> i & 1) == wanted) table[bits][count++] = i;
      }
    }
  }
  return table;
}();

}  // namespace foredraw
#endif

HWY_BEFORE_NAMESPACE();
namespace foredraw::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR

constexpr std::size_t most_lanes = 16;

using Ints = hn::CappedTag<std::int32_t, most_lanes>;
using Words = hn::RebindToUnsigned<Ints>;
using HalfInts = hn::Half<Ints>;
using Doubles = hn::Rebind<double, HalfInts>;
using IntVector = hn::Vec<Ints>;
using IntMask = hn::Mask<Ints>;
using DoubleVector = hn::Vec<Doubles>;

HWY_INLINE IntVector all(std::int32_t value) { return hn::Set(Ints(), value); }
HWY_INLINE IntVector load_words(const std::uint32_t* from) { return hn::BitCast(Ints(), hn::LoadU(Words(), from)); }
HWY_INLINE void store_words(IntVector values, std::uint32_t* to) {
  hn::StoreU(hn::BitCast(Words(), values), Words(), to);
}

/// values[indices[lane]], loaded one by one: quicker than the instruction that is made for it.
template <class D, class T, std::size_t lanes = hn::MaxLanes(D())>
HWY_INLINE hn::Vec<D> gathered(D d, const std::uint32_t* indices, const T* values) {
  if constexpr (lanes == 1) {
    return hn::LoadU(d, values + indices[0]);
  } else {
    const hn::Half<D> half;
    return hn::Combine(d, gathered(half, indices + lanes / 2, values), gathered(half, indices, values));
  }
}

/// One bit a lane, the first one lowest.
HWY_INLINE std::uint32_t bits_of(IntMask mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(Ints(), mask, bytes);
  return bytes[0] | std::uint32_t{bytes[1]} << 8;
}

/// The lanes for which a bit is set, moved to the front.
template <class D>
HWY_INLINE hn::Vec<D> compressed(D d, hn::Vec<D> values, std::uint32_t bits) {
  static_assert(hn::MaxLanes(D()) <= 8);
  const auto lanes = hn::PromoteTo(d, hn::LoadU(hn::Rebind<std::uint8_t, D>(), front_lanes[bits].data()));
  const auto in_range = hn::And(lanes, hn::Set(d, static_cast<std::int32_t>(hn::Lanes(d)) - 1));
  return hn::TableLookupLanes(values, hn::IndicesFromVec(d, in_range));
}

HWY_INLINE IntVector compressed(IntVector values, IntMask mask) {
#if HWY_ARCH_X86 && HWY_TARGET > HWY_AVX3
  return compressed(Ints(), values, bits_of(mask));  // the library's own copies its table for every call
#else
  return hn::Compress(values, mask);
#endif
}

/// Compared by x, then y, then z.
HWY_INLINE IntMask is_less(IntVector ax, IntVector ay, IntVector az, IntVector bx, IntVector by, IntVector bz) {
  const IntMask by_y = hn::Or(hn::Lt(ay, by), hn::And(hn::Eq(ay, by), hn::Lt(az, bz)));
  return hn::Or(hn::Lt(ax, bx), hn::And(hn::Eq(ax, bx), by_y));
}

struct DoublePair {
  DoubleVector lower, upper;

  friend HWY_INLINE DoublePair operator+(const DoublePair& a, const DoublePair& b) {
    return {hn::Add(a.lower, b.lower), hn::Add(a.upper, b.upper)};
  }
  friend HWY_INLINE DoublePair operator-(const DoublePair& a, const DoublePair& b) {
    return {hn::Sub(a.lower, b.lower), hn::Sub(a.upper, b.upper)};
  }
  friend HWY_INLINE DoublePair operator*(const DoublePair& a, const DoublePair& b) {
    return {hn::Mul(a.lower, b.lower), hn::Mul(a.upper, b.upper)};
  }
  friend HWY_INLINE DoublePair operator/(const DoublePair& a, const DoublePair& b) {
    return {hn::Div(a.lower, b.lower), hn::Div(a.upper, b.upper)};
  }
};

HWY_INLINE DoublePair both(double value) { return {hn::Set(Doubles(), value), hn::Set(Doubles(), value)}; }

HWY_INLINE DoublePair at_least_zero(const DoublePair& values) {
  const DoubleVector zero = hn::Zero(Doubles());
  return {hn::Max(values.lower, zero), hn::Max(values.upper, zero)};
}

HWY_INLINE DoublePair to_doubles(IntVector values) {
  return {hn::PromoteTo(Doubles(), hn::LowerHalf(HalfInts(), values)),
          hn::PromoteTo(Doubles(), hn::UpperHalf(HalfInts(), values))};
}

HWY_INLINE IntMask is_more(const DoublePair& values, double than) {
  const DoubleVector limit = hn::Set(Doubles(), than);
  const auto as_ints = [&](DoubleVector half) HWY_ATTR {
    return hn::DemoteTo(HalfInts(), hn::IfThenElse(hn::Gt(half, limit), hn::Set(Doubles(), 1), hn::Zero(Doubles())));
  };
  return hn::Gt(hn::Combine(Ints(), as_ints(values.upper), as_ints(values.lower)), hn::Zero(Ints()));
}

/// Towards zero.
HWY_INLINE IntVector to_ints(const DoublePair& values) {
  return hn::Combine(Ints(), hn::DemoteTo(HalfInts(), values.upper), hn::DemoteTo(HalfInts(), values.lower));
}

HWY_INLINE void store(const DoublePair& values, double* to) {
  hn::StoreU(values.lower, Doubles(), to);
  hn::StoreU(values.upper, Doubles(), to + hn::Lanes(Doubles()));
}

#endif

}  // namespace foredraw::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

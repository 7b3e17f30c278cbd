// From differences to elements. A channel is summed up in registers: a few words at a time first, then on from what
// came before them. Then up to four channels are put side by side.
#include <foredraw/io/meshopt/private/planes.h>

#include <bit>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "foredraw/io/meshopt/sum_up_planes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace foredraw::meshopt::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Words = std::uint32_t[channels_at_once][most_in_block];

#if HWY_TARGET == HWY_SCALAR

/// Each `width` bits of a word, plus what the zigzag of its difference says.
std::uint32_t sum_of(std::uint32_t word, std::uint32_t zigzag, std::uint32_t width) {
  std::uint32_t sum = 0;
  const std::uint32_t mask = (1u << width) - 1;
  for (std::uint32_t at = 0; at < 32; at += width) {
    const std::uint32_t part = zigzag >> at & mask;
    sum |= (((word >> at) + (part >> 1 ^ (0u - (part & 1)))) & mask) << at;
  }
  return sum;
}

void sum_up(const Byte* planes, unsigned mode, std::size_t count, std::uint32_t last, std::uint32_t* words) {
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t difference = 0;
    for (std::size_t p = channel_bytes; p-- > 0;) difference = difference << 8 | planes[p * most_in_block + i];
    last =
        mode > 1 ? last ^ std::rotr(difference, static_cast<int>(mode >> 4)) : sum_of(last, difference, 8 * (mode + 1));
    words[i] = last;
  }
}

template <std::size_t channels>
void put_elements(const Words& words, std::size_t count, std::size_t stride, Byte* to) {
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t c = 0; c < channels; ++c) std::memcpy(to + i * stride + 4 * c, &words[c][i], channel_bytes);
  }
}

#else

using Wide = hn::CappedTag<Byte, 32>;
using Halves = hn::Repartition<std::uint16_t, Wide>;
using Vector = hn::Vec<hn::Repartition<std::uint32_t, Wide>>;

constexpr hn::Repartition<std::uint32_t, Wide> wide_words;

template <class D>
HWY_INLINE hn::Vec<D> unzigzag(D d, hn::Vec<D> v) {
  return hn::Xor(hn::ShiftRight<1>(v), hn::Sub(hn::Zero(d), hn::And(v, hn::Set(d, 1))));
}

/// What a mode of a channel makes of the stored words, and how it adds them up.
struct BytesMode {
  HWY_INLINE Vector difference(Vector v) const {
    return hn::BitCast(wide_words, unzigzag(Wide(), hn::BitCast(Wide(), v)));
  }
  HWY_INLINE Vector sum(Vector a, Vector b) const {
    return hn::BitCast(wide_words, hn::Add(hn::BitCast(Wide(), a), hn::BitCast(Wide(), b)));
  }
};

struct HalvesMode {
  HWY_INLINE Vector difference(Vector v) const {
    return hn::BitCast(wide_words, unzigzag(Halves(), hn::BitCast(Halves(), v)));
  }
  HWY_INLINE Vector sum(Vector a, Vector b) const {
    return hn::BitCast(wide_words, hn::Add(hn::BitCast(Halves(), a), hn::BitCast(Halves(), b)));
  }
};

struct BitsMode {
  int turn;
  HWY_INLINE Vector difference(Vector v) const {
    return hn::Or(hn::ShiftRightSame(v, turn), hn::ShiftLeftSame(v, (32 - turn) & 31));
  }
  HWY_INLINE Vector sum(Vector a, Vector b) const { return hn::Xor(a, b); }
};

/// A register's parts of 16 bytes, `step` words from one to the next.
template <class D, class V>
HWY_INLINE void store_parts(D, V v, std::uint32_t* to, std::size_t step) {
  if constexpr (hn::MaxLanes(D()) == 4) {
    hn::StoreU(v, D(), to);
  } else {
    const hn::Half<D> half;
    hn::StoreU(hn::LowerHalf(half, v), half, to);
    hn::StoreU(hn::UpperHalf(half, v), half, to + step);
  }
}

/// The words of a channel from its 4 planes, `last` before them. A register has one or two parts of 16 bytes; the q-th
/// of four has in each part words 4q to 4q + 3 of 16.
template <class Mode>
HWY_INLINE void sum_up_as(Mode mode, const Byte* planes, std::size_t count, std::uint32_t last, std::uint32_t* words) {
  const Wide d;
  const Halves halves;
  Vector before = hn::Set(wide_words, last);
  for (std::size_t first = 0; first < count; first += hn::Lanes(d)) {
    const auto plane = [&](std::size_t p) HWY_ATTR { return hn::Load(d, planes + p * most_in_block + first); };
    const auto a = plane(0), b = plane(1), c = plane(2), e = plane(3);
    const auto low = hn::BitCast(halves, hn::InterleaveLower(d, a, b));
    const auto high = hn::BitCast(halves, hn::InterleaveUpper(d, a, b));
    const auto low_too = hn::BitCast(halves, hn::InterleaveLower(d, c, e));
    const auto high_too = hn::BitCast(halves, hn::InterleaveUpper(d, c, e));
    Vector sums[4] = {hn::BitCast(wide_words, hn::InterleaveLower(halves, low, low_too)),
                      hn::BitCast(wide_words, hn::InterleaveUpper(halves, low, low_too)),
                      hn::BitCast(wide_words, hn::InterleaveLower(halves, high, high_too)),
                      hn::BitCast(wide_words, hn::InterleaveUpper(halves, high, high_too))};
    for (Vector& v : sums) {
      v = mode.difference(v);
      v = mode.sum(v, hn::ShiftLeftLanes<1>(wide_words, v));
      v = mode.sum(v, hn::ShiftLeftLanes<2>(wide_words, v));
    }
    for (std::size_t q = 1; q < 4; ++q) sums[q] = mode.sum(sums[q], hn::Broadcast<3>(sums[q - 1]));
    const Vector totals = hn::Broadcast<3>(sums[3]);
    Vector start = before;
    before = mode.sum(before, totals);
    if constexpr (hn::MaxLanes(Wide()) == 32) {
      start = mode.sum(start, hn::ConcatLowerLower(wide_words, totals, hn::Zero(wide_words)));
      before = mode.sum(before, hn::ConcatLowerUpper(wide_words, totals, totals));  // parts the other way round
    }
    for (std::size_t q = 0; q < 4; ++q) {
      store_parts(wide_words, mode.sum(start, sums[q]), words + first + 4 * q, 16);
    }
  }
}

void sum_up(const Byte* planes, unsigned mode, std::size_t count, std::uint32_t last, std::uint32_t* words) {
  if (mode == 0) return sum_up_as(BytesMode(), planes, count, last, words);
  if (mode == 1) return sum_up_as(HalvesMode(), planes, count, last, words);
  sum_up_as(BitsMode{static_cast<int>(mode >> 4)}, planes, count, last, words);
}

/// Words of up to four channels side by side.
template <std::size_t channels>
HWY_INLINE void put_elements(const Words& words, std::size_t count, std::size_t stride, Byte* to) {
  const hn::FixedTag<std::uint32_t, 4> d;
  const hn::FixedTag<std::uint64_t, 2> pairs;
  const hn::FixedTag<Byte, 16> sixteen;
  const hn::FixedTag<Byte, 8> eight;
  std::size_t i = 0;
  const auto put = [&](std::size_t at, hn::Vec<hn::FixedTag<std::uint64_t, 2>> row) HWY_ATTR {
    Byte* target = to + at * stride;
    const auto bytes = hn::BitCast(sixteen, row);
    if constexpr (channels == 4) hn::StoreU(bytes, sixteen, target);
    if constexpr (channels < 4) hn::StoreU(hn::LowerHalf(eight, bytes), eight, target);
    if constexpr (channels == 3) {
      const std::uint32_t third = hn::ExtractLane(hn::BitCast(d, row), 2);
      std::memcpy(target + 8, &third, channel_bytes);
    }
  };
  if constexpr (channels > 1) {
    for (; i + 4 <= count; i += 4) {
      const auto channel = [&](std::size_t c)
                               HWY_ATTR { return c < channels ? hn::Load(d, words[c] + i) : hn::Zero(d); };
      const auto lower = [&](std::size_t c) HWY_ATTR {
        return hn::BitCast(pairs, hn::InterleaveLower(d, channel(c), channel(c + 1)));
      };
      const auto upper = [&](std::size_t c) HWY_ATTR {
        return hn::BitCast(pairs, hn::InterleaveUpper(d, channel(c), channel(c + 1)));
      };
      put(i, hn::InterleaveLower(pairs, lower(0), lower(2)));
      put(i + 1, hn::InterleaveUpper(pairs, lower(0), lower(2)));
      put(i + 2, hn::InterleaveLower(pairs, upper(0), upper(2)));
      put(i + 3, hn::InterleaveUpper(pairs, upper(0), upper(2)));
    }
  } else if (stride == channel_bytes) {
    std::memcpy(to, words[0], count * channel_bytes);
    return;
  }
  for (; i < count; ++i) {
    for (std::size_t c = 0; c < channels; ++c) std::memcpy(to + i * stride + 4 * c, &words[c][i], channel_bytes);
  }
}

#endif

void sum_up_planes(const Planes& planes, const Byte* modes, std::size_t channels, std::size_t count, const Byte* last,
                   std::size_t stride, Byte* to) {
  alignas(64) Words words;
  for (std::size_t c = 0; c < channels; ++c) {
    std::uint32_t before;
    std::memcpy(&before, last + c * channel_bytes, channel_bytes);
    sum_up(planes[c * channel_bytes], modes[c], count, before, words[c]);
  }
  switch (channels) {
    case 1: return put_elements<1>(words, count, stride, to);
    case 2: return put_elements<2>(words, count, stride, to);
    case 3: return put_elements<3>(words, count, stride, to);
    default: put_elements<4>(words, count, stride, to);
  }
}

}  // namespace foredraw::meshopt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace foredraw::meshopt {

HWY_EXPORT(sum_up_planes);

void sum_up_planes(const Planes& planes, const Byte* modes, std::size_t channels, std::size_t count, const Byte* last,
                   std::size_t stride, Byte* to) {
  HWY_DYNAMIC_DISPATCH(sum_up_planes)(planes, modes, channels, count, last, stride, to);
}

}  // namespace foredraw::meshopt
#endif

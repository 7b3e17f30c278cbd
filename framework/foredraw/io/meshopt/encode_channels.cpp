// Elements to streams of the vertex codec.
//
// Nothing is estimated. A group's size follows from how many of its values are too large for a width, a plane's from
// its groups', and channels do not touch each other: so every mode of a channel is measured over the whole stream, and
// the shortest is taken.
#include <foredraw/io/meshopt/private/vertex_layout.h>

#include <bit>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "foredraw/io/meshopt/encode_channels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace foredraw::meshopt::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Planes = Byte[channel_bytes][most_in_block];
using Sizes = std::array<std::size_t, widths.size()>;  ///< of a group, at each width

constexpr std::size_t not_so = 1 << 20;  ///< more than any plane takes

/// From how many of a group's values need more than 0, 1, 2 and 4 bits.
HWY_INLINE Sizes sizes_from(std::size_t more_than_0, std::size_t more_than_2, std::size_t more_than_4) {
  return {more_than_0 == 0 ? 0 : not_so, 2 + more_than_0, 4 + more_than_2, 8 + more_than_4, group_size};
}

#if HWY_TARGET == HWY_SCALAR

/// The differences of each `width` bits.
std::uint32_t zigzag_difference(std::uint32_t is, std::uint32_t was, std::uint32_t width) {
  const std::uint32_t mask = (1u << width) - 1;
  std::uint32_t all = 0;
  for (std::uint32_t at = 0; at < 32; at += width) {
    const std::uint32_t difference = ((is >> at) - (was >> at)) & mask;
    const std::uint32_t below_zero = difference >> (width - 1) == 0 ? 0 : mask;
    all |= ((difference << 1 ^ below_zero) & mask) << at;
  }
  return all;
}

void make_planes(const std::uint32_t* words, std::size_t count, unsigned mode, Planes& planes) {
  for (std::size_t i = 0; i < rounded_up(count, group_size); ++i) {
    const std::uint32_t was = words[i], is = words[i + 1];
    const std::uint32_t difference =
        mode > 1 ? std::rotl(is ^ was, static_cast<int>(mode >> 4)) : zigzag_difference(is, was, 8 * (mode + 1));
    for (std::size_t p = 0; p < channel_bytes; ++p) planes[p][i] = static_cast<Byte>(difference >> (8 * p));
  }
}

Sizes sizes_of(const Byte* group) {
  const auto at_least = [&](Byte least) {
    return static_cast<std::size_t>(std::count_if(group, group + group_size, [=](Byte v) { return v >= least; }));
  };
  return sizes_from(at_least(1), at_least(3), at_least(15));
}

Byte* put_large(const Byte* group, Byte least, Byte* to) {
  return std::copy_if(group, group + group_size, to, [=](Byte v) { return v >= least; });
}

#else

using Sixteen = hn::FixedTag<Byte, 16>;
using Halves = hn::FixedTag<std::uint16_t, 8>;
using Words = hn::FixedTag<std::uint32_t, 4>;
using Longs = hn::FixedTag<std::uint64_t, 2>;
using Vector = hn::Vec<Words>;

template <class D>
HWY_INLINE Vector zigzag_difference(Vector is, Vector was) {
  const D d;
  const hn::RebindToSigned<D> with_sign;
  const auto difference = hn::Sub(hn::BitCast(d, is), hn::BitCast(d, was));
  const auto below_zero = hn::VecFromMask(with_sign, hn::Lt(hn::BitCast(with_sign, difference), hn::Zero(with_sign)));
  return hn::BitCast(Words(), hn::Xor(hn::Add(difference, difference), hn::BitCast(d, below_zero)));
}

HWY_INLINE Vector difference(unsigned mode, Vector is, Vector was) {
  if (mode == 0) return zigzag_difference<Sixteen>(is, was);
  if (mode == 1) return zigzag_difference<Halves>(is, was);
  const auto bits = hn::Xor(is, was);
  const int turn = static_cast<int>(mode >> 4);
  return hn::Or(hn::ShiftLeftSame(bits, turn), hn::ShiftRightSame(bits, (32 - turn) & 31));
}

HWY_INLINE void make_planes(const std::uint32_t* words, std::size_t count, unsigned mode, Planes& planes) {
  const Sixteen d;
  const Words w;
  const Longs l;
  alignas(16) static constexpr Byte by_place[16] = {0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15};
  const auto order = hn::Load(d, by_place);
  for (std::size_t i = 0; i < count; i += group_size) {
    const auto four = [&](std::size_t at) HWY_ATTR {
      const auto v = difference(mode, hn::LoadU(w, words + i + at + 1), hn::LoadU(w, words + i + at));
      return hn::BitCast(w, hn::TableLookupBytes(hn::BitCast(d, v), order));
    };
    const auto a = four(0), b = four(4), c = four(8), e = four(12);
    const auto low = hn::BitCast(l, hn::InterleaveLower(w, a, b)), high = hn::BitCast(l, hn::InterleaveUpper(w, a, b));
    const auto low_too = hn::BitCast(l, hn::InterleaveLower(w, c, e));
    const auto high_too = hn::BitCast(l, hn::InterleaveUpper(w, c, e));
    hn::Store(hn::BitCast(d, hn::InterleaveLower(l, low, low_too)), d, planes[0] + i);
    hn::Store(hn::BitCast(d, hn::InterleaveUpper(l, low, low_too)), d, planes[1] + i);
    hn::Store(hn::BitCast(d, hn::InterleaveLower(l, high, high_too)), d, planes[2] + i);
    hn::Store(hn::BitCast(d, hn::InterleaveUpper(l, high, high_too)), d, planes[3] + i);
  }
}

HWY_INLINE hn::Mask<Sixteen> is_at_least(hn::Vec<Sixteen> v, Byte least) {
  return hn::Eq(hn::Min(v, hn::Set(Sixteen(), least)), hn::Set(Sixteen(), least));
}

HWY_INLINE Sizes sizes_of(const Byte* group) {
  const Sixteen d;
  const auto v = hn::Load(d, group);
  const auto at_least = [&](Byte least) HWY_ATTR { return hn::CountTrue(d, is_at_least(v, least)); };
  return sizes_from(at_least(1), at_least(3), at_least(15));
}

/// The values of a group that are no less than this; up to 8 bytes behind them are overwritten.
HWY_INLINE Byte* put_large(const Byte* group, Byte least, Byte* to) {
  const Sixteen d;
  Byte mask[8];
  hn::StoreMaskBits(d, is_at_least(hn::Load(d, group), least), mask);
  const hn::FixedTag<Byte, 8> half;
  for (std::size_t h = 0; h < 2; ++h) {
    const auto some =
        hn::TableLookupBytes(hn::LoadU(half, group + 8 * h), hn::LoadU(half, byte_moves.compress[mask[h]].data()));
    hn::StoreU(some, half, to);
    to += std::popcount(mask[h]);
  }
  return to;
}

#endif

/// The bytes that a plane takes, and how.
struct PlaneCost {
  std::size_t bytes = 0;
  Control control = Control::zeros;
};

HWY_INLINE PlaneCost cost_of(const Byte* plane, std::size_t count) {
  std::size_t narrow = header_bytes(count), wide = narrow, empty = 0;
  for (std::size_t i = 0; i < count; i += group_size) {
    const Sizes sizes = sizes_of(plane + i);
    const std::size_t packed = std::min({sizes[1], sizes[2], sizes[3]});
    narrow += std::min(packed, sizes[0]);
    wide += std::min(packed, sizes[4]);
    empty += sizes[0] == 0 ? group_size : 0;
  }
  if (empty >= count) return {0, Control::zeros};
  if (std::min(narrow, wide) >= count) return {count, Control::bytes};
  return narrow < wide ? PlaneCost{narrow, Control::narrow} : PlaneCost{wide, Control::wide};
}

std::size_t cost_of_channel(const std::uint32_t* words, std::size_t count, unsigned mode) {
  alignas(64) Planes planes;
  make_planes(words, count, mode, planes);
  std::size_t bytes = 0;
  for (const auto& plane : planes) bytes += cost_of(plane, count).bytes;
  return bytes;
}

/// Values of 4 or 2 bits, the first one highest; of 1 bit, the first one lowest.
HWY_INLINE Byte* put_packed(const Byte* group, std::size_t width, Byte* to) {
  const std::uint64_t most = (std::uint64_t{1} << width) - 1;
  Byte least[group_size];
  for (std::size_t i = 0; i < group_size; ++i) least[i] = std::min(group[i], static_cast<Byte>(most));
  for (std::size_t h = 0; h < 2; ++h) {
    std::uint64_t bits;
    std::memcpy(&bits, least + 8 * h, 8);
    if (width == 1) {
      bits = bits * 0x0102040810204080u >> 56;
    } else {
      bits = (bits << width | bits >> 8) & 0x00ff00ff00ff00ffu;
      if (width == 2) bits = (bits << 4 | bits >> 16) & 0x000000ff000000ffu;
      if (width == 4) bits = (bits | bits >> 8) & 0x0000ffff0000ffffu;
      bits |= bits >> (width == 2 ? 24 : 16);
    }
    std::memcpy(to, &bits, width);
    to += width;
  }
  return to;
}

HWY_INLINE Byte* put_plane(const Byte* plane, std::size_t count, const GroupWidths& allowed, Byte* to) {
  Byte* header = to;
  std::memset(header, 0, header_bytes(count));
  to += header_bytes(count);
  std::size_t bits = 0;
  for (std::size_t i = 0; i < count; i += group_size) {
    const Sizes sizes = sizes_of(plane + i);
    for (std::size_t other = 0; other < allowed.size(); ++other) {  // of equal ones that of the group before
      if (sizes[allowed[other]] < sizes[allowed[bits]]) bits = other;
    }
    header[i / 64] = static_cast<Byte>(header[i / 64] | bits << (i / 8 % 8));
    const std::size_t width = widths[allowed[bits]];
    if (width == 8) {
      std::memcpy(to, plane + i, group_size);
      to += group_size;
    } else if (width != 0) {
      to = put_packed(plane + i, width, to);
      to = put_large(plane + i, static_cast<Byte>((1 << width) - 1), to);
    }
  }
  return to;
}

Byte* put_channel(const std::uint32_t* words, std::size_t count, unsigned mode, VertexVersion version, Byte* control,
                  Byte* to) {
  alignas(64) Planes planes;
  make_planes(words, count, mode, planes);
  for (std::size_t p = 0; p < channel_bytes; ++p) {
    if (version == VertexVersion::v0) {
      to = put_plane(planes[p], count, widths_of_version_0, to);
      continue;
    }
    const PlaneCost cost = cost_of(planes[p], count);
    *control = static_cast<Byte>(*control | static_cast<unsigned>(cost.control) << (2 * p));
    if (cost.control == Control::bytes) {
      std::memcpy(to, planes[p], count);
      to += count;
    } else if (cost.control != Control::zeros) {
      to = put_plane(planes[p], count, widths_of_control[static_cast<std::size_t>(cost.control)], to);
    }
  }
  return to;
}

}  // namespace foredraw::meshopt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace foredraw::meshopt {

HWY_EXPORT(cost_of_channel);
HWY_EXPORT(put_channel);

std::size_t cost_of_channel(const std::uint32_t* words, std::size_t count, unsigned mode) {
  return HWY_DYNAMIC_DISPATCH(cost_of_channel)(words, count, mode);
}

Byte* put_channel(const std::uint32_t* words, std::size_t count, unsigned mode, VertexVersion version, Byte* control,
                  Byte* to) {
  return HWY_DYNAMIC_DISPATCH(put_channel)(words, count, mode, version, control, to);
}

}  // namespace foredraw::meshopt
#endif

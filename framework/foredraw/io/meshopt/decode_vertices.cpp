// Streams of the vertex codec to elements.
//
// How long a group is follows from its bits and from how many of them say that a whole byte follows. Everything else
// waits for that, so it is worked out by itself, in plain registers; the values are taken apart while it goes on.
#include <foredraw/io/meshopt/private/vertex_layout.h>

#include <bit>
#include <cstring>

#define HWY_WANT_AVX3_DL  // whose registers can be expanded by a mask
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "foredraw/io/meshopt/decode_vertices.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace foredraw::meshopt::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t channels_at_once = 4;
using Planes = Byte[channels_at_once * channel_bytes][most_in_block];
using Words = std::uint32_t[channels_at_once][most_in_block];

/// How a group of a width is taken apart. A width of 8 bits is one whose values are all left to the bytes that follow.
struct Group {
  alignas(16) std::array<Byte, 16> source{};  ///< for each value, which byte it is part of; 128: none
  alignas(16) std::array<Byte, 16> field{};   ///< its bits there; all of them set say that a byte follows
  alignas(16) std::array<Byte, 16> value{};   ///< of bits, wherever in a half byte
  alignas(16) std::array<Byte, 16> shift{};   ///< of the first 8 bytes
  alignas(16) std::array<Byte, 16> mask{};
  alignas(16) std::array<Byte, 16> full{};
  std::size_t bytes = 0;    ///< that are always there
  std::uint64_t lanes = 0;  ///< a bit for each value, where `folds` gather all of its bits
  std::array<int, 2> folds{};
  std::size_t more = 0;
};

constexpr std::array<Group, widths.size()> groups = [] {
  std::array<Group, widths.size()> made;
  for (std::size_t w = 0; w < widths.size(); ++w) {
    Group& group = made[w];
    const std::size_t width = widths[w];
    for (std::size_t i = 0; i < group_size; ++i) {
      const bool packed = width > 0 && width < 8;
      const std::size_t in_byte = packed ? 8 / width : 1;
      const std::size_t place = packed ? i % in_byte : 0;
      const std::size_t shift = width == 1 ? place : packed ? 8 - width * (place + 1) : 0;
      group.source[i] = packed ? static_cast<Byte>(i / in_byte) : Byte{128};
      group.field[i] = width == 0 ? Byte{255} : width == 8 ? Byte{0} : static_cast<Byte>(((1 << width) - 1) << shift);
      group.value[i] = static_cast<Byte>(width == 1 ? 0 : width == 2 ? (i < 4 ? i : i / 4) : i);
      group.shift[i] = packed ? static_cast<Byte>(8 * group.source[i] + shift) : Byte{0};
      group.mask[i] = packed ? static_cast<Byte>((1 << width) - 1) : Byte{0};
      group.full[i] = width == 0 ? Byte{255} : group.mask[i];
      if (packed) group.lanes |= std::uint64_t{1} << (i * width);
    }
    group.bytes = 2 * width;
    group.folds = {width == 2 || width == 4 ? 1 : 0, width == 4 ? 2 : 0};
  }
  return made;
}();

/// Bytes of the group that begins here; 8 of them can be read.
HWY_INLINE std::size_t bytes_of(const Group& group, const Byte* from) {
  std::uint64_t bits;
  std::memcpy(&bits, from, 8);
  bits &= bits >> group.folds[0];
  bits &= bits >> group.folds[1];
  return group.bytes + static_cast<std::size_t>(std::popcount(bits & group.lanes));
}

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

HWY_INLINE void take_apart(const Group& group, const Byte* from, Byte* to) {
  const Byte* more = from + group.bytes % 16;
  for (std::size_t i = 0; i < group_size; ++i) {
    const unsigned bits = group.source[i] == 128 ? 0u : static_cast<unsigned>(from[group.source[i]] & group.field[i]);
    to[i] = bits == group.field[i] ? *more++ : group.value[(bits | bits >> 4) & 15];
  }
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

using Sixteen = hn::FixedTag<Byte, 16>;

#if HWY_TARGET == HWY_AVX3_DL

HWY_INLINE void take_apart(const Group& group, const Byte* from, Byte* to) {
  const Sixteen d;
  const auto mask = hn::Load(d, group.mask.data());
  std::uint64_t packed;
  std::memcpy(&packed, from, 8);
  const auto both = hn::Set(hn::FixedTag<std::uint64_t, 2>(), packed);
  const auto values =
      hn::And(hn::Vec<Sixteen>{_mm_multishift_epi64_epi8(hn::Load(d, group.shift.data()).raw, both.raw)}, mask);
  const auto is_byte = hn::Eq(values, hn::Load(d, group.full.data()));
  const auto bytes = hn::LoadU(d, from + group.bytes % 16);
  hn::StoreU(hn::Vec<Sixteen>{_mm_mask_expand_epi8(values.raw, is_byte.raw, bytes.raw)}, d, to);
}

#else

HWY_INLINE std::size_t mask_of(hn::Mask<Sixteen> mask) {
  Byte bytes[8];
  hn::StoreMaskBits(Sixteen(), mask, bytes);
  return bytes[0] | std::size_t{bytes[1]} << 8;
}

HWY_INLINE void take_apart(const Group& group, const Byte* from, Byte* to) {
  const Sixteen d;
  const auto field = hn::Load(d, group.field.data());
  const auto bits = hn::And(hn::TableLookupBytesOr0(hn::LoadU(d, from), hn::Load(d, group.source.data())), field);
  const auto is_byte = hn::Eq(bits, field);
  const auto half = hn::And(hn::Or(bits, hn::ShiftRight<4>(bits)), hn::Set(d, 15));
  const auto values = hn::TableLookupBytes(hn::Load(d, group.value.data()), half);
  const std::size_t mask = mask_of(is_byte);
  const std::size_t low = mask & 255, high = mask >> 8;
  std::uint64_t moves[2];
  std::memcpy(&moves[0], byte_moves.expand[low].data(), 8);
  std::memcpy(&moves[1], byte_moves.expand[high].data(), 8);
  moves[1] += 0x0101010101010101u * static_cast<std::uint64_t>(std::popcount(low));
  const auto place = hn::BitCast(d, hn::LoadU(hn::FixedTag<std::uint64_t, 2>(), moves));
  const auto bytes = hn::TableLookupBytesOr0(hn::LoadU(d, from + group.bytes % 16), place);
  hn::Store(hn::IfThenElse(is_byte, bytes, values), d, to);
}

#endif

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
  const hn::FixedTag<std::uint32_t, 2> half;
  std::size_t i = 0;
  const auto put = [&](std::size_t at, hn::Vec<hn::FixedTag<std::uint64_t, 2>> row) HWY_ATTR {
    auto* target = reinterpret_cast<std::uint32_t*>(to + at * stride);
    const auto four = hn::BitCast(d, row);
    if constexpr (channels == 4) hn::StoreU(four, d, target);
    if constexpr (channels == 2 || channels == 3) hn::StoreU(hn::LowerHalf(half, four), half, target);
    if constexpr (channels == 3) {
      const std::uint32_t third = hn::ExtractLane(four, 2);
      std::memcpy(target + 2, &third, 4);
    }
  };
  if constexpr (channels > 1) {
    for (; i + 4 <= count; i += 4) {
      const auto channel = [&](std::size_t c)
                               HWY_ATTR { return c < channels ? hn::Load(d, words[c] + i) : hn::Zero(d); };
      const auto a = channel(0), b = channel(1), c = channel(2), e = channel(3);
      const auto low = hn::BitCast(pairs, hn::InterleaveLower(d, a, b)),
                 high = hn::BitCast(pairs, hn::InterleaveUpper(d, a, b));
      const auto low_too = hn::BitCast(pairs, hn::InterleaveLower(d, c, e)),
                 high_too = hn::BitCast(pairs, hn::InterleaveUpper(d, c, e));
      put(i, hn::InterleaveLower(pairs, low, low_too));
      put(i + 1, hn::InterleaveUpper(pairs, low, low_too));
      put(i + 2, hn::InterleaveLower(pairs, high, high_too));
      put(i + 3, hn::InterleaveUpper(pairs, high, high_too));
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

/// The differences at one place of a block's elements; null where the stream ends.
HWY_INLINE const Byte* read_plane(const Byte* from, const Byte* end, const GroupWidths& width, std::size_t count,
                                  Byte* plane) {
  const Byte* header = from;
  if (static_cast<std::size_t>(end - from) < header_bytes(count)) return nullptr;
  from += header_bytes(count);
  std::size_t i = 0;
  const auto read = [&](unsigned bits) HWY_ATTR {
    const Group& group = groups[width[bits & 3]];
    const Byte* next = from + bytes_of(group, from);
    take_apart(group, from, plane + i);
    from = next;
    i += group_size;
  };
  while (i + 4 * group_size <= count && static_cast<std::size_t>(end - from) >= 4 * most_group_bytes) {
    const unsigned four = header[i / (4 * group_size)];
    if (four == 0 && width[0] == 0) {
      std::memset(plane + i, 0, 4 * group_size);
      i += 4 * group_size;
    } else if (four == 255 && width[3] == 4) {
      std::memcpy(plane + i, from, 4 * group_size);
      i += 4 * group_size;
      from += 4 * group_size;
    } else {
      read(four);
      read(four >> 2);
      read(four >> 4);
      read(four >> 6);
    }
  }
  while (i < count) {
    if (static_cast<std::size_t>(end - from) < most_group_bytes) return nullptr;
    read(header[i / (4 * group_size)] >> (i / 8 % 8));
  }
  return from;
}

/// One block; null where the stream ends. `last`: the element before. `modes`: of all channels.
const Byte* read_block(const Byte* from, const Byte* end, VertexVersion version, const Byte* modes, std::size_t stride,
                       std::size_t count, const Byte* last, Byte* to) {
  alignas(64) Planes planes;
  alignas(64) Words words;
  const std::size_t channels = stride / channel_bytes;
  const Byte* controls = from;
  if (version == VertexVersion::v1) {
    if (static_cast<std::size_t>(end - from) < channels) return nullptr;
    from += channels;
  }
  const std::size_t padded = rounded_up(count, group_size);
  for (std::size_t first = 0; first < channels; first += channels_at_once) {
    const std::size_t some = std::min(channels_at_once, channels - first);
    for (std::size_t p = 0; p < some * channel_bytes; ++p) {
      if (version == VertexVersion::v0) {
        from = read_plane(from, end, widths_of_version_0, count, planes[p]);
        if (from == nullptr) return nullptr;
        continue;
      }
      const unsigned control = controls[first + p / 4] >> (2 * (p % 4)) & 3;
      if (control < 2) {
        from = read_plane(from, end, widths_of_control[control], count, planes[p]);
        if (from == nullptr) return nullptr;
      } else if (control == 2) {
        std::memset(planes[p], 0, padded);
      } else {
        if (static_cast<std::size_t>(end - from) < padded) return nullptr;
        std::memcpy(planes[p], from, padded);
        from += count;
      }
    }
    for (std::size_t c = 0; c < some; ++c) {
      std::uint32_t before;
      std::memcpy(&before, last + (first + c) * channel_bytes, channel_bytes);
      sum_up(planes[c * channel_bytes], modes[first + c], count, before, words[c]);
    }
    Byte* at = to + first * channel_bytes;
    switch (some) {
      case 1: put_elements<1>(words, count, stride, at); break;
      case 2: put_elements<2>(words, count, stride, at); break;
      case 3: put_elements<3>(words, count, stride, at); break;
      default: put_elements<4>(words, count, stride, at);
    }
  }
  return from;
}

}  // namespace foredraw::meshopt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace foredraw::meshopt {

HWY_EXPORT(read_block);

std::optional<VertexVersion> vertex_version(std::span<const std::byte> stream) {
  if (stream.empty()) return std::nullopt;
  const auto first = std::to_integer<Byte>(stream[0]);
  if (first == codec_byte) return VertexVersion::v0;
  return first == codec_byte + 1 ? std::optional(VertexVersion::v1) : std::nullopt;
}

std::size_t least_vertex_bytes(std::size_t count, std::size_t stride, VertexVersion version) {
  const std::size_t block = elements_in_block(stride);
  const auto least = [&](std::size_t elements) {
    return version == VertexVersion::v0 ? stride * header_bytes(elements) : stride / channel_bytes;
  };
  const std::size_t rest = count % block;
  return 1 + count / block * least(block) + (rest == 0 ? 0 : least(rest)) + padded_tail_bytes(stride, version);
}

bool decode_vertices(std::span<const std::byte> stream, std::size_t stride, std::span<std::byte> elements) {
  const auto version = vertex_version(stream);
  if (!version || stream.size() < 1 + padded_tail_bytes(stride, *version)) return false;
  const auto* begin = reinterpret_cast<const Byte*>(stream.data());
  const Byte* end = begin + stream.size();
  const Byte* last = end - tail_bytes(stride, *version);
  static constexpr std::array<Byte, 64> modes_of_version_0{};
  const Byte* modes = *version == VertexVersion::v0 ? modes_of_version_0.data() : last + stride;
  for (std::size_t c = 0; c < stride / channel_bytes; ++c) {
    if ((modes[c] & 15) > 2 || ((modes[c] & 15) < 2 && modes[c] > 1)) return false;
  }
  const auto read = HWY_DYNAMIC_DISPATCH(read_block);
  const std::size_t count = elements.size() / stride;
  auto* to = reinterpret_cast<Byte*>(elements.data());
  const Byte* from = begin + 1;
  for (std::size_t first = 0; first < count; first += elements_in_block(stride)) {
    const std::size_t some = std::min(elements_in_block(stride), count - first);
    from = read(from, end, *version, modes, stride, some, last, to);
    if (from == nullptr) return false;
    to += some * stride;
    last = to - stride;
  }
  return static_cast<std::size_t>(end - from) == padded_tail_bytes(stride, *version);
}

}  // namespace foredraw::meshopt
#endif

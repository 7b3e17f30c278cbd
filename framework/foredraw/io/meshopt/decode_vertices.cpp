// Streams of the vertex codec to elements.
//
// How long a group is follows from its bits and from how many of them say that a whole byte follows. Everything else
// waits for that, so it is worked out by itself, in plain registers; the values are taken apart while it goes on.
#include <foredraw/io/meshopt/private/group_forms.h>
#include <foredraw/io/meshopt/private/planes.h>

#include <bit>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "foredraw/io/meshopt/decode_vertices.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace foredraw::meshopt::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Behind the group that begins here; 8 of its bytes can be read.
HWY_INLINE const Byte* past(const GroupForm& group, const Byte* from) {
  const Byte* packed = from + group.bytes;  // known before the count is
  std::uint64_t bits;
  std::memcpy(&bits, from, 8);
  bits &= bits >> group.folds[0];
  bits &= bits >> group.folds[1];
  return packed + std::popcount(bits & group.lanes);
}

#if HWY_TARGET == HWY_SCALAR

HWY_INLINE void take_apart(const GroupForm& group, const Byte* from, Byte* to) {
  const Byte* more = from + group.bytes % 16;
  for (std::size_t i = 0; i < group_size; ++i) {
    const unsigned bits = group.source[i] == 128 ? 0u : static_cast<unsigned>(from[group.source[i]] & group.field[i]);
    to[i] = bits == group.field[i] ? *more++ : group.value[(bits | bits >> 4) & 15];
  }
}

#else

using Sixteen = hn::FixedTag<Byte, 16>;

HWY_INLINE std::size_t mask_of(hn::Mask<Sixteen> mask) {
  Byte bytes[8];
  hn::StoreMaskBits(Sixteen(), mask, bytes);
  return bytes[0] | std::size_t{bytes[1]} << 8;
}

HWY_INLINE void take_apart(const GroupForm& group, const Byte* from, Byte* to) {
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

/// The differences at one place of a block's elements; null where the stream ends.
HWY_INLINE const Byte* read_plane(const Byte* from, const Byte* end, const GroupWidths& width, std::size_t count,
                                  Byte* plane) {
  const Byte* header = from;
  if (static_cast<std::size_t>(end - from) < header_bytes(count)) return nullptr;
  from += header_bytes(count);
  std::size_t i = 0;
  const auto read = [&](unsigned bits) HWY_ATTR {
    const GroupForm& group = group_forms[width[bits & 3]];
    const Byte* next = past(group, from);
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
    sum_up_planes(planes, modes + first, some, count, last + first * channel_bytes, stride, to + first * channel_bytes);
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

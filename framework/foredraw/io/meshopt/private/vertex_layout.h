#pragma once
// How a stream of the vertex codec is laid out. Elements are taken in blocks; the bytes at one place of a block's
// elements are a plane; a plane is stored in groups of 16. What is stored are differences from one element to the next.

#include <foredraw/io/meshopt/vertex_codec.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace foredraw::meshopt {

using Byte = std::uint8_t;

constexpr std::size_t group_size = 16;
constexpr std::size_t most_in_block = 256;
constexpr std::size_t channel_bytes = 4;
constexpr std::size_t most_group_bytes = 24;  ///< of a group whose values are all too large for its 4 bits
constexpr Byte codec_byte = 0xa0;             ///< of a stream, plus its version

constexpr std::size_t rounded_up(std::size_t value, std::size_t to) { return (value + to - 1) / to * to; }

constexpr std::size_t elements_in_block(std::size_t stride) {
  return std::min(most_in_block, 8192 / stride / group_size * group_size);
}

/// Two bits for each group.
constexpr std::size_t header_bytes(std::size_t count) { return rounded_up(rounded_up(count, group_size), 64) / 64; }

/// The first element, then the modes of its channels.
constexpr std::size_t tail_bytes(std::size_t stride, VertexVersion version) {
  return version == VertexVersion::v0 ? stride : stride + stride / channel_bytes;
}

/// With the zeros before it. So many bytes can be read from wherever a group begins.
constexpr std::size_t padded_tail_bytes(std::size_t stride, VertexVersion version) {
  return std::max<std::size_t>(tail_bytes(stride, version), version == VertexVersion::v0 ? 32 : 24);
}

/// How a plane is stored, in 2 bits of the block's header; version 0 has no such header.
enum class Control : Byte {
  narrow,  ///< groups of 0, 1, 2 or 4 bits
  wide,    ///< groups of 1, 2, 4 or 8 bits
  zeros,   ///< all differences are 0, and nothing is stored
  bytes,   ///< one byte for each element
};

/// Bits of a value in a group, by control and by the group's 2 bits in the plane's header: places in `widths`.
constexpr std::array<std::size_t, 5> widths{0, 1, 2, 4, 8};
using GroupWidths = std::array<std::size_t, 4>;
constexpr GroupWidths widths_of_version_0{0, 2, 3, 4};
constexpr std::array<GroupWidths, 2> widths_of_control{{{0, 1, 2, 3}, {1, 2, 3, 4}}};

/// How the differences of a channel, 4 bytes of an element, are made: the low half of a byte of the tail.
enum class Mode : Byte {
  bytes,   ///< of each byte, zigzag
  halves,  ///< of both 16-bit words, zigzag
  bits,    ///< of the 32 bits, exclusive or, turned left by the high half of the tail's byte
};

/// What tells the places of a group's bytes apart: [mask] has the places of the mask's set bits...
struct ByteMoves {
  std::array<std::array<Byte, 8>, 256> expand{};    ///< byte i: which of the packed ones, or 128
  std::array<std::array<Byte, 8>, 256> compress{};  ///< byte i: the place of the i-th set bit
};

inline constexpr ByteMoves byte_moves = [] {
  ByteMoves moves;
  for (std::size_t mask = 0; mask < 256; ++mask) {
    Byte count = 0;
    for (Byte i = 0; i < 8; ++i) {
      const bool set = (mask >> i & 1) != 0;
      moves.expand[mask][i] = set ? count : Byte{128};
      if (set) moves.compress[mask][count++] = i;
    }
  }
  return moves;
}();

}  // namespace foredraw::meshopt

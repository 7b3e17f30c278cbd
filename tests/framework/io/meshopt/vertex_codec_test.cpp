// The vertex codec: streams that another encoder made, what goes in and comes out, how short it is, and damage.
#include <foredraw/io/meshopt/vertex_codec.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>
#include <string_view>

#include "support/vector_widths.h"

namespace foredraw::meshopt::vertex_codec_test {
namespace {

using Bytes = std::vector<std::byte>;
constexpr VertexVersion both[] = {VertexVersion::v0, VertexVersion::v1};

template <class T>
Bytes bytes_of(const std::vector<T>& values) {
  const auto bytes = std::as_bytes(std::span(values));
  return {bytes.begin(), bytes.end()};
}

Bytes from_hex(std::string_view digits) {
  Bytes bytes;
  for (std::size_t i = 0; i < digits.size(); i += 2) {
    bytes.push_back(static_cast<std::byte>(std::stoi(std::string(digits.substr(i, 2)), nullptr, 16)));
  }
  return bytes;
}

// Of the data below by `meshopt_encodeVertexBufferLevel`, level 3, of meshoptimizer 1.2.
constexpr std::string_view halves_v0 =
    "a01f000e2a46627e9ab6d2eef5d9bda185694d311506223e5a7692aecae6fde1c5a9ffdf00008d7155391d1a36290802222a022222422242"
    "424424444444000000001f0057575757575757575757575757575757575757575757575757575757575757ffff0000575757575757575715"
    "1755755d03030355d55d550303d55d000003031f00aeaeaeaeb7aeaeaeaeb7aeaeaeaeb7aeaeaeaeb7aeaeaeaeb7aeaeaeaeb7aeffff0000"
    "aeaeaeb7aeaeaeae2a088a8f88a8f88a8f21212188a8f88a8f88a8f82121218a8f88a8000000002100000000000000000000000000000000"
    "00000000000000000000e80360ea00000000";
constexpr std::string_view halves_v1 =
    "a177a7000e2a46627e9ab6d2ee0a26425e7a96b2ceea06223e5a7692aecae6021e3a56728eaac6e2fe1a36250000055556aaaaff03030303"
    "333333440000000000575757575757575757575757575757575757575757575757575757575757575757575757575757152aaaaaaaaaaaaa"
    "aaaaaa000000aeaeaeaeb7aeaeaeaeb7aeaeaeaeb7aeaeaeaeb7aeaeaeaeb7aeaeaeaeb7aeaeaeaeb7aeaeaeae2a088a8f88a8f88a8f2121"
    "2188a8f88a8f88a8f82121218a8f88a800000000210000000000000000000000000000e80360ea000000000100";
constexpr std::string_view turned_bits =
    "a1692a0888888888888888888888888888888888888888000000002a01313131313131313131313131313131313131310000000000000000"
    "0000000000000000000000000000000000803f42";
constexpr std::string_view two_blocks =
    "a12d000000000200020300010403000306030005080300070a0300090c03000b0e03000d1003000f12030011140300131603001518030017"
    "1a0300191c03001b1e03001d200002060a0e12161a1e22262a2e32363a3e42464a4e52565a5e62666a6e72767a7e82868a8e92969a9ea2a6"
    "aaaeb2b6babec2c6caced2d6dadee2e6eaeef2f6fafefdf9f5f1ede9e5e1ddd9d5d1cdc9c5c1bdb9b5b1ada9a5a19d9995918d8985817d79"
    "75716d6965615d5955514d4945413d3935312d2925211d1915110d09050102060a0e12161a1e22262a2e32363a3e42464a4e52565a5e6266"
    "6a6e72767a7e82868a8e92969a9ea2a6aaaeb2b6babec2c6caced2d6dadee2e6eaeef2f6fafefdf9f5f1ede9e5e1ddd9d5d1cdc9c5c1bdb9"
    "b5b1ada9a5a19d9995918d8985817d7975716d6965615d5955514d4945413d3935312d2925211d1915110d090500000400400002ad000300"
    "1f2203002124030023260102060a0e12161a1e22262a2e32363a3e42464a4e52565a5e62666a6e72767a7e82868a8e92969a9ea2a6aa0000"
    "0000000000000000000000000000000000ff00070000";

struct Sample {
  std::size_t stride;
  Bytes elements;
};

Sample sample_of_halves() {
  std::vector<std::uint16_t> values;
  for (std::uint32_t i = 0; i < 40; ++i) {
    for (const std::uint32_t value : {1000 + i * i * 7, 60000 - i * 300, i % 5 * 1111, 0u}) {
      values.push_back(static_cast<std::uint16_t>(value));
    }
  }
  return {8, bytes_of(values)};
}

Sample sample_of_bits() {
  std::vector<std::uint32_t> values;
  for (std::uint32_t i = 0; i < 40; ++i) values.push_back(0x3f800000u ^ (i % 2 << 31) ^ ((i * 5 % 4) << 20));
  return {4, bytes_of(values)};
}

Sample sample_of_two_blocks() {
  std::vector<std::uint8_t> values;
  for (std::uint32_t i = 0; i < 300; ++i) {
    for (const std::uint32_t value : {i % 16 == 0 ? 255 : i / 16, i * i, 7u, i < 150 ? 0u : 1u}) {
      values.push_back(static_cast<std::uint8_t>(value));
    }
  }
  return {4, bytes_of(values)};
}

void expect_decodes(std::string_view digits, const Sample& sample, VertexVersion version) {
  const Bytes stream = from_hex(digits);
  EXPECT_EQ(vertex_version(stream), version);
  testing::at_every_width([&] {
    Bytes elements(sample.elements.size());
    EXPECT_TRUE(decode_vertices(stream, sample.stride, elements));
    EXPECT_EQ(elements, sample.elements);
  });
  EXPECT_LE(encode_vertices(sample.elements, sample.stride, version).size(), stream.size());
}

TEST(VertexCodec, reads_what_another_encoder_made) {
  expect_decodes(halves_v0, sample_of_halves(), VertexVersion::v0);
  expect_decodes(halves_v1, sample_of_halves(), VertexVersion::v1);
  expect_decodes(turned_bits, sample_of_bits(), VertexVersion::v1);
  expect_decodes(two_blocks, sample_of_two_blocks(), VertexVersion::v1);
}

/// Bytes, words and floats that change by little, by much, or not at all.
Bytes some_elements(std::size_t count, std::size_t stride, std::uint32_t seed) {
  std::mt19937 random(seed);
  Bytes elements(count * stride);
  for (std::size_t word = 0; word < stride / 4; ++word) {
    const std::uint32_t kind = random() % 5, range = 1u << random() % 12;
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t noise = random() % range;
      std::uint32_t value = 0x01020304;
      if (kind == 0) value = noise * 0x01010101u;
      if (kind == 1) value = (static_cast<std::uint32_t>(i) * 40 + noise) << 16 | (60000 - noise);
      if (kind == 2) value = std::bit_cast<std::uint32_t>(std::sin(0.01f * static_cast<float>(i + noise)));
      if (kind == 3) value = random();
      std::memcpy(&elements[i * stride + word * 4], &value, 4);
    }
  }
  return elements;
}

TEST(VertexCodec, what_goes_in_comes_out_at_every_stride_count_and_width) {
  for (std::size_t stride = 4; stride <= 256; stride += stride < 40 ? 4 : 36) {
    for (const std::size_t count : {0u, 1u, 15u, 16u, 17u, 31u, 33u, 63u, 64u, 65u, 255u, 256u, 257u, 700u}) {
      const Bytes elements = some_elements(count, stride, static_cast<std::uint32_t>(stride + count));
      for (const VertexVersion version : both) {
        const Bytes stream = encode_vertices(elements, stride, version);
        ASSERT_GE(stream.size(), least_vertex_bytes(count, stride, version)) << stride << ' ' << count;
        testing::at_every_width([&] {
          Bytes again(elements.size());
          ASSERT_TRUE(decode_vertices(stream, stride, again)) << stride << ' ' << count;
          ASSERT_EQ(again, elements) << stride << ' ' << count;
          ASSERT_EQ(encode_vertices(elements, stride, version), stream) << stride << ' ' << count;
        });
      }
    }
  }
}

TEST(VertexCodec, equal_elements_take_the_least_bytes) {
  for (const std::size_t stride : {4u, 8u, 12u, 20u, 32u, 36u, 64u, 128u, 132u, 256u}) {
    for (const std::size_t count : {1u, 16u, 17u, 64u, 65u, 256u, 257u, 1000u}) {
      for (const VertexVersion version : both) {
        const Bytes stream = encode_vertices(Bytes(count * stride, std::byte{9}), stride, version);
        EXPECT_EQ(stream.size(), least_vertex_bytes(count, stride, version)) << stride << ' ' << count;
      }
    }
  }
}

/// What a channel of up to 256 words takes in a mode, at its shortest: counted value by value.
std::size_t bytes_in_mode(const std::vector<std::uint32_t>& words, unsigned mode) {
  std::vector<std::uint32_t> differences;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::uint32_t is = words[i], was = words[i == 0 ? 0 : i - 1];
    const auto zigzag = [&](int width) {
      std::uint32_t all = 0;
      for (int at = 0; at < 32; at += width) {
        const std::uint32_t difference = ((is >> at) - (was >> at)) << (32 - width);
        const std::uint32_t turned = difference << 1 ^ (difference >> 31 == 0 ? 0u : ~0u << (32 - width));
        all |= turned >> (32 - width) << at;
      }
      return all;
    };
    differences.push_back(mode > 1 ? std::rotl(is ^ was, static_cast<int>(mode >> 4)) : zigzag(mode == 0 ? 8 : 16));
  }
  std::size_t bytes = 0;
  for (int plane = 0; plane < 32; plane += 8) {
    const std::size_t headers = (words.size() + 63) / 64;
    std::size_t narrow = headers, wide = headers;
    bool all_zero = true;
    for (std::size_t first = 0; first < words.size(); first += 16) {
      std::size_t sizes[] = {2, 4, 8};
      bool zero = true;
      for (std::size_t i = first; i < std::min(first + 16, words.size()); ++i) {
        const std::uint32_t value = differences[i] >> plane & 255;
        zero = zero && value == 0;
        for (int w = 0; w < 3; ++w) sizes[w] += value >= (1u << (1u << w)) - 1 ? 1u : 0u;
      }
      const std::size_t least = std::min({sizes[0], sizes[1], sizes[2]});
      narrow += zero ? 0 : least;
      wide += std::min<std::size_t>(least, 16);
      all_zero = all_zero && zero;
    }
    bytes += all_zero ? 0 : std::min({narrow, wide, words.size()});
  }
  return bytes;
}

RC_GTEST_PROP(VertexCodec, no_mode_takes_fewer_bytes, (std::uint32_t seed)) {
  const std::size_t count = 1 + seed % 256;
  const Bytes elements = some_elements(count, 4, seed);
  std::vector<std::uint32_t> words(count);
  std::memcpy(words.data(), elements.data(), elements.size());
  std::size_t least = 4 * count;
  for (unsigned mode = 0; mode < 2; ++mode) least = std::min(least, bytes_in_mode(words, mode));
  for (unsigned turn = 0; turn < 16; ++turn) least = std::min(least, bytes_in_mode(words, 2 + 16 * turn));
  RC_ASSERT(encode_vertices(elements, 4, VertexVersion::v1).size() == 1 + 1 + least + 24);
}

TEST(VertexCodec, modes_that_there_are_not_are_refused) {
  const Sample sample = sample_of_halves();
  const Bytes stream = from_hex(halves_v1);
  for (unsigned mode = 0; mode < 256; ++mode) {
    Bytes other = stream;
    other.back() = static_cast<std::byte>(mode);
    Bytes elements(sample.elements.size());
    EXPECT_EQ(decode_vertices(other, sample.stride, elements), mode < 2 || (mode & 15) == 2) << mode;
  }
  for (const int first : {0x00, 0xa2, 0xaf, 0xb0, 0xe1}) {
    Bytes other = stream;
    other[0] = static_cast<std::byte>(first);
    Bytes elements(sample.elements.size());
    EXPECT_FALSE(decode_vertices(other, sample.stride, elements)) << first;
    EXPECT_FALSE(vertex_version(other)) << first;
  }
  EXPECT_FALSE(vertex_version({}));
}

/// Whatever a stream says, nothing beyond the elements is written. What it may read, a build with AddressSanitizer
/// sees.
void expect_bounded(const Bytes& stream, std::size_t stride, std::size_t bytes, bool may_be_right) {
  Bytes room(bytes + 64, std::byte{0x5a});
  const bool right = decode_vertices(Bytes(stream), stride, std::span(room).subspan(32, bytes));
  ASSERT_TRUE(may_be_right || !right);
  const auto untouched = [](std::byte b) { return b == std::byte{0x5a}; };
  ASSERT_TRUE(std::all_of(room.begin(), room.begin() + 32, untouched));
  ASSERT_TRUE(std::all_of(room.end() - 32, room.end(), untouched));
}

TEST(VertexCodec, damaged_streams_end_well) {
  std::mt19937 random(7);
  for (const std::size_t stride : {4u, 12u, 16u, 20u, 64u, 256u}) {
    for (const std::size_t count : {5u, 40u, 300u}) {
      const Bytes elements = some_elements(count, stride, random());
      for (const VertexVersion version : both) {
        const Bytes stream = encode_vertices(elements, stride, version);
        testing::at_every_width([&] {
          for (std::size_t size = 0; size < stream.size(); size += 1 + size / 16) {
            expect_bounded({stream.begin(), stream.begin() + static_cast<std::ptrdiff_t>(size)}, stride,
                           elements.size(), false);
          }
          for (const std::size_t other : {count - 1, count + 1, count + 16, 2 * count}) {
            expect_bounded(stream, stride, other * stride, true);
          }
          for (int i = 0; i < 60; ++i) {
            Bytes changed = stream;
            for (int flips = 0; flips < 1 + i % 4; ++flips) {
              changed[random() % changed.size()] = static_cast<std::byte>(random());
            }
            expect_bounded(changed, stride, elements.size(), true);
          }
        });
      }
    }
  }
}

}  // namespace
}  // namespace foredraw::meshopt::vertex_codec_test

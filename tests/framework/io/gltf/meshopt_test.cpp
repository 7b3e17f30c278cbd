// The codecs themselves: bounds that follow from the bitstreams, and filters beside those of the library.
#include <foredraw/io/gltf/codecs/private/meshopt.h>

#include <gtest/gtest.h>
#include <meshoptimizer.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace foredraw::gltf::meshopt_test {
namespace {

using Bytes = std::vector<std::byte>;
using Mode = Coding::Mode;
using Filter = Coding::Filter;

TEST(Meshopt, equal_vertices_take_the_least_bytes_and_no_stream_takes_fewer) {
  for (const std::size_t stride : {4u, 8u, 12u, 20u, 32u, 36u, 64u, 128u, 132u, 256u}) {
    for (const std::size_t count : {1u, 15u, 16u, 17u, 31u, 33u, 64u, 65u, 255u, 256u, 257u, 1000u}) {
      const Bytes equal(count * stride);
      const Coding like{Mode::attributes, Filter::none, count, stride};
      const auto stream = compressed(equal, stride, like, {});
      ASSERT_TRUE(stream);
      EXPECT_EQ(stream->bytes.size(), least_stream_bytes(like)) << stride << ' ' << count;
    }
  }
}

TEST(Meshopt, a_fan_of_new_corners_takes_the_least_bytes_of_triangles) {
  std::vector<std::uint32_t> strip;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    if (i % 2 == 0)
      strip.insert(strip.end(), {i, i + 1, i + 2});
    else
      strip.insert(strip.end(), {i + 1, i, i + 2});
  }
  const Bytes bytes(std::as_bytes(std::span(strip)).begin(), std::as_bytes(std::span(strip)).end());
  const auto triangles = compressed(bytes, 4, {Mode::triangles, Filter::none, 0, 0}, {});
  ASSERT_TRUE(triangles);
  EXPECT_GE(triangles->bytes.size(), least_stream_bytes(triangles->coding));
  EXPECT_LT(triangles->bytes.size(), least_stream_bytes(triangles->coding) + 32);
  const auto indices = compressed(bytes, 4, {Mode::indices, Filter::none, 0, 0}, {});
  ASSERT_TRUE(indices);
  EXPECT_EQ(indices->bytes.size(), least_stream_bytes(indices->coding));
}

RC_GTEST_PROP(Meshopt, whatever_is_compressed_comes_out_again, (std::vector<std::uint16_t> values, bool triangles)) {
  values.resize(values.size() / 6 * 6 + 6);
  const Bytes bytes(std::as_bytes(std::span(values)).begin(), std::as_bytes(std::span(values)).end());
  for (const Mode mode : {Mode::attributes, triangles ? Mode::triangles : Mode::indices}) {
    const auto stream = compressed(bytes, mode == Mode::attributes ? 4 : 2, {mode, Filter::none, 0, 0}, {});
    RC_ASSERT(stream.has_value());
    RC_ASSERT(stream->bytes.size() >= least_stream_bytes(stream->coding));
    const auto again = decompressed(stream->coding, stream->bytes);
    RC_ASSERT(again.has_value());
    if (mode != Mode::triangles) RC_ASSERT(*again == bytes);
    if (mode != Mode::triangles) continue;
    std::vector<std::uint16_t> turned(values.size());
    std::memcpy(turned.data(), again->data(), again->size());
    for (std::size_t i = 0; i < values.size(); i += 3) {
      const auto first = turned.begin() + static_cast<std::ptrdiff_t>(i);
      const auto wanted = values.begin() + static_cast<std::ptrdiff_t>(i);
      bool same = false;
      for (int turn = 0; turn < 3; ++turn) {
        same = same || std::equal(first, first + 3, wanted);
        std::rotate(first, first + 1, first + 3);
      }
      RC_ASSERT(same);
    }
  }
}

TEST(Meshopt, strides_that_a_mode_can_not_hold_are_not_compressed) {
  const Bytes bytes(60);
  for (const std::size_t stride : {1u, 2u, 3u, 6u, 7u, 0u}) {
    EXPECT_FALSE(compressed(bytes, stride, {Mode::attributes, Filter::none, 0, 0}, {})) << stride;
  }
  for (const std::size_t stride : {1u, 3u, 12u}) {
    EXPECT_FALSE(compressed(bytes, stride, {Mode::triangles, Filter::none, 0, 0}, {})) << stride;
  }
  EXPECT_FALSE(compressed({}, 4, {Mode::attributes, Filter::none, 0, 0}, {}));
}

/// Elements of every shape, as an encoder makes them.
std::vector<float> values(std::size_t count, bool unit) {
  std::vector<float> result;
  std::uint32_t state = 1;
  for (std::size_t i = 0; i < count; ++i) {
    float four[4];
    float length = 0;
    for (float& value : four) {
      state = state * 1664525u + 1013904223u;
      value = static_cast<float>(state >> 8) / 8388608.0f - 1;
    }
    const std::size_t parts = unit ? 4 : 3;
    for (std::size_t c = 0; c < parts; ++c) length += four[c] * four[c];
    for (std::size_t c = 0; c < parts; ++c) four[c] /= std::sqrt(length);
    result.insert(result.end(), four, four + 4);
  }
  return result;
}

template <class T>
int greatest_difference(const Bytes& a, const Bytes& b) {
  int most = 0;
  for (std::size_t i = 0; i < a.size(); i += sizeof(T)) {
    T x, y;
    std::memcpy(&x, a.data() + i, sizeof(T));
    std::memcpy(&y, b.data() + i, sizeof(T));
    most = std::max(most, std::abs(int{x} - int{y}));
  }
  return most;
}

TEST(Meshopt, filters_agree_with_the_library) {
  constexpr std::size_t count = 4096;
  Bytes rows(8 * count);
  meshopt_encodeFilterOct(rows.data(), count, 8, 12, values(count, false).data());
  Bytes ours = rows, theirs = rows;
  apply_filter({Mode::attributes, Filter::octahedral, count, 8}, ours);
  meshopt_decodeFilterOct(theirs.data(), count, 8);
  EXPECT_LE(greatest_difference<std::int16_t>(ours, theirs), 1);
  EXPECT_NE(ours, rows);

  rows.resize(4 * count);
  meshopt_encodeFilterOct(rows.data(), count, 4, 8, values(count, false).data());
  ours = theirs = rows;
  apply_filter({Mode::attributes, Filter::octahedral, count, 4}, ours);
  meshopt_decodeFilterOct(theirs.data(), count, 4);
  EXPECT_LE(greatest_difference<std::int8_t>(ours, theirs), 1);

  rows.resize(8 * count);
  meshopt_encodeFilterQuat(rows.data(), count, 8, 12, values(count, true).data());
  ours = theirs = rows;
  apply_filter({Mode::attributes, Filter::quaternion, count, 8}, ours);
  meshopt_decodeFilterQuat(theirs.data(), count, 8);
  EXPECT_LE(greatest_difference<std::int16_t>(ours, theirs), 1);

  rows.resize(16 * count);
  meshopt_encodeFilterExp(rows.data(), count, 16, 15, values(count, false).data());
  ours = theirs = rows;
  apply_filter({Mode::attributes, Filter::exponential, count, 16}, ours);
  meshopt_decodeFilterExp(theirs.data(), count, 16);
  EXPECT_EQ(ours, theirs);
}

/// What `meshopt_decodeFilterColor` of meshoptimizer 1.2 gives.
TEST(Meshopt, colors_are_those_of_another_decoder) {
  const auto filtered = [](auto values, std::size_t stride) {
    const auto bytes = std::as_writable_bytes(std::span(values));
    apply_filter({Mode::attributes, Filter::color, 4, stride}, bytes);
    return values;
  };
  const std::vector<std::uint8_t> eight{100, 20, 10, 255, 100, 236, 10, 160, 30, 251, 249, 127, 3, 1, 1, 7};
  const std::vector<std::uint8_t> eight_out{110, 110, 70, 255, 70, 110, 110, 64, 64, 46, 84, 255, 109, 146, 36, 255};
  EXPECT_EQ(filtered(eight, 4), eight_out);
  const std::vector<std::uint16_t> sixteen{500,   65516, 30,  0x3ff,  500, 65516, 30, 0x300,
                                           40000, 100,   200, 0xffff, 4,   1,     0,  9};
  const std::vector<std::uint16_t> sixteen_out{28828, 33953, 31390, 65535, 28828, 33953, 31390, 32800,
                                               39900, 40200, 39700, 65535, 21845, 17476, 13107, 13107};
  EXPECT_EQ(filtered(sixteen, 8), sixteen_out);
}

RC_GTEST_PROP(Meshopt, filters_take_any_bytes, (std::vector<std::uint32_t> words)) {
  words.resize(words.size() / 2 * 2 + 2);
  Bytes bytes(std::as_bytes(std::span(words)).begin(), std::as_bytes(std::span(words)).end());
  for (const Filter filter : {Filter::octahedral, Filter::quaternion, Filter::exponential, Filter::color}) {
    Bytes some = bytes;
    apply_filter({Mode::attributes, filter, words.size() / 2, 8}, some);
    RC_ASSERT(some.size() == bytes.size());
  }
}

}  // namespace
}  // namespace foredraw::gltf::meshopt_test

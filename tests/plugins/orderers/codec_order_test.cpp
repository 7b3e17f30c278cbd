#include "plugins/orderers/codec_order/codec_order.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>

namespace foredraw::codec_order_test {
namespace {

using Indices = std::vector<std::uint32_t>;

/// A grid of so many squares along each side, two triangles each, row by row.
Indices grid(std::uint32_t side) {
  Indices indices;
  for (std::uint32_t y = 0; y < side; ++y) {
    for (std::uint32_t x = 0; x < side; ++x) {
      const std::uint32_t a = y * (side + 1) + x, b = a + 1, c = a + side + 1, d = c + 1;
      indices.insert(indices.end(), {a, b, c, c, b, d});
    }
  }
  return indices;
}

std::vector<std::uint32_t> all(std::size_t count) {
  std::vector<std::uint32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0u);
  return numbers;
}

RC_GTEST_PROP(CodecOrder, IsAPermutation, (std::vector<std::uint8_t> values)) {
  Indices indices(values.begin(), values.end());
  indices.resize(indices.size() / 3 * 3);
  auto order = codec_order(indices, 256);
  std::ranges::sort(order);
  RC_ASSERT(order == all(indices.size() / 3));
}

TEST(CodecOrder, TakesNothingAndTrianglesWithoutNeighbours) {
  EXPECT_TRUE(codec_order({}, 0).empty());
  EXPECT_EQ(codec_order(all(30), 30), all(10));
}

TEST(CodecOrder, WalksAlongAStrip) {
  Indices strip;
  for (std::uint32_t i = 0; i < 100; ++i) {
    if (i % 2 == 0) strip.insert(strip.end(), {i, i + 1, i + 2});
    if (i % 2 == 1) strip.insert(strip.end(), {i + 1, i, i + 2});
  }
  EXPECT_EQ(codec_order(strip, 102), all(100));
}

TEST(CodecOrder, NearlyEveryTriangleOfAGridSharesARememberedEdge) {
  const Indices indices = grid(100);
  const auto order = codec_order(indices, 101 * 101);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  std::size_t without = 0;
  for (const std::uint32_t t : order) {
    bool shares = false;
    const auto first = edges.end() - std::min<std::ptrdiff_t>(45, static_cast<std::ptrdiff_t>(edges.size()));
    for (std::size_t i = 0; i < 3; ++i) {
      const std::pair edge{indices[3 * t + (i + 1) % 3], indices[3 * t + i]};
      shares |= std::find(first, edges.end(), edge) != edges.end();
    }
    for (std::size_t i = 0; i < 3; ++i) edges.emplace_back(indices[3 * t + i], indices[3 * t + (i + 1) % 3]);
    without += !shares;
  }
  EXPECT_LT(without, order.size() / 50);
}

TEST(CodecOrder, AStarAndABookTakeNoLongerThanTheirSize) {
  constexpr std::uint32_t many = 200000;
  Indices star, book;
  for (std::uint32_t i = 0; i < many; ++i) {
    star.insert(star.end(), {0, i + 1, i + 2});
    book.insert(book.end(), {0, 1, i + 2});
  }
  EXPECT_EQ(codec_order(star, many + 2).size(), many);  // minutes, were it quadratic
  EXPECT_EQ(codec_order(book, many + 2).size(), many);
}

}  // namespace
}  // namespace foredraw::codec_order_test

#include <foredraw/analysis/vertex_rows.h>

#include <gtest/gtest.h>

namespace foredraw::vertex_rows_test {
namespace {

VertexStream stream_of(std::vector<std::uint8_t> values, std::uint8_t width) {
  const auto bytes = std::as_bytes(std::span(values));
  return {"A", {Component::uint8, width, false, width}, Shared<std::byte>({bytes.begin(), bytes.end()})};
}

std::vector<int> numbers(std::span<const std::byte> row) {
  std::vector<int> result;
  for (const std::byte byte : row) result.push_back(std::to_integer<int>(byte));
  return result;
}

TEST(VertexRows, BaseThenMorphTargetsInOneRow) {
  VertexStreams streams;
  streams.count = 2;
  streams.base = {stream_of({1, 2, 3, 4}, 2), stream_of({5, 6}, 1)};
  streams.morph_targets = {{stream_of({7, 8}, 1)}, {stream_of({9, 10}, 1)}};
  const VertexRows rows(streams);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(numbers(rows[0]), (std::vector<int>{1, 2, 5, 7, 9}));
  EXPECT_EQ(numbers(rows[1]), (std::vector<int>{3, 4, 6, 8, 10}));
}

TEST(VertexRows, VerticesWithoutStreamsAreEmptyRows) {
  VertexStreams streams;
  streams.count = 3;
  const VertexRows rows(streams);
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_TRUE(rows[2].empty());
}

TEST(VertexRows, NoVerticesNoRows) {
  VertexStreams streams;
  streams.base = {stream_of({}, 3)};
  EXPECT_EQ(VertexRows(streams).size(), 0u);
}

}  // namespace
}  // namespace foredraw::vertex_rows_test

#include <foredraw/scene/strided.h>

#include <gtest/gtest.h>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace foredraw::strided_test {
namespace {

TEST(Strided, ReadsAtAnyStrideAndAlignment) {
  std::vector<std::byte> bytes(1 + 3 * 7);
  for (std::uint32_t i = 0; i < 3; ++i) {
    const std::uint32_t value = 0x01020304u * (i + 1);
    std::memcpy(bytes.data() + 1 + 7 * i, &value, sizeof value);
  }
  const Strided<std::uint32_t> strided(bytes.data() + 1, 3, 7);
  ASSERT_EQ(strided.size(), 3u);
  EXPECT_EQ(strided[0], 0x01020304u);
  EXPECT_EQ(strided[2], 0x0306090cu);
}

TEST(Strided, ReadsOneAttributeOfManyFromTypesOfTheEngine) {
  struct Vertex {
    std::uint32_t colour;
    float position[3];
    float u, v;
  };
  const std::array<Vertex, 2> vertices{{{7, {1, 2, 3}, 0, 0}, {8, {4, 5, 6}, 0, 0}}};
  const Strided<glm::vec3> positions(vertices[0].position, vertices.size(), sizeof(Vertex));
  EXPECT_EQ(positions[0], glm::vec3(1, 2, 3));
  EXPECT_EQ(positions[1], glm::vec3(4, 5, 6));
}

std::vector<int> values_of(Strided<int> strided) {
  std::vector<int> values;
  for (std::size_t i = 0; i < strided.size(); ++i) values.push_back(strided[i]);
  return values;
}

TEST(Strided, WhatIsASpanIsOneWithoutGaps) {
  const std::vector<int> numbers{4, 5, 6};
  EXPECT_EQ(values_of(numbers), numbers);
  EXPECT_EQ(values_of(std::span(numbers).subspan(1)), (std::vector{5, 6}));
  EXPECT_EQ(values_of(std::array{4, 5, 6}), numbers);
  EXPECT_TRUE(values_of({}).empty());
}

}  // namespace
}  // namespace foredraw::strided_test

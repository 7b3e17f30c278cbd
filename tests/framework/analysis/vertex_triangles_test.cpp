#include <foredraw/analysis/vertex_triangles.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace foredraw {
namespace {

using Numbers = std::vector<std::uint32_t>;

Numbers of(const VertexTriangles& triangles, std::uint32_t vertex) {
  const auto view = triangles.of(vertex);
  return {view.begin(), view.end()};
}

TEST(VertexTriangles, InTriangleOrder) {
  const Numbers indices = {0, 1, 2, 2, 1, 3, 3, 1, 0};
  const VertexTriangles triangles(indices, 5);
  EXPECT_EQ(of(triangles, 0), (Numbers{0, 2}));
  EXPECT_EQ(of(triangles, 1), (Numbers{0, 1, 2}));
  EXPECT_EQ(of(triangles, 3), (Numbers{1, 2}));
  EXPECT_EQ(of(triangles, 4), Numbers{}) << "nobody uses it";
}

TEST(VertexTriangles, TwiceUsedIsTwiceThere) {
  const Numbers indices = {1, 1, 0};
  EXPECT_EQ(of(VertexTriangles(indices, 2), 1), (Numbers{0, 0}));
}

TEST(VertexTriangles, OfNothing) {
  EXPECT_EQ(VertexTriangles({}, 0).offsets.size(), 1u);
  EXPECT_TRUE(VertexTriangles({}, 3).of(2).empty());
}

RC_GTEST_PROP(VertexTriangles, as_a_search_finds_them, ()) {
  const auto vertices = *rc::gen::inRange(1u, 30u);
  Numbers indices = *rc::gen::container<Numbers>(rc::gen::inRange(0u, vertices));
  indices.resize(indices.size() / 3 * 3);
  const VertexTriangles triangles(indices, vertices);
  RC_ASSERT(triangles.offsets.size() == vertices + 1);
  for (std::uint32_t vertex = 0; vertex < vertices; ++vertex) {
    Numbers expected;
    for (std::uint32_t corner = 0; corner < indices.size(); ++corner) {
      if (indices[corner] == vertex) expected.push_back(corner / 3);
    }
    RC_ASSERT(of(triangles, vertex) == expected);
  }
}

// What lives in lent memory takes none of its own.
TEST(VertexTriangles, LivesInLentMemory) {
  std::byte lent[4096];
  std::pmr::monotonic_buffer_resource memory(lent, sizeof lent, std::pmr::null_memory_resource());
  const Numbers indices = {0, 1, 2, 2, 1, 3};
  const VertexTriangles triangles(indices, 4, &memory);
  EXPECT_EQ(of(triangles, 2), (Numbers{0, 1}));
  const auto* at = reinterpret_cast<const std::byte*>(triangles.triangles.data());
  EXPECT_TRUE(at >= lent && at < lent + sizeof lent);
}

}  // namespace
}  // namespace foredraw

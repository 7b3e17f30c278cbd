#include <foredraw/analysis/equal_vertices.h>

#include "support/meshes.h"

#include <gtest/gtest.h>

namespace foredraw::equal_vertices_test {
namespace {

using Numbers = std::vector<std::uint32_t>;

TEST(EqualVertices, TheFirstOfEqualsStandsForAll) {
  EXPECT_EQ(first_of_equals(*testing::vertex_streams({{1, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}})),
            (Numbers{0, 1, 0, 0, 1}));
  EXPECT_EQ(first_of_equals(*testing::vertex_streams({{0.0f, 0, 0}, {-0.0f, 0, 0}})), (Numbers{0, 1}))
      << "equal in every bit";
  EXPECT_EQ(first_of_equals(*testing::vertex_streams({})), Numbers{});
}

TEST(EqualVertices, AreCountedAmongThoseThatAreDrawn) {
  const auto vertices = testing::vertex_streams({{1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}});
  Analyses analyses;
  EXPECT_EQ(count_equal_vertices(*vertices, Numbers{0, 1, 2}, analyses), 2u);
  EXPECT_EQ(count_equal_vertices(*vertices, Numbers{1, 3, 1}, analyses), 0u) << "its equals are not drawn";
  EXPECT_EQ(count_equal_vertices(*vertices, Numbers{1, 3, 2, 2, 3, 1}, analyses), 1u);
  EXPECT_EQ(analyses.size(), 1u) << "draws of the same vertices share the work";
}

}  // namespace
}  // namespace foredraw::equal_vertices_test

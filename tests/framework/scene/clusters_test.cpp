#include <foredraw/scene/clusters.h>

#include <gtest/gtest.h>

namespace foredraw::clusters_test {
namespace {

TEST(Clusters, PartitionStartsAtZeroEndsAtTheCountAndGrows) {
  EXPECT_TRUE(is_partition({{0, 1}}, 1));
  EXPECT_TRUE(is_partition({{0, 2, 5, 6}}, 6));
  EXPECT_FALSE(is_partition({{1, 2, 5, 6}}, 6)) << "begins late";
  EXPECT_FALSE(is_partition({{0, 2, 5}}, 6)) << "ends early";
  EXPECT_FALSE(is_partition({{0, 2, 5, 7}}, 6)) << "ends late";
  EXPECT_FALSE(is_partition({{0, 2, 2, 6}}, 6)) << "an empty cluster";
  EXPECT_FALSE(is_partition({{0, 5, 2, 6}}, 6)) << "backwards";
  EXPECT_FALSE(is_partition({{0, 7, 6}}, 6)) << "beyond the end and back";
}

TEST(Clusters, NoTrianglesHaveNoClusters) {
  EXPECT_TRUE(is_partition({{0}}, 0));
  EXPECT_FALSE(is_partition({{0, 0}}, 0));
  EXPECT_FALSE(is_partition({}, 0)) << "no offsets at all";
  EXPECT_FALSE(is_partition({{0}}, 1));
}

TEST(Clusters, CountIsOneLessThanOffsets) {
  EXPECT_EQ(Clusters{}.count(), 0u);
  EXPECT_EQ((Clusters{{0}}.count()), 0u);
  EXPECT_EQ((Clusters{{0, 3, 4}}.count()), 2u);
}

TEST(Clusters, in_sequence_keep_their_triangles_together) {
  EXPECT_EQ(in_sequence({{0, 2, 5, 6}}, std::vector<std::uint32_t>{2, 0, 1}),
            (std::vector<std::uint32_t>{5, 0, 1, 2, 3, 4}));
  EXPECT_TRUE(in_sequence({{0}}, {}).empty());
}

}  // namespace
}  // namespace foredraw::clusters_test

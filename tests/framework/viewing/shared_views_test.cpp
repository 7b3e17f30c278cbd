#include <foredraw/viewing/shared_views.h>

#include <foredraw/viewing/view_set.h>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <numeric>

namespace foredraw::shared_views_test {
namespace {

TEST(SharedViews, GiveEveryViewAndEveryPoseAsMany) {
  const Views views = make_views({.views = "fibonacci", .count = 81});
  for (const std::size_t poses : {2, 3, 16, 100, 200}) {
    const auto shares = shared_views(views.views, poses, 2 * 81);
    ASSERT_EQ(shares.size(), poses);
    std::vector<int> uses(81, 0);
    for (const auto& share : shares) {
      EXPECT_TRUE(std::ranges::is_sorted(share));
      EXPECT_GE(share.size(), 2 * 81 / poses);
      EXPECT_LE(share.size(), 2 * 81 / poses + 1);
      for (const std::size_t view : share) ++uses[view];
    }
    EXPECT_EQ(uses, std::vector<int>(81, 2)) << poses;
  }
}

TEST(SharedViews, NoPoseHasAViewTwice) {
  std::vector<std::size_t> all(42);
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(shared_views(make_views({.views = "42"}).views, 3, 1000), std::vector(3, all));
  EXPECT_EQ(shared_views({}, 3, 10), std::vector<std::vector<std::size_t>>(3));
}

/// Ten of eighty, spread at best, are 66 degrees apart; at random some are within ten.
TEST(SharedViews, ThoseOfAPoseLieFarFromEachOther) {
  const Views views = make_views({.views = "fibonacci", .count = 80});
  for (const auto& share : shared_views(views.views, 16, 160)) {
    double nearest = -1;
    for (const std::size_t a : share) {
      for (const std::size_t b : share) {
        if (a != b) nearest = std::max(nearest, glm::dot(views.views[a].direction, views.views[b].direction));
      }
    }
    EXPECT_LT(nearest, 0.94) << "20 degrees";
  }
}

}  // namespace
}  // namespace foredraw::shared_views_test

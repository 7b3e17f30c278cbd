#include <foredraw/frames/picture_losses.h>

#include "support/levelled_field.h"

#include <gtest/gtest.h>

namespace foredraw::picture_losses_test {
namespace {

PictureLosses losses_of(const Scene& scene) {
  Analyses analyses;
  const Executor executor(1);
  const FrameScene frames(scene, analyses, executor);
  return picture_losses(frames, frame_moment(frames, 0), 0);
}

TEST(PictureLosses, GrowWithTheLevelAndAreLessThanNothingAtAll) {
  const PictureLosses losses = losses_of(testing::scene_of({testing::levelled_sphere(64, 5)}));
  ASSERT_EQ(losses.of.size(), 5u);
  for (std::size_t size = 0; size < PictureLosses::sizes; ++size) {
    EXPECT_EQ(losses.of[0][0][size], 0);
    for (std::size_t level = 1; level < 5; ++level) {
      EXPECT_GT(losses.of[level][0][size], losses.of[level - 1][0][size]) << level << ' ' << size;
    }
    EXPECT_LT(losses.of[4][0][size], losses.without[size]);
  }
}

TEST(PictureLosses, LieBetweenSizes) {
  const PictureLosses::BySize losses = {0.5, 1, 2, 4, 8};
  EXPECT_EQ(PictureLosses::at(losses, 0), 0.5);
  EXPECT_EQ(PictureLosses::at(losses, 2), 0.5);
  EXPECT_NEAR(PictureLosses::at(losses, 4), 0.75, 1e-9);
  EXPECT_EQ(PictureLosses::at(losses, 8), 1);
  EXPECT_EQ(PictureLosses::at(losses, 32), 2);
  EXPECT_NEAR(PictureLosses::at(losses, 64), 3, 1e-9);
  EXPECT_EQ(PictureLosses::at(losses, 512), 8);
  EXPECT_EQ(PictureLosses::at(losses, 5000), 8);
}

/// Without light a sphere is a disc; without a normal map it is what it was, for it has none.
TEST(RenderingAccuracies, TellUnlitFromLit) {
  const auto accuracies = rendering_accuracies(losses_of(testing::scene_of({testing::levelled_sphere(32, 2)})));
  EXPECT_EQ(accuracies[0], 1);
  EXPECT_EQ(accuracies[1], 1);
  EXPECT_GT(accuracies[2], 0);
  EXPECT_LT(accuracies[2], 0.9);
}

TEST(RenderingAccuracies, AreTheSameWithoutAllLosses) {
  const Scene scene = testing::scene_of({testing::levelled_sphere(32, 3)});
  Analyses analyses;
  const Executor executor(1);
  const FrameScene frames(scene, analyses, executor);
  EXPECT_EQ(rendering_accuracies(frames, frame_moment(frames, 0), 0), rendering_accuracies(losses_of(scene)));
}

}  // namespace
}  // namespace foredraw::picture_losses_test

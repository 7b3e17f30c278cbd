#include "evaluators/thin_parts/thin_parts.h"

#include "support/meshes.h"
#include "support/thin_scenes.h"

#include <gtest/gtest.h>

namespace foredraw::thin_parts_test {
namespace {

using testing::ThinMesh;

constexpr FrameSize size{96, 96};

SeenWidths widths_of(const ThinMesh& mesh) {
  const Scene scene = testing::scene_of(mesh, {0, 0, 0}, false);
  Analyses analyses;
  const Executor executor(1);
  const FrameScene frames(scene, analyses, executor);
  return seen_widths(frames, frame_moment(frames, 0), testing::pixel_camera(size), size);
}

SurfaceShares shares_of(const ThinMesh& mesh, bool has_wires) {
  const Scene scene = testing::scene_of(mesh, {0, 0, 0}, has_wires);
  Analyses analyses;
  const Executor executor(1);
  const FrameScene frames(scene, analyses, executor);
  return surface_shares(frames, frame_moment(frames, 0));
}

TEST(ThinParts, BarsAreAsWideAsTheyAre) {
  const SeenWidths thin = widths_of(testing::bars(0.5f, size)), wide = widths_of(testing::bars(3, size));
  EXPECT_GT(thin.thinner_than(1), 0.95 * thin.seen());
  EXPECT_NEAR(thin.width_of(0.5), 0.5, 0.2);
  EXPECT_LT(wide.thinner_than(1), 0.05 * wide.seen());
  EXPECT_NEAR(wide.width_of(0.5), 3, 0.5);
}

TEST(ThinParts, LargeBodiesHaveNoThinParts) {
  const SeenWidths widths = widths_of(testing::turned_box(40));
  EXPECT_GT(widths.seen(), 1000 * SeenWidths::samples * SeenWidths::samples);
  EXPECT_LT(widths.thinner_than(1), 0.02 * widths.seen());
}

TEST(ThinParts, SharesOfTheSurface) {
  ThinMesh mesh = testing::turned_box(10);
  const double box = 600;
  SurfaceShares shares = shares_of(mesh, true);
  EXPECT_NEAR(shares.area, box, 0.1);
  EXPECT_NEAR(shares.closed, box, 0.1);
  EXPECT_EQ(shares.wires, 0);
  mesh.add_tube({{20, 0, 0}, {20, 100, 0}}, 0.1f, 8);  // open at its ends
  shares = shares_of(mesh, true);
  EXPECT_NEAR(shares.closed, box, 0.1);
  EXPECT_NEAR(shares.wires, shares.area - box, 0.1);
  EXPECT_GT(shares.wires, 60);
  EXPECT_EQ(shares_of(mesh, false).wires, 0);
}

}  // namespace
}  // namespace foredraw::thin_parts_test

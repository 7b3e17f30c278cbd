#include "plugins/processors/simplify/simplify.h"

#include "plugins/processors/quadric_collapse/quadric_collapse.h"
#include "support/meshes.h"

#include <foredraw/analysis/farthest_distance.h>
#include <foredraw/collapses/collapse_sequences.h>
#include <foredraw/technique/plugin.h>

#include <gtest/gtest.h>

#include <cmath>

namespace foredraw::simplify_test {
namespace {

JoinedMesh joined(const testing::TestMesh& mesh) {
  Analyses analyses;
  const std::vector<DrawId> draws{0};
  return *joined_mesh(testing::scene_of(mesh), draws, analyses);
}

class Simplify : public ::testing::Test {
 protected:
  Simplified to(const SimplifyOptions& options) { return simplify(mesh_, sequence_, run_, options, Executor(1)); }

  double distance(std::size_t collapses) const {
    const Collapsed after = collapsed(sequence_, collapses, mesh_.positions, mesh_.indices);
    const Surface full{mesh_.positions, mesh_.indices}, coarse{after.places, after.indices};
    return hausdorff_distance({full, ClosestPoints(full)}, {coarse, ClosestPoints(coarse)}, {}, Executor(1))->found;
  }

  const JoinedMesh mesh_ = joined(testing::torus(48, 24));
  const CollapseSequence sequence_ = quadric_collapse(mesh_.positions, mesh_.indices);
  const Replay run_ = replay(sequence_, mesh_.positions, mesh_.indices);
};

/// An edge inside takes two triangles with it, so that one less than asked for may be left.
TEST_F(Simplify, LeavesTheShareOfTriangles) {
  const std::uint32_t all = run_.triangles.front();
  const auto is_reached = [](const Simplified& mesh, std::uint32_t triangles) {
    return mesh.end == Simplified::End::goal && mesh.triangles <= triangles && mesh.triangles + 1 >= triangles;
  };
  EXPECT_TRUE(is_reached(to({}), all / 2));
  EXPECT_TRUE(is_reached(to({.ratio = 0.25}), all / 4));
  EXPECT_TRUE(is_reached(to({.triangles = 100}), 100));
  EXPECT_EQ(to({.ratio = 1}).collapses, 0u);
  EXPECT_EQ(to({.triangles = 1'000'000'000}).collapses, 0u);
}

TEST_F(Simplify, EndsWhereTheSequenceDoes) {
  for (const Simplified& least : {to({.triangles = 0}), to({.ratio = 0})}) {
    EXPECT_EQ(least.collapses, sequence_.collapses.size());
    EXPECT_EQ(least.end, Simplified::End::sequence);
  }
}

TEST_F(Simplify, NeverExceedsTheError) {
  for (const double error : {0.001, 0.01, 0.1}) {
    const Simplified near = to({.error = error});
    EXPECT_LE(distance(near.collapses), error);
    EXPECT_GT(distance(std::min(near.collapses + near.collapses / 20 + 2, sequence_.collapses.size())), error);
    EXPECT_EQ(near.end, Simplified::End::error);
  }
  EXPECT_EQ(to({.error = 0}).collapses, 0u);
}

TEST_F(Simplify, TheFirstLimitCounts) {
  EXPECT_EQ(to({.ratio = 0.9, .error = 1}).end, Simplified::End::goal);
  EXPECT_EQ(to({.ratio = 0.01, .error = 0.001}).end, Simplified::End::error);
}

}  // namespace
}  // namespace foredraw::simplify_test

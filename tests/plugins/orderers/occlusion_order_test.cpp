#include "plugins/orderers/occlusion_order/k_orders.h"

#include "support/overdraw.h"

#include <foredraw/analysis/cluster_layers.h>
#include <foredraw/analysis/vertex_cache.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace foredraw {
namespace {

using testing::TestMesh;

/// Spheres in one another, the innermost first: the worst order there is.
TestMesh shells(int count) {
  TestMesh all;
  for (int i = 1; i <= count; ++i) {
    TestMesh shell = testing::torus(48, 24);
    for (glm::vec3& p : shell.positions) p *= static_cast<float>(i);
    all = all.indices.empty() ? shell : testing::joined(all, shell);
  }
  return all;
}

TEST(OcclusionOrder, OfNothingIsNothing) {
  EXPECT_TRUE(occlusion_order({{}, 0, {{0}}}, {}).empty());
}

}  // namespace
}  // namespace foredraw

#include <foredraw/measuring/cache_orderer.h>

#include "support/meshes.h"

#include <gtest/gtest.h>

namespace foredraw::cache_orderer_test {
namespace {

class LeavesTheOrder final : public CacheOrderer {
  IndexOrder order_for_cache(const DrawView& draw, const Run&) const override {
    IndexOrder order(draw.triangle_count());
    for (std::uint32_t t = 0; t < order.size(); ++t) order[t] = t;
    return order;
  }
  CacheCount count(std::span<const std::uint32_t> indices, std::size_t vertex_count) const override {
    return count_fifo(indices, vertex_count, 16);
  }
};

std::optional<std::string> why_kept(const testing::TestMesh& mesh) {
  const Scene scene = testing::scene_of(mesh);
  testing::RunFixture fixture;
  LeavesTheOrder().order({scene, 0}, fixture.run);
  return fixture.findings.nothing_to_gain;
}

TEST(CacheOrderer, SaysThatWeldingHelpsWhereVerticesAreEqual) {
  const std::string once = "each of its vertices is shaded once, and no order shades fewer";
  EXPECT_EQ(why_kept(testing::soup(4, 3)), once);
  // Two triangles with an edge in common, each with vertices of its own.
  EXPECT_EQ(why_kept({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {0, 1, 2, 3, 4, 5}}),
            once + "; but 2 of them equal others: weld them first");
}

}  // namespace
}  // namespace foredraw::cache_orderer_test

// Meshes that a finder of wires must survive: each ends, and says nothing that is not so.
#include "plugins/processors/wire_radius/wire_radius.h"

#include "support/hostile_wires.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace foredraw::wire_radius_hostile_test {
namespace {

using testing::HostileWire;

FoundWires found(const HostileWire& mesh) {
  const FoundWires wires = find_wires(mesh.positions, mesh.indices);
  for (std::size_t t = 0; t < wires.wire_of.size(); ++t) {
    bool all = true, moves = false;
    for (std::size_t i = 3 * t; i < 3 * t + 3; ++i) {
      all &= wires.half_width[mesh.indices[i]] != 0;
      moves |= wires.half_width[mesh.indices[i]] > 0;
    }
    EXPECT_TRUE(wires.wire_of[t] == FoundWires::none ? !moves : all && moves) << "triangle " << t;
  }
  for (const float half : wires.half_width) EXPECT_TRUE(std::isfinite(half));
  for (const glm::vec3& way : wires.to_centre) EXPECT_TRUE(std::isfinite(way.x + way.y + way.z));
  return wires;
}

TEST(WireRadiusHostile, AllAreSurvived) {
  for (const auto& [name, mesh] : testing::hostile_wires()) {
    SCOPED_TRACE(name);
    found(mesh);
  }
  HostileWire least;
  least.tube(
      20, [](double t) { return 1e-44 * testing::straight(t); }, 1e-45);
  found(least);
}

TEST(WireRadiusHostile, NoWidthIsNoWire) { EXPECT_TRUE(found(testing::straight_tube(0)).wires.empty()); }

TEST(WireRadiusHostile, TheSameTubeTwiceIsOne) { EXPECT_EQ(found(testing::tube_twice()).wires.size(), 1u); }

TEST(WireRadiusHostile, SizesAtTheEndOfFloats) {
  for (const double scale : {1e-30, 1e30}) EXPECT_EQ(found(testing::scaled_tube(scale)).wires.size(), 1u) << scale;
}

TEST(WireRadiusHostile, ARingIsClosed) {
  const FoundWires wires = found(testing::wire_ring());
  ASSERT_EQ(wires.wires.size(), 1u);
  EXPECT_TRUE(wires.wires[0].closed);
  EXPECT_NEAR(wires.wires[0].length, 6 * std::numbers::pi, 0.05);
}

TEST(WireRadiusHostile, AKnotIsOneWire) { EXPECT_EQ(found(testing::wire_knot()).wires.size(), 1u); }

TEST(WireRadiusHostile, AMoebiusRibbonIsARibbon) {
  const FoundWires wires = found(testing::moebius_ribbon());
  ASSERT_EQ(wires.wires.size(), 1u);
  EXPECT_EQ(wires.wires[0].kind, WireKind::ribbon);
}

TEST(WireRadiusHostile, WallsOfAPipeAreTwoWires) { EXPECT_EQ(found(testing::pipe_in_a_pipe()).wires.size(), 2u); }

TEST(WireRadiusHostile, EachWireOfANetIsFound) { EXPECT_EQ(found(testing::chain_link_net()).wires.size(), 24u); }

TEST(WireRadiusHostile, WiresThatShareVertices) {
  EXPECT_FALSE(found(testing::wires_that_share_vertices()).wires.empty());
}

TEST(WireRadiusHostile, PleatsAreNone) { EXPECT_TRUE(found(testing::pleated_sheet()).wires.empty()); }

TEST(WireRadiusHostile, CancelEndsIt) {
  HostileWire mesh;
  mesh.tube(200, testing::straight, 0.1);
  const std::atomic<bool> cancel = true;
  EXPECT_TRUE(find_wires(mesh.positions, mesh.indices, {}, {.cancel = &cancel}).wires.empty());
}

}  // namespace
}  // namespace foredraw::wire_radius_hostile_test

// Draws that have wires and closed shells.
#include "support/wire_scenes.h"

#include <foredraw/shells/second_depth.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace foredraw::wire_radius_second_depth_test {
namespace {

using testing::triangles_of;

/// An antenna is torn from its body, which leaves the closed ones with it: the rest of the second depth stays.
TEST(WireRadiusFiles, SecondDepthKeepsWholeShells) {
  const Scene both = testing::scene_of_file(testing::mixed({"closed antenna", "egg", "plank", "sail hem"}));
  const Result alone = testing::run("second-depth", both), result = testing::run("second-depth, wire-radius", both);
  ASSERT_TRUE(alone.scene.products.has(SecondDepth::product));
  const auto* closed = result.scene.products.find<SecondDepth>();
  ASSERT_NE(closed, nullptr);
  ASSERT_NE(result.scene.products.find<Wires>(), nullptr);
  const std::uint32_t plank = static_cast<std::uint32_t>(testing::made_wire("plank").indices.size() / 3);
  const std::uint32_t egg = static_cast<std::uint32_t>(testing::made_wire("egg").indices.size() / 3);
  EXPECT_GT(alone.scene.products.find<SecondDepth>()->triangles_of(0), plank + egg) << "the antenna's body was closed";
  EXPECT_EQ(closed->triangles_of(0), plank + egg);
  const Result other = testing::run("wire-radius, second-depth", both);
  ASSERT_NE(other.scene.products.find<SecondDepth>(), nullptr);
  EXPECT_EQ(other.scene.products.find<SecondDepth>()->triangles_of(0), closed->triangles_of(0));
}

/// Of a draw with both, shells come first and wires last, whichever stage ran first, and later orders keep it so.
TEST(WireRadiusFiles, ShellsComeFirstAndWiresLastInEitherSequence) {
  const Scene both =
      testing::scene_of_file(testing::mixed({"closed antenna", "egg", "flat rope", "plank", "sail hem"}));
  for (const char* stages : {"second-depth, wire-radius", "wire-radius, second-depth"}) {
    const Scene made = testing::run(stages, both).scene;
    for (const char* later : {"tipsify, vertex-fetch", "lookahead(quality=fast)", "weld, forsyth, vertex-fetch"}) {
      SCOPED_TRACE(std::string(stages) + ", " + later);
      const Scene ordered = testing::run(later, made).scene;
      const auto *closed = ordered.products.find<SecondDepth>(), *was = made.products.find<SecondDepth>();
      const auto *wires = ordered.products.find<Wires>(), *wires_before = made.products.find<Wires>();
      ASSERT_TRUE(closed != nullptr && was != nullptr && wires != nullptr && wires_before != nullptr);
      EXPECT_EQ(closed->triangles_of(0), was->triangles_of(0));
      EXPECT_EQ(wires->draws, wires_before->draws);
      const std::uint32_t first = wires->draws[0].first_triangle;
      EXPECT_LE(closed->triangles_of(0), first);
      EXPECT_EQ(triangles_of(ordered, first), triangles_of(made, first));
      EXPECT_EQ(wires_product()->difference(ordered), "");
    }
  }
}
}  // namespace
}  // namespace foredraw::wire_radius_second_depth_test

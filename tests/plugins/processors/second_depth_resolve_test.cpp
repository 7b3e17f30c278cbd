// runtime/second_depth.h: where edges are found, and where not.
#include "second_depth_rows.h"

#include <foredraw/base/random.h>

#include <gtest/gtest.h>

#include <utility>

namespace foredraw::second_depth_resolve_test {
namespace {

using testing::edge_of;
using testing::Row;

constexpr float none = FOREDRAW_SECOND_DEPTH_NONE;

/// A body from x = `rim` to the right, before the sky.
Row silhouette(float rim) {
  return Row::of([=](float x) { return x < rim ? 1.f : 0.5f + 0.001f * (x - rim); },
                 [=](float x) { return x < rim ? 1.f : 0.5f + 0.004f * (x - rim); });
}

Row crease(float at) {
  return Row::of([=](float x) { return 0.5f + (x < at ? -0.002f : 0.003f) * (x - at); }, [](float) { return 0.9f; });
}

TEST(SecondDepthResolve, FindsCreasesAndSilhouettesWhereTheyAre) {
  for (float at = -0.48f; at < 0.5f; at += 0.06f) {
    EXPECT_NEAR(edge_of(crease(at)), at, 1e-3) << at;
    EXPECT_NEAR(edge_of(silhouette(at)), at, 1e-3) << at;
    EXPECT_NEAR(edge_of(silhouette(at).mirrored()), -at, 1e-3) << at;
  }
  for (const float at : {-1.4f, -0.8f, 0.6f, 0.9f, 1.7f}) {
    EXPECT_EQ(edge_of(crease(at)), none) << at;
    EXPECT_EQ(edge_of(silhouette(at)), none) << at;
  }
}

TEST(SecondDepthResolve, TakesEveryFormatAndDirectionOfDepth) {
  for (const float at : {-0.4f, -0.1f, 0.2f, 0.45f}) {
    for (const Row& row : {crease(at), silhouette(at)}) {
      EXPECT_NEAR(edge_of(row.reversed(), foredraw_second_depth_float(1)), at, 2e-3);
      for (const bool reversed : {false, true}) {
        const Row way = reversed ? row.reversed() : row;
        EXPECT_NEAR(edge_of(way.stored(16777215), foredraw_second_depth_unorm(24, reversed)), at, 2e-3);
        EXPECT_NEAR(edge_of(way.stored(65535), foredraw_second_depth_unorm(16, reversed)), at, 0.05);
      }
    }
  }
}

/// Rounded depths of a plane have no edges in any format.
TEST(SecondDepthResolve, TakesNoNoiseForAnEdge) {
  Random random(3);
  for (int i = 0; i < 20000; ++i) {
    const auto between = [&](float low, float high) {
      return low + (high - low) * static_cast<float>(random.below(1 << 20)) / static_cast<float>(1 << 20);
    };
    const float from = between(0.2f, 0.9f), slope = between(-0.02f, 0.02f), thick = between(0, 0.05f);
    const Row row =
        Row::of([=](float x) { return from + slope * x; }, [=](float x) { return from + slope * x + thick; });
    EXPECT_EQ(edge_of(row), none);
    EXPECT_EQ(edge_of(row.reversed(), foredraw_second_depth_float(1)), none);
    EXPECT_EQ(edge_of(row.stored(65535), foredraw_second_depth_unorm(16, 0)), none);
    EXPECT_EQ(edge_of(row.stored(16777215), foredraw_second_depth_unorm(24, 0)), none);
  }
}

/// Where both depths are cleared every slope is 0, and 0/0 must not win over an edge on the other side.
TEST(SecondDepthResolve, TheSkyIsNoBody) {
  const Row sky = Row::of([](float) { return 1.f; }, [](float) { return 1.f; });
  EXPECT_EQ(edge_of(sky), none);
  for (const float at : {-0.3f, 0.3f}) {
    EXPECT_NEAR(edge_of(silhouette(at)), at, 1e-3) << "the sky on the left";
    EXPECT_NEAR(edge_of(silhouette(at).mirrored()), -at, 1e-3) << "the sky on the right";
  }
  // Endless far planes: the sky is at 0.
  const Row endless = Row::of([](float x) { return x < 0.2f ? 0.f : 0.2f - 0.001f * (x - 0.2f); },
                              [](float x) { return x < 0.2f ? 0.f : 0.2f - 0.004f * (x - 0.2f); });
  EXPECT_NEAR(edge_of(endless, foredraw_second_depth_float(1)), 0.2f, 1e-3);
}

TEST(SecondDepthResolve, WhatIsNotInTheFrameIsNotAsked) {
  const foredraw_second_depth_rule rule = foredraw_second_depth_float(0);
  EXPECT_EQ(edge_of(silhouette(-0.3f), rule, 0, 3), none) << "at the border there is nothing to blend with";
  EXPECT_NEAR(edge_of(silhouette(0.3f), rule, 0, 3), 0.3f, 1e-3) << "but on the other side there is";
  EXPECT_NEAR(edge_of(silhouette(0.3f).mirrored(), rule, 3, 0), -0.3f, 1e-3);
  EXPECT_EQ(edge_of(silhouette(0.3f), rule, 3, 0), none);
  EXPECT_EQ(edge_of(silhouette(0.3f), rule, 3, 1), none) << "two samples of the body are needed";
  EXPECT_NEAR(edge_of(silhouette(0.3f), rule, 1, 2), 0.3f, 1e-3);
  EXPECT_NEAR(edge_of(silhouette(-0.3f), rule, 1, 2), -0.3f, 1e-3);
  EXPECT_EQ(edge_of(crease(0.3f), rule, 1, 3), none);
  EXPECT_NEAR(edge_of(crease(0.3f), rule, 2, 2), 0.3f, 1e-3);
  // What stands in unused places changes nothing.
  Row row = silhouette(-0.3f);
  row.depth[0] = row.depth[1] = row.depth[6] = 7;
  row.second[0] = row.second[1] = row.second[6] = -7;
  EXPECT_NEAR(edge_of(row, rule, 1, 2), -0.3f, 1e-3);
}

/// A bar of one pixel: the second sample is of the wall behind it.
TEST(SecondDepthResolve, AThinThingIsNoBody) {
  for (float wall = 0.503f; wall < 0.56f; wall += 0.0005f) {
    const Row row = Row::of([=](float x) { return x > 0.4f && x < 1.6f ? 0.5f : wall; },
                            [=](float x) { return x > 0.4f && x < 1.6f ? 0.502f : wall + 0.005f; });
    EXPECT_EQ(edge_of(row), none) << wall;
    EXPECT_EQ(edge_of(row.mirrored()), none) << wall;
  }
}

TEST(SecondDepthResolve, ARoundRimIsALineInTheSquareOfTheThickness) {
  for (float rim = -0.45f; rim < 0.5f; rim += 0.1f) {
    const auto half = [=](float x) { return x < rim ? 0.f : 0.01f * std::sqrt(x - rim); };
    const Row row = Row::of([=](float x) { return x < rim ? 1.f : 0.5f - half(x); },
                            [=](float x) { return x < rim ? 1.f : 0.5f + half(x); });
    foredraw_second_depth_rule rule = foredraw_second_depth_float(0);
    EXPECT_NEAR(edge_of(row, rule), rim, 2e-3);
    rule.round_rims = 0;
    const float straight = edge_of(row, rule);
    EXPECT_TRUE(straight == none || std::abs(straight - rim) > 0.02f) << "the rule is what finds it";
  }
}

TEST(SecondDepthResolve, BlendsAcrossTheNearerEdgeByWhatLiesBehindIt) {
  const auto offset = [](float row, float column) {
    float of[2];
    foredraw_second_depth_offset(row, column, of);
    return std::pair(of[0], of[1]);
  };
  EXPECT_EQ(offset(0.25f, none), std::pair(0.25f, 0.f));
  EXPECT_EQ(offset(-0.125f, 0.5f), std::pair(-0.375f, 0.f));
  EXPECT_EQ(offset(0.5f, -0.25f), std::pair(0.f, -0.25f));
  EXPECT_EQ(offset(none, none), std::pair(0.f, 0.f));
  EXPECT_EQ(offset(none, 0.5f), std::pair(0.f, 0.f));
}

}  // namespace
}  // namespace foredraw::second_depth_resolve_test

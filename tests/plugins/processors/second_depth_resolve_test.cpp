// runtime/second_depth.h: where edges are found, where not, and what it gains on frames.
#include <foredraw/runtime/second_depth.h>

#include "hidden_shapes.h"
#include "support/closed_bodies.h"
#include "support/small_frames.h"

#include <foredraw/base/random.h>

#include <gtest/gtest.h>

#include <functional>
#include <numbers>

namespace foredraw {
namespace {

using testing::SmallBody;
using testing::SmallCamera;
using testing::SmallFrame;
using testing::TestMesh;

constexpr float none = FOREDRAW_SECOND_DEPTH_NONE;

/// Seven samples of a row.
struct Row {
  std::array<float, 7> depth{}, second{};

  /// From functions of the place, in pixels.
  static Row of(const std::function<float(float)>& depth, const std::function<float(float)>& second) {
    Row row;
    for (std::size_t i = 0; i < 7; ++i) {
      row.depth[i] = depth(static_cast<float>(i) - 3);
      row.second[i] = second(static_cast<float>(i) - 3);
    }
    return row;
  }
  Row reversed() const {
    Row row = *this;
    for (float& d : row.depth) d = 1 - d;
    for (float& d : row.second) d = 1 - d;
    return row;
  }
  Row stored(double most) const {
    Row row = *this;
    for (float& d : row.depth) d = static_cast<float>(std::rint(static_cast<double>(d) * most) / most);
    for (float& d : row.second) d = static_cast<float>(std::rint(static_cast<double>(d) * most) / most);
    return row;
  }
  Row mirrored() const {
    Row row = *this;
    std::ranges::reverse(row.depth);
    std::ranges::reverse(row.second);
    return row;
  }
};

float edge_of(const Row& row, const foredraw_second_depth_rule& rule = foredraw_second_depth_float(0), int before = 3,
              int behind = 3) {
  return foredraw_second_depth_edge(&rule, row.depth.data(), row.second.data(), before, behind);
}

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

// --- frames ----------------------------------------------------------------------------------------------------------

struct Error {
  double none = 0, msaa4 = 0, resolved = 0;
  std::size_t pixels = 0;
  double rmse(double squares) const {
    return std::sqrt(squares / static_cast<double>(std::max<std::size_t>(pixels, 1)));
  }
};

class Judge {
 public:
  static constexpr int size = 128;

  Judge(SmallCamera camera, foredraw_second_depth_rule rule) : camera_(camera), rule_(rule) {}

  /// Root mean square errors over the pixels that edges touch, and those around them.
  Error of(const std::function<TestMesh(double unit)>& body, bool has_wall, int views = 6) const {
    Error error;
    Random random(11);
    const auto any = [&] { return static_cast<double>(random.below(1 << 20)) / (1 << 20); };
    const double unit = 1 / SmallCamera::pixels_per_unit(size, 7);  // a pixel, where the bodies are
    for (int view = 0; view < views; ++view) {
      std::vector<SmallBody> bodies;
      if (has_wall) {
        TestMesh wall = testing::box();
        for (glm::vec3& p : wall.positions) p *= glm::vec3(30, 30, 0.5f);
        bodies.push_back({placed(wall, {0, 0.5 * any() - 0.25, 0.5 * any() - 0.25}, {0, 0, -14}), 0.4f});
      }
      const glm::dvec3 turn(6.28 * any(), 6.28 * any(), 6.28 * any());
      bodies.push_back({placed(body(unit), turn, {2 * unit * any(), 2 * unit * any(), -7}), 1});
      add(bodies, error);
    }
    return error;
  }

 private:
  static TestMesh placed(TestMesh mesh, const glm::dvec3& turn, const glm::dvec3& at) {
    for (glm::vec3& p : mesh.positions) {
      glm::dvec3 q(p);
      const auto turned = [](double& a, double& b, double by) {
        const double x = a * std::cos(by) - b * std::sin(by);
        b = a * std::sin(by) + b * std::cos(by);
        a = x;
      };
      turned(q.y, q.z, turn.x);
      turned(q.z, q.x, turn.y);
      turned(q.x, q.y, turn.z);
      p = glm::vec3(q + at);
    }
    return mesh;
  }

  void add(const std::vector<SmallBody>& bodies, Error& error) const {
    constexpr int truths = 32;
    const SmallFrame frame = testing::drawn(bodies, size, camera_);
    const std::size_t pixels = frame.colour.size();
    std::vector<double> truth(pixels), msaa4(pixels);
    std::vector<bool> is_edge(pixels);
    const auto add_sample = [&](std::vector<double>& to, const glm::dvec2& place, int of, bool marks) {
      const SmallFrame sample = testing::drawn(bodies, size, camera_, place);
      for (std::size_t i = 0; i < pixels; ++i) {
        to[i] += static_cast<double>(sample.colour[i]) / of;
        if (marks && sample.colour[i] != frame.colour[i]) is_edge[i] = true;
      }
    };
    for (int k = 0; k < truths; ++k) {  // Hammersley's
      double radical = 0, place = 0.5;
      for (int bit = k; bit > 0; bit >>= 1, place /= 2) radical += (bit & 1) * place;
      add_sample(truth, {(k + 0.5) / truths - 0.5, radical + 0.5 / truths - 0.5}, truths, true);
    }
    for (const glm::dvec2& place : {glm::dvec2(-2, -6), {6, -2}, {-6, 2}, {2, 6}}) {
      add_sample(msaa4, place / 16.0, 4, false);
    }
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        bool is_judged = false;
        for (int n = 0; n < 9; ++n) {
          const int nx = std::clamp(x + n % 3 - 1, 0, size - 1), ny = std::clamp(y + n / 3 - 1, 0, size - 1);
          is_judged = is_judged || is_edge[index(nx, ny)];
        }
        if (!is_judged) continue;
        const double wanted = truth[index(x, y)];
        const auto squared = [&](double is) { return (is - wanted) * (is - wanted); };
        ++error.pixels;
        error.none += squared(frame.colour[index(x, y)]);
        error.msaa4 += squared(msaa4[index(x, y)]);
        error.resolved += squared(resolved(frame, x, y));
      }
    }
  }

  double resolved(const SmallFrame& frame, int x, int y) const {
    float offset[2];
    foredraw_second_depth_offset(edge(frame, x, y, 1, 0), edge(frame, x, y, 0, 1), offset);
    const float part = std::abs(offset[0]) + std::abs(offset[1]);
    const auto step = [](float by) { return by > 0 ? 1 : by < 0 ? -1 : 0; };
    const float other = frame.colour[index(x + step(offset[0]), y + step(offset[1]))];
    return (1 - part) * frame.colour[index(x, y)] + part * other;
  }

  float edge(const SmallFrame& frame, int x, int y, int dx, int dy) const {
    Row row;
    const int at = dx * x + dy * y;
    for (int k = -3; k <= 3; ++k) {
      const int step = std::clamp(at + k, 0, size - 1) - at;
      row.depth[static_cast<std::size_t>(k + 3)] = frame.depth[index(x + dx * step, y + dy * step)];
      row.second[static_cast<std::size_t>(k + 3)] = frame.second[index(x + dx * step, y + dy * step)];
    }
    return edge_of(row, rule_, std::min(at, 3), std::min(size - 1 - at, 3));
  }

  static std::size_t index(int x, int y) { return static_cast<std::size_t>(y * size + x); }

  SmallCamera camera_;
  foredraw_second_depth_rule rule_;
};

TestMesh bar(double unit, double x, double y, double z) {
  TestMesh mesh = testing::box();
  for (glm::vec3& p : mesh.positions) p *= glm::vec3(0.5 * unit * glm::dvec3(x, y, z));
  return mesh;
}

void expect_at_most(double is, double most, const char* what) {
  EXPECT_LE(is, most) << what;
  std::printf("  %-24s %.4f (at most %.4f)\n", what, is, most);
}

TEST(SecondDepthFrames, LargeFacesAndRoundRimsAreAsGoodAsFourSamples) {
  const Judge judge({}, foredraw_second_depth_float(0));
  for (const bool has_wall : {true, false}) {
    const Error box = judge.of([](double unit) { return bar(unit, 70, 70, 70); }, has_wall, 4);
    const Error sphere = judge.of(
        [](double unit) { return testing::closed_sphere(96, 48, static_cast<float>(32 * unit)); }, has_wall, 8);
    if (has_wall) expect_at_most(box.rmse(box.resolved), box.rmse(box.msaa4), "box 70, wall");
    expect_at_most(box.rmse(box.resolved), 0.45 * box.rmse(box.none), has_wall ? "box 70, wall" : "box 70, sky");
    expect_at_most(sphere.rmse(sphere.resolved), sphere.rmse(sphere.msaa4), has_wall ? "sphere, wall" : "sphere, sky");
  }
}

TEST(SecondDepthFrames, NothingIsWorseThanWithout) {
  const Judge judge({}, foredraw_second_depth_float(0));
  const auto expect_no_worse = [&](const char* what, const std::function<TestMesh(double)>& body) {
    for (const bool has_wall : {true, false}) {
      const Error error = judge.of(body, has_wall, 2);
      expect_at_most(error.rmse(error.resolved), 1.02 * error.rmse(error.none), what);
    }
  };
  for (const double width : {1.0, 2.0, 4.0, 6.0}) {
    expect_no_worse("bar", [=](double unit) { return bar(unit, width, width, 60); });
  }
  expect_no_worse("box 16", [](double unit) { return bar(unit, 16, 16, 16); });
  expect_no_worse("plate", [](double unit) { return bar(unit, 60, 4, 40); });
  expect_no_worse("coarse sphere",
                  [](double unit) { return testing::closed_sphere(48, 24, static_cast<float>(32 * unit)); });
  expect_no_worse("cylinder", [](double unit) {
    return testing::closed_cylinder(96, static_cast<float>(25 * unit), static_cast<float>(20 * unit));
  });
  expect_no_worse("thin torus", [](double unit) {
    return testing::closed_torus(64, 12, static_cast<float>(28 * unit), static_cast<float>(3 * unit));
  });
}

TEST(SecondDepthFrames, EveryFormatOfDepthGains) {
  for (const int bits : {16, 24, 32}) {
    for (const bool reversed : {false, true}) {
      SmallCamera camera;
      camera.bits = bits;
      camera.reversed = reversed;
      const auto rule = bits == 32 ? foredraw_second_depth_float(reversed)
                                   : foredraw_second_depth_unorm(static_cast<unsigned>(bits), reversed);
      const Error error = Judge(camera, rule).of([](double unit) { return bar(unit, 50, 50, 50); }, true, 2);
      expect_at_most(error.rmse(error.resolved), 0.5 * error.rmse(error.none), reversed ? "reversed" : "forward");
    }
  }
}

}  // namespace
}  // namespace foredraw

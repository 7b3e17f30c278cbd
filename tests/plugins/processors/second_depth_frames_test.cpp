// runtime/second_depth.h: what it gains on frames.
#include "hidden_shapes.h"
#include "second_depth_rows.h"
#include "support/closed_bodies.h"
#include "support/small_frames.h"

#include <foredraw/base/random.h>

#include <gtest/gtest.h>

#include <cstdio>
#include <functional>

namespace foredraw::second_depth_frames_test {
namespace {

using testing::edge_of;
using testing::Row;
using testing::SmallBody;
using testing::SmallCamera;
using testing::SmallFrame;
using testing::TestMesh;

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
      add(bodies, [&](int, int) -> Error& { return error; });
    }
    return error;
  }

  /// Of an upright body before the sky, turned and moved a little: left, right, above and below of its middle.
  std::array<Error, 4> of_sides(const std::function<TestMesh(double unit)>& body, int views) const {
    std::array<Error, 4> sides;
    Random random(13);
    const auto any = [&] { return 2 * static_cast<double>(random.below(1 << 20)) / (1 << 20) - 1; };
    const double unit = 1 / SmallCamera::pixels_per_unit(size, 7);
    for (int view = 0; view < views; ++view) {
      const glm::dvec3 turn(0.05 * any(), 0.05 * any(), 0.1 * any());
      add({{placed(body(unit), turn, {unit * any(), unit * any(), -7}), 1}}, [&](int x, int y) -> Error& {
        const int right = 2 * x + 1 - size, below = 2 * y + 1 - size;
        return std::abs(right) > std::abs(below) ? sides[right > 0 ? 1 : 0] : sides[below > 0 ? 3 : 2];
      });
    }
    return sides;
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

  /// Each pixel's error goes to the one that `error_at` names.
  void add(const std::vector<SmallBody>& bodies, const std::function<Error&(int x, int y)>& error_at) const {
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
        Error& error = error_at(x, y);
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

/// The sky is a neighbour that has no slope, on whichever side it is.
TEST(SecondDepthFrames, ABoxBeforeTheSkyGainsOnAllFourSides) {
  constexpr const char* names[] = {"left", "right", "above", "below"};
  for (const bool reversed : {false, true}) {
    SmallCamera camera;
    camera.reversed = reversed;
    const Judge judge(camera, foredraw_second_depth_float(reversed));
    const auto sides = judge.of_sides([](double unit) { return bar(unit, 50, 50, 50); }, 8);
    for (std::size_t side = 0; side < sides.size(); ++side) {
      const Error& error = sides[side];
      EXPECT_GT(error.pixels, 500u) << names[side];
      expect_at_most(error.rmse(error.resolved), 0.45 * error.rmse(error.none), names[side]);
    }
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
}  // namespace foredraw::second_depth_frames_test

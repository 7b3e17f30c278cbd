// Meshes that a finder of wires must survive: each ends, and says nothing that is not so.
#include "plugins/processors/wire_radius/wire_radius.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace foredraw {
namespace {

struct Hostile {
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;

  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { indices.insert(indices.end(), {a, b, c}); }

  /// A tube of eight sides with its middle at each place; the last ring joins the first one where it is closed.
  void tube(std::uint32_t rings, const std::function<glm::dvec3(double)>& place, double radius, bool closed = false,
            bool inside_out = false) {
    constexpr std::uint32_t sides = 8;
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (std::uint32_t r = 0; r < rings; ++r) {
      const double t = static_cast<double>(r) / (closed ? rings : rings - 1);
      const glm::dvec3 way = glm::normalize(place(t + 1e-3) - place(t - 1e-3));
      const glm::dvec3 u =
          glm::normalize(glm::cross(way, std::abs(way.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0)));
      const glm::dvec3 v = glm::cross(way, u);
      for (std::uint32_t s = 0; s < sides; ++s) {
        const double angle = 2 * std::numbers::pi * s / sides;
        positions.emplace_back(place(t) + radius * (std::cos(angle) * u + std::sin(angle) * v));
      }
    }
    for (std::uint32_t r = 0; r + (closed ? 0 : 1) < rings; ++r) {
      for (std::uint32_t s = 0; s < sides; ++s) {
        const std::uint32_t a = first + r * sides + s, b = first + r * sides + (s + 1) % sides;
        const std::uint32_t c = first + (r + 1) % rings * sides + s,
                            d = first + (r + 1) % rings * sides + (s + 1) % sides;
        inside_out ? triangle(a, d, b) : triangle(a, b, d);
        inside_out ? triangle(a, c, d) : triangle(a, d, c);
      }
    }
  }

  FoundWires found(const WireOptions& options = {}) const {
    const FoundWires wires = find_wires(positions, indices, options);
    for (std::size_t t = 0; t < wires.wire_of.size(); ++t) {
      bool all = true, moves = false;
      for (std::size_t i = 3 * t; i < 3 * t + 3; ++i) {
        all &= wires.half_width[indices[i]] != 0;
        moves |= wires.half_width[indices[i]] > 0;
      }
      EXPECT_TRUE(wires.wire_of[t] == FoundWires::none ? !moves : all && moves) << "triangle " << t;
    }
    for (const float half : wires.half_width) EXPECT_TRUE(std::isfinite(half));
    for (const glm::vec3& way : wires.to_centre) EXPECT_TRUE(std::isfinite(way.x + way.y + way.z));
    return wires;
  }
};

glm::dvec3 straight(double t) { return {10 * t, 0, 0}; }

glm::dvec3 round(double t) {
  const double angle = 2 * std::numbers::pi * t;
  return {3 * std::cos(angle), 0, 3 * std::sin(angle)};
}

TEST(WireRadiusHostile, NoWidth) {
  Hostile mesh;
  mesh.tube(20, straight, 0);
  EXPECT_TRUE(mesh.found().wires.empty());
}

TEST(WireRadiusHostile, RingsThatCoincide) {
  Hostile mesh;
  mesh.tube(
      40, [](double t) { return straight(std::floor(t * 20) / 20); }, 0.1);
  mesh.found();
  Hostile doubled;
  doubled.tube(20, straight, 0.1);
  doubled.tube(20, straight, 0.1);
  EXPECT_EQ(doubled.found().wires.size(), 1u) << "the same tube twice is one";
}

TEST(WireRadiusHostile, NumbersThatAreNone) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    Hostile mesh;
    mesh.tube(20, straight, 0.1);
    mesh.positions[77].y = bad;
    for (const float half : mesh.found().half_width) EXPECT_TRUE(std::isfinite(half));
  }
}

TEST(WireRadiusHostile, SizesAtTheEndOfFloats) {
  for (const double scale : {1e-30, 1e30}) {
    Hostile mesh;
    mesh.tube(
        20, [&](double t) { return scale * straight(t); }, scale * 0.1);
    EXPECT_EQ(mesh.found().wires.size(), 1u) << scale;
  }
  Hostile least;
  least.tube(
      20, [](double t) { return 1e-44 * straight(t); }, 1e-45);
  least.found();
}

TEST(WireRadiusHostile, Torus) {
  Hostile mesh;
  mesh.tube(64, round, 0.1, true);
  const FoundWires wires = mesh.found();
  ASSERT_EQ(wires.wires.size(), 1u);
  EXPECT_TRUE(wires.wires[0].closed);
  EXPECT_NEAR(wires.wires[0].length, 6 * std::numbers::pi, 0.05);
}

/// Each turn lies on the last one, and shares its vertices.
TEST(WireRadiusHostile, CoilWeldedTurnToTurn) {
  Hostile mesh;
  constexpr std::uint32_t turns = 8, around = 24;
  for (std::uint32_t level = 0; level <= turns; ++level) {
    for (std::uint32_t i = 0; i < around; ++i) {
      const glm::dvec3 at = round(static_cast<double>(i) / around);
      mesh.positions.emplace_back(at.x, 0.2 * level, at.z);
      mesh.positions.emplace_back(1.1 * at.x, 0.2 * level, 1.1 * at.z);
    }
  }
  for (std::uint32_t level = 0; level < turns; ++level) {
    for (std::uint32_t i = 0; i < around; ++i) {
      const auto number = [&](std::uint32_t l, std::uint32_t j, std::uint32_t out) {
        return 2 * (l * around + j % around) + out;
      };
      const std::uint32_t corner[8] = {number(level, i, 0),         number(level, i, 1),        number(level + 1, i, 1),
                                       number(level + 1, i, 0),     number(level, i + 1, 0),    number(level, i + 1, 1),
                                       number(level + 1, i + 1, 1), number(level + 1, i + 1, 0)};
      for (std::uint32_t s = 0; s < 4; ++s) {
        mesh.triangle(corner[s], corner[(s + 1) % 4], corner[4 + (s + 1) % 4]);
        mesh.triangle(corner[s], corner[4 + (s + 1) % 4], corner[4 + s]);
      }
    }
  }
  mesh.found();
}

TEST(WireRadiusHostile, Knot) {
  Hostile mesh;
  mesh.tube(
      400,
      [](double t) {
        const double a = 2 * std::numbers::pi * t;
        return glm::dvec3(std::sin(a) + 2 * std::sin(2 * a), std::cos(a) - 2 * std::cos(2 * a), -std::sin(3 * a));
      },
      0.1, true);
  EXPECT_EQ(mesh.found().wires.size(), 1u);
}

TEST(WireRadiusHostile, MoebiusRibbon) {
  Hostile mesh;
  constexpr std::uint32_t around = 48;
  for (std::uint32_t i = 0; i < around; ++i) {
    const double angle = 2 * std::numbers::pi * i / around;
    const glm::dvec3 out(std::cos(angle), 0, std::sin(angle)), up(0, 1, 0);
    const glm::dvec3 across = std::cos(angle / 2) * out + std::sin(angle / 2) * up;
    mesh.positions.emplace_back(3.0 * out + 0.05 * across);
    mesh.positions.emplace_back(3.0 * out - 0.05 * across);
  }
  for (std::uint32_t i = 0; i < around; ++i) {
    const bool last = i + 1 == around;
    const std::uint32_t a = 2 * i, b = a + 1, c = last ? 1 : a + 2, d = last ? 0 : a + 3;
    mesh.triangle(a, b, d);
    mesh.triangle(a, d, c);
  }
  const FoundWires wires = mesh.found();
  ASSERT_EQ(wires.wires.size(), 1u);
  EXPECT_EQ(wires.wires[0].kind, WireKind::ribbon);
}

/// The walls are two wires with one centre line.
TEST(WireRadiusHostile, PipeInAPipe) {
  Hostile mesh;
  mesh.tube(20, straight, 0.1);
  mesh.tube(20, straight, 0.08, false, true);
  const FoundWires wires = mesh.found();
  EXPECT_EQ(wires.wires.size(), 2u);
}

TEST(WireRadiusHostile, OneTriangle) {
  Hostile mesh;
  mesh.positions = {{0, 0, 0}, {10, 0, 0}, {10, 0.1f, 0}};
  mesh.triangle(0, 1, 2);
  mesh.found();
}

TEST(WireRadiusHostile, ChainLinkNet) {
  Hostile mesh;
  for (std::uint32_t i = 0; i < 12; ++i) {
    for (const double lean : {1.0, -1.0}) {
      mesh.tube(
          24, [&](double t) { return glm::dvec3(0.3 * i + lean * 2 * t, 2 * t, 0.02 * std::sin(40 * t)); }, 0.01);
    }
  }
  EXPECT_EQ(mesh.found().wires.size(), 24u);
}

/// Steps of the grid are half the radius.
TEST(WireRadiusHostile, QuantizedToTwoStepsARadius) {
  Hostile mesh;
  mesh.tube(
      60, [](double t) { return glm::dvec3(400 * t, 60 * t * t, 0); }, 2.2);
  for (glm::vec3& at : mesh.positions) at = glm::vec3(std::round(at.x), std::round(at.y), std::round(at.z));
  mesh.found();
}

TEST(WireRadiusHostile, WiresThatShareVertices) {
  Hostile mesh;
  mesh.tube(20, straight, 0.1);
  const std::size_t first = mesh.positions.size();
  mesh.tube(
      20, [](double t) { return glm::dvec3(10 + 10 * t, 0, 0); }, 0.1);
  mesh.positions[first] = mesh.positions[first - 8];  // in one vertex
  const FoundWires wires = mesh.found();
  EXPECT_FALSE(wires.wires.empty());
}

TEST(WireRadiusHostile, ThreeSheetsAtAnEdge) {
  Hostile mesh;
  mesh.positions = {{0, 0, 0},        {10, 0, 0},        {0, 0.2f, 0},      {10, 0.2f, 0},
                    {0, -0.2f, 0.1f}, {10, -0.2f, 0.1f}, {0, -0.2f, -0.1f}, {10, -0.2f, -0.1f}};
  for (const std::uint32_t side : {2u, 4u, 6u}) {
    mesh.triangle(0, 1, side + 1);
    mesh.triangle(0, side + 1, side);
  }
  mesh.found();
}

TEST(WireRadiusHostile, ManyOfWhatIsNone) {
  Hostile mesh;  // a sheet that is folded again and again
  constexpr std::uint32_t columns = 200, rows = 60;
  for (std::uint32_t y = 0; y <= rows; ++y) {
    for (std::uint32_t x = 0; x <= columns; ++x) mesh.positions.emplace_back(0.1f * (x % 2), 0.1f * y, 0.1f * x);
  }
  for (std::uint32_t y = 0; y < rows; ++y) {
    for (std::uint32_t x = 0; x < columns; ++x) {
      const std::uint32_t a = y * (columns + 1) + x, b = a + columns + 1;
      mesh.triangle(a, a + 1, b + 1);
      mesh.triangle(a, b + 1, b);
    }
  }
  EXPECT_TRUE(mesh.found().wires.empty());
}

TEST(WireRadiusHostile, CancelEndsIt) {
  Hostile mesh;
  mesh.tube(200, straight, 0.1);
  const std::atomic<bool> cancel = true;
  EXPECT_TRUE(find_wires(mesh.positions, mesh.indices, {}, {.cancel = &cancel}).wires.empty());
}

}  // namespace
}  // namespace foredraw

#include "plugins/processors/quadric_collapse/quadric_collapse.h"

#include "support/collapses.h"
#include "support/vector_widths.h"

#include <foredraw/analysis/closest_points.h>
#include <foredraw/collapses/replay.h>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <limits>
#include <set>

namespace foredraw::quadric_collapse_test {
namespace {

using testing::coarse;
using testing::distance;
using testing::edges;
using testing::euler;
using testing::moved;
using testing::TestMesh;

TestMesh coarse(const TestMesh& mesh, std::size_t triangles, QuadricCollapseOptions options = {}) {
  options.least = triangles;
  return testing::coarse(mesh, quadric_collapse(mesh.positions, mesh.indices, options), triangles);
}

double volume(const TestMesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const glm::dvec3 a(mesh.positions[mesh.indices[i]]), b(mesh.positions[mesh.indices[i + 1]]),
        c(mesh.positions[mesh.indices[i + 2]]);
    sum += a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
  }
  return sum / 6;
}

/// A sphere loses volume where points stay on it, as chords lie below it. Lindstrom and Turk 1998 keep it.
TEST(QuadricCollapse, KeepsTheVolume) {
  const TestMesh sphere = testing::sphere(96, 48);
  const TestMesh tenth = coarse(sphere, sphere.indices.size() / 30);
  EXPECT_NEAR(volume(tenth) / volume(sphere), 1, 1e-4);
  const TestMesh endpoints = coarse(sphere, sphere.indices.size() / 30, {.placement = CollapsePlacement::endpoint});
  EXPECT_LT(volume(endpoints) / volume(sphere), 0.997);
}

TEST(QuadricCollapse, LeavesFlatPiecesForNothingUpToTheirOutline) {
  const TestMesh plate = testing::grid(60, 60);
  const TestMesh left = coarse(plate, 2);
  EXPECT_LE(left.indices.size() / 3, 8u);
  EXPECT_LT(distance(plate, left), 1e-4);
}

/// Two plates far apart: what a quadric about a common origin can not tell from rounding.
TEST(QuadricCollapse, KnowsFlatFromNearlyFlatFarFromTheOrigin) {
  const TestMesh plates = testing::joined(testing::grid(40, 40), moved(testing::grid(40, 40), {0, 0, 36000}));
  const TestMesh left = coarse(plates, plates.indices.size() / 300);
  EXPECT_EQ(left.indices.size() / 3, plates.indices.size() / 300);
  EXPECT_LT(distance(plates, left), 36000e-6);
}

TEST(QuadricCollapse, ATorusStaysATorus) {
  const TestMesh torus = testing::closed_torus(64, 32);
  const TestMesh left = coarse(torus, 100);
  EXPECT_LE(left.indices.size() / 3, 100u);
  EXPECT_EQ(euler(left), 0);
  EXPECT_EQ(edges(left).size(), 1u);  // all of two triangles
}

TEST(QuadricCollapse, BothRimsOfARingStay) {
  TestMesh ring;
  constexpr std::uint32_t around = 64, across = 8;
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j <= across; ++j) {
      const double angle = 6.283185307179586 * i / around, radius = 1 + double(j) / across;
      ring.positions.push_back(glm::vec3(radius * std::cos(angle), radius * std::sin(angle), 0));
      if (j == across) continue;
      const std::uint32_t a = i * (across + 1) + j, b = (i + 1) % around * (across + 1) + j;
      ring.indices.insert(ring.indices.end(), {a, b, b + 1, a, b + 1, a + 1});
    }
  }
  const TestMesh left = coarse(ring, 40);
  EXPECT_EQ(euler(left), 0);
  EXPECT_LT(distance(ring, left), 0.1);
}

/// Scaled by a power of two and moved so that no bit is lost, the same edges collapse: costs are made of differences.
TEST(QuadricCollapse, PlaceAndScaleDoNotMatter) {
  TestMesh torus = testing::torus(32, 16);
  for (glm::vec3& p : torus.positions) p = glm::round(p * 1024.0f);
  TestMesh other = moved(torus, glm::vec3(1 << 14));
  for (glm::vec3& p : other.positions) p *= 0x1p-20f;
  const auto pairs_of = [](const TestMesh& mesh) {
    return quadric_collapse(mesh.positions, mesh.indices, {.placement = CollapsePlacement::endpoint}).pairs;
  };
  EXPECT_EQ(pairs_of(torus), pairs_of(other));
}

/// A box of flat sides, each with vertices of its own: seams along all edges.
TEST(QuadricCollapse, ABoxWithSeamsComesDownToItsTwelveTriangles) {
  TestMesh box;
  const TestMesh side = testing::grid(8, 8);
  glm::vec3 most(0);
  for (const glm::vec3& p : side.positions) most = glm::max(most, p);
  const auto add = [&](auto place) {
    TestMesh one = side;
    for (glm::vec3& p : one.positions) p = place(p.x / most.x, p.y / most.y);
    box = testing::joined(box, one);
  };
  add([](float u, float v) { return glm::vec3(u, v, 1); });
  add([](float u, float v) { return glm::vec3(v, u, 0); });
  add([](float u, float v) { return glm::vec3(1, u, v); });
  add([](float u, float v) { return glm::vec3(0, v, u); });
  add([](float u, float v) { return glm::vec3(v, 1, u); });
  add([](float u, float v) { return glm::vec3(u, 0, v); });
  const TestMesh left = coarse(box, 12);
  EXPECT_EQ(left.indices.size() / 3, 12u);
  EXPECT_LT(distance(box, left), 1e-5);
}

TEST(QuadricCollapse, TetrahedraDoNotVanish) {
  TestMesh many;
  const TestMesh one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}};
  for (int i = 0; i < 100; ++i) many = testing::joined(many, moved(one, glm::vec3(3 * i, 0, 0)));
  EXPECT_EQ(coarse(many, 0, {.parts = 0}).indices.size(), many.indices.size());
}

TEST(QuadricCollapse, SingleTrianglesDoNotVanish) {
  const TestMesh soup = testing::soup(100, 5);
  EXPECT_EQ(coarse(soup, 0, {.parts = 0}).indices.size(), soup.indices.size());
}

TEST(QuadricCollapse, TakesWhateverItIsGiven) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  std::vector<TestMesh> meshes{{},
                               {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2}},
                               {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2, 0, 1, 2, 2, 1, 0, 0, 0, 1}},
                               {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {0, 1, 2}},
                               testing::soup(300, 3)};
  TestMesh fan;  // of which each triangle shares one edge
  for (std::uint32_t i = 0; i < 100; ++i) fan.indices.insert(fan.indices.end(), {0, 1, i + 2});
  for (std::uint32_t i = 0; i < 102; ++i) fan.positions.push_back(glm::vec3(i < 2 ? i : 0.5f, i % 10, i / 10));
  meshes.push_back(fan);
  TestMesh broken = testing::torus(16, 8);
  broken.positions[3] = {nan, 0, 0};
  broken.positions[70] = {0, infinity, 0};
  meshes.push_back(broken);
  for (const float scale : {1e-30f, 1e30f, 1e-38f}) {
    TestMesh mesh = testing::torus(16, 8);
    for (glm::vec3& p : mesh.positions) p *= scale;
    meshes.push_back(mesh);
  }
  TestMesh line = testing::grid(10, 10);
  for (glm::vec3& p : line.positions) p.y = p.z = 0;
  meshes.push_back(line);
  for (const TestMesh& mesh : meshes) {
    for (const CollapsePlacement placement : {CollapsePlacement::optimal, CollapsePlacement::endpoint}) {
      const CollapseSequence sequence = quadric_collapse(mesh.positions, mesh.indices, {.placement = placement});
      EXPECT_EQ(replay(sequence, mesh.positions, mesh.indices).mistake, "");
    }
  }
}

TEST(QuadricCollapse, IsTheSameAtEveryVectorWidth) {
  for (const TestMesh& mesh : {testing::closed_torus(40, 24), testing::grid(30, 30), testing::box_of_sides(8)}) {
    const CollapseSequence want = quadric_collapse(mesh.positions, mesh.indices);
    std::size_t widths = 0;
    testing::at_every_width([&] {
      EXPECT_EQ(quadric_collapse(mesh.positions, mesh.indices), want);
      ++widths;
    });
    EXPECT_GT(widths, 1u);
  }
}

testing::Simplify to_endpoints_or_not(CollapsePlacement placement) {
  return [placement](const TestMesh& mesh, std::size_t least) {
    return quadric_collapse(mesh.positions, mesh.indices, {.placement = placement, .least = least});
  };
}

TEST(QuadricCollapse, KeepsWhatEverySimplifierKeeps) {
  for (const CollapsePlacement placement : {CollapsePlacement::optimal, CollapsePlacement::endpoint}) {
    testing::expect_topology_stays(to_endpoints_or_not(placement));
    testing::expect_seams_stay(to_endpoints_or_not(placement));
    testing::expect_odd_meshes_run(to_endpoints_or_not(placement));
    const TestMesh strip = coarse(testing::moebius_strip(200), 100, {.placement = placement});
    EXPECT_EQ(euler(strip), 0);
    EXPECT_LE(strip.indices.size() / 3, 100u);
  }
}

/// Against the nearest triangle of what was there.
TEST(QuadricCollapse, NoTriangleTurnsOverOrIsThereTwice) {
  TestMesh hills = testing::grid(80, 80);
  for (glm::vec3& p : hills.positions) p.z = 3 * std::sin(0.4f * p.x) * std::cos(0.3f * p.y);
  const auto normal = [](const TestMesh& mesh, std::size_t t) {
    const auto at = [&](std::size_t k) { return glm::dvec3(mesh.positions[mesh.indices[3 * t + k]]); };
    return glm::cross(at(1) - at(0), at(2) - at(0));
  };
  for (const TestMesh& mesh : {testing::closed_torus(96, 48), hills}) {
    const ClosestPoints surface(Surface{mesh.positions, mesh.indices});
    for (const std::size_t share : {4, 10, 25}) {
      const TestMesh left = coarse(mesh, mesh.indices.size() / 3 / share);
      std::set<std::array<std::uint32_t, 3>> seen;
      for (std::size_t t = 0; t < left.indices.size() / 3; ++t) {
        std::array corners{left.indices[3 * t], left.indices[3 * t + 1], left.indices[3 * t + 2]};
        glm::dvec3 middle(0);
        for (const std::uint32_t v : corners) middle += glm::dvec3(left.positions[v]) / 3.0;
        std::ranges::sort(corners);
        EXPECT_TRUE(seen.insert(corners).second);
        EXPECT_GT(glm::dot(normal(left, t), normal(mesh, surface.nearest(middle).triangle)), 0) << share;
      }
    }
  }
}

/// A mesh of several pieces, with a seam around it where `has_seam`.
TestMesh in_pieces(bool has_seam) { return has_seam ? testing::torus(150, 80) : testing::closed_torus(150, 80); }

TEST(QuadricCollapse, DoesNotDependOnWhoWorksOnWhichPieceWhen) {
  const Executor executor(2);
  const Executor backwards(2, [](std::size_t count, const std::function<void(std::size_t)>& task) {
    while (count > 0) task(--count);
  });
  // All edges of a flat plate cost the same.
  for (const TestMesh& mesh : {in_pieces(false), in_pieces(true), testing::grid(110, 110)}) {
    for (const CollapsePlacement placement : {CollapsePlacement::optimal, CollapsePlacement::endpoint}) {
      QuadricCollapseOptions options{.placement = placement};
      const CollapseSequence want = quadric_collapse(mesh.positions, mesh.indices, options);
      const Replay run = replay(want, mesh.positions, mesh.indices);
      EXPECT_EQ(run.mistake, "");
      EXPECT_LT(run.triangles.back(), 200u);
      options.executor = placement == CollapsePlacement::optimal ? &executor : &backwards;
      EXPECT_EQ(quadric_collapse(mesh.positions, mesh.indices, options), want);
    }
  }
}

/// What lies between pieces does not lag behind: what is left of a sphere in pieces is as close as what is left of one
/// that is a single piece. Distances go with one over the triangles.
TEST(QuadricCollapse, PiecesLeaveNoTrace) {
  const auto distances = [](const TestMesh& sphere, std::size_t triangles) {
    const TestMesh left = coarse(sphere, triangles);
    EXPECT_GE(left.indices.size() / 3, triangles - 2);
    return distance(sphere, left) * static_cast<double>(triangles);
  };
  const TestMesh large = testing::sphere(200, 100);
  const double want = distances(testing::sphere(80, 40), 1000);
  for (const std::size_t triangles : {16000, 8000, 4000, 2000, 1000}) {
    EXPECT_LT(distances(large, triangles), 1.25 * want) << triangles;
  }
}

/// A plate that is flat at one end alone: its piece there comes down to nearly nothing long before the others.
TEST(QuadricCollapse, PiecesMayVanish) {
  TestMesh plate = testing::grid(160, 160);
  for (glm::vec3& p : plate.positions) {
    if (p.x > 40) p.z += 0.1f * std::sin(7 * p.x) * std::cos(5 * p.y);
  }
  const TestMesh left = coarse(plate, 30000);
  EXPECT_LE(left.indices.size() / 3, 30000u);
  EXPECT_LT(distance(plate, left), 0.05);
}

/// A point of 4,000 triangles is looked at when it has fewer.
TEST(QuadricCollapse, AHubIsNoTrap) {
  TestMesh disc;
  constexpr std::uint32_t around = 4000;
  disc.positions.push_back(glm::vec3(0));
  for (std::uint32_t i = 0; i < around; ++i) {
    const double angle = 6.283185307179586 * i / around;
    disc.positions.push_back(glm::vec3(std::cos(angle), std::sin(angle), 0));
    disc.indices.insert(disc.indices.end(), {0, i + 1, (i + 1) % around + 1});
  }
  const TestMesh left = coarse(disc, 100);
  EXPECT_LE(left.indices.size() / 3, 100u);
  EXPECT_LT(distance(disc, left), 0.01);
}

TEST(QuadricCollapse, StopsWhereItIsToldTo) {
  const TestMesh torus = testing::torus(32, 16);
  const CollapseSequence sequence = quadric_collapse(torus.positions, torus.indices, {.least = 500});
  const Replay run = replay(sequence, torus.positions, torus.indices);
  EXPECT_LE(run.triangles.back(), 500u);
  EXPECT_GE(run.triangles.back(), 498u);
  const std::atomic<bool> cancel = true;
  EXPECT_TRUE(quadric_collapse(torus.positions, torus.indices, {.cancel = &cancel}).collapses.empty());
}

}  // namespace
}  // namespace foredraw::quadric_collapse_test

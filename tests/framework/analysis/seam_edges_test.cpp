#include <foredraw/analysis/seam_edges.h>

#include <foredraw/base/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <tuple>

namespace foredraw::seam_edges_test {
namespace {

/// Triangles with three vertices each.
struct Corners {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec2> uvs;
  std::vector<std::uint32_t> indices;

  void add(std::array<glm::vec3, 3> p, std::array<glm::vec2, 3> uv) {
    for (int c = 0; c < 3; ++c) {
      indices.push_back(static_cast<std::uint32_t>(positions.size()));
      positions.push_back(p[c]);
      uvs.push_back(uv[c]);
    }
  }
  SeamEdges found() const { return seam_edges(std::array{UvMesh{positions, uvs, indices}}); }
};

constexpr glm::vec3 a{0, 0, 0}, b{1, 0, 0}, c{1, 1, 0}, d{0, 1, 0}, e{2, 0, 0};
constexpr glm::vec2 ua{.1f, .1f}, ub{.2f, .1f}, uc{.2f, .2f}, ud{.1f, .2f}, ue{.3f, .1f};
constexpr glm::vec2 away{.5f, .5f};

TEST(SeamEdges, OfOneChartAreNone) {
  Corners mesh;
  mesh.add({a, b, c}, {ua, ub, uc});
  mesh.add({a, c, d}, {ua, uc, ud});
  const SeamEdges found = mesh.found();
  EXPECT_EQ(found.seams, 0u);
  EXPECT_EQ(found.edges.size(), 4u) << "its border";
  EXPECT_TRUE(found.corners.empty());
}

TEST(SeamEdges, AreThoseWhoseSidesDifferAndNotThoseBetweenVerticesOfSeveralUvs) {
  Corners mesh;
  mesh.add({a, b, c}, {ua, ub, uc});
  mesh.add({a, c, d}, {ua, uc, ud});                                   // ac is inside of a chart,
  mesh.add({b, a, e}, {ub + away, ua + away, ue + away});              // though a is cut here,
  mesh.add({c, b, e}, {uc + away, ub + 2.f * away, ue + 2.f * away});  // and c here
  const SeamEdges found = mesh.found();
  EXPECT_EQ(found.seams, 3u);
  for (const SharedEdge& edge : found.edges) {
    EXPECT_NE(edge.points, (std::array<std::uint32_t, 2>{0, 2})) << "ac";
  }
  EXPECT_EQ(found.corners.size(), 4u) << "a, b, c and e";
}

TEST(SeamEdges, SidesEndInTheSameSequence) {
  Corners mesh;
  mesh.add({a, b, c}, {ua, ub, uc});
  mesh.add({a, b, d}, {ua + away, ub + away, ud});  // not turned as a neighbour is
  mesh.add({d, c, b}, {ud, uc + away, ub + away});
  const SeamEdges found = mesh.found();
  ASSERT_EQ(found.seams, 2u);
  for (const SharedEdge& edge : found.edges) {
    if (edge.kind != EdgeKind::seam) continue;
    for (const EdgeSide& side : found.sides_of(edge)) {
      const std::uint32_t* v = &mesh.indices[3 * side.triangle];
      std::array ends{v[side.corner], v[(side.corner + 1) % 3]};
      if (side.is_reversed) std::swap(ends[0], ends[1]);
      for (int i = 0; i < 2; ++i) {
        EXPECT_EQ(mesh.positions[ends[i]], mesh.positions[edge.points[i]]);
        EXPECT_EQ(mesh.uvs[ends[i]], side.uv[i]);
      }
    }
  }
}

TEST(SeamEdges, OfThreeFacesKeepAllSides) {
  Corners mesh;
  mesh.add({a, b, c}, {ua, ub, uc});
  mesh.add({b, a, d}, {ub, ua, ud});
  EXPECT_EQ(mesh.found().seams, 0u);
  mesh.add({a, b, e}, {ua, ub + away, ue});
  const SeamEdges found = mesh.found();
  EXPECT_EQ(found.of_many_faces, 1u);
  ASSERT_EQ(found.seams, 1u);
  EXPECT_EQ(std::ranges::find(found.edges, EdgeKind::seam, &SharedEdge::kind)->side_count, 3u);
}

TEST(SeamEdges, LieBetweenDrawsToo) {
  Corners one, other;
  one.add({a, b, c}, {ua, ub, uc});
  other.add({c, b, e}, {uc + away, ub + away, ue});
  const SeamEdges found = seam_edges(
      std::array{UvMesh{one.positions, one.uvs, one.indices}, UvMesh{other.positions, other.uvs, other.indices}});
  ASSERT_EQ(found.seams, 1u);
  const auto edge = std::ranges::find(found.edges, EdgeKind::seam, &SharedEdge::kind);
  EXPECT_EQ(found.sides_of(*edge)[0].mesh, 0u);
  EXPECT_EQ(found.sides_of(*edge)[1].mesh, 1u);
}

TEST(SeamEdges, CornersAreOfPartsThatOnlyTouchToo) {
  Corners mesh;
  mesh.add({a, b, c}, {ua, ub, uc});
  mesh.add({a, d, glm::vec3(-1, 0, 0)}, {ua + away, ud, ue});
  const SeamEdges found = mesh.found();
  EXPECT_EQ(found.seams, 0u);
  ASSERT_EQ(found.corners.size(), 1u);
  EXPECT_EQ(found.uvs_of(found.corners[0])[0], ua);
  EXPECT_EQ(found.uvs_of(found.corners[0])[1], ua + away);
}

TEST(SeamEdges, LeaveOutWhatIsNoTriangleOrNoNumber) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  Corners mesh;
  mesh.add({a, b, c}, {ua, ub, uc});
  mesh.add({a, a, c}, {ua + away, ua, uc + away});
  mesh.add({a, c, d}, {ua, glm::vec2(nan, 0), ud});
  mesh.add({a, c, glm::vec3(infinity, 0, 0)}, {ua + away, uc, ud});
  const SeamEdges found = mesh.found();
  EXPECT_EQ(found.left_out, 3u);
  EXPECT_EQ(found.seams, 0u);
  EXPECT_EQ(found.edges.size(), 3u);
  EXPECT_TRUE(seam_edges({}).edges.empty());
}

TEST(SeamEdges, ZeroesAreOnePointAndOneUv) {
  Corners mesh;
  mesh.add({a, b, c}, {glm::vec2(0), ub, uc});
  mesh.add({glm::vec3(-0.f, 0, -0.f), c, d}, {glm::vec2(-0.f, 0), uc, ud});
  EXPECT_EQ(mesh.found().seams, 0u);
  EXPECT_TRUE(mesh.found().corners.empty());
}

TEST(SeamEdges, OfAPointWithVeryManyUvsAreFoundInTime) {
  Corners mesh;
  for (int i = 0; i < 200'000; ++i) {
    const auto x = static_cast<float>(i);
    mesh.add({a, glm::vec3(x, 1, 0), glm::vec3(x + 1, 1, 0)},
             {glm::vec2(x, 0), glm::vec2(x, 1), glm::vec2(x + .5f, 1)});
  }
  EXPECT_EQ(mesh.found().seams, 199'999u);
  EXPECT_EQ(mesh.found().corners.front().uv_count, 200'000u);
}

/// Whatever the sequence of triangles and of their corners.
TEST(SeamEdges, HangOnTheSurfaceAlone) {
  Random random(5);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<glm::vec3> points;
  for (int i = 0; i < 40; ++i) points.emplace_back(random.unit(), random.unit(), random.unit());
  for (int i = 0; i < 300; ++i) {
    triangles.push_back({static_cast<std::uint32_t>(random.below(40)), static_cast<std::uint32_t>(random.below(40)),
                         static_cast<std::uint32_t>(random.below(40))});
  }
  using Side = std::array<float, 10>;
  const auto sides_of = [&](bool is_turned) {
    Corners mesh;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const auto t = triangles[is_turned ? triangles.size() - 1 - i : i];
      std::array<glm::vec3, 3> p;
      std::array<glm::vec2, 3> uv;
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t v = t[is_turned ? 2 - k : k];
        p[k] = points[v];
        uv[k] = {static_cast<float>(v), static_cast<float>((t[0] + t[1] + t[2]) % 2)};
      }
      mesh.add(p, uv);
    }
    std::multiset<Side> sides;
    const SeamEdges found = mesh.found();
    for (const SharedEdge& edge : found.edges) {
      for (const EdgeSide& side : found.sides_of(edge)) {
        std::array ends{0, 1};
        const auto key = [&](int i) { return mesh.positions[edge.points[i]].x; };
        if (key(1) < key(0)) std::swap(ends[0], ends[1]);
        Side one{};
        for (int i = 0; i < 2; ++i) {
          const glm::vec3 p = mesh.positions[edge.points[ends[i]]];
          std::ranges::copy(std::array{p.x, p.y, p.z, side.uv[ends[i]].x, side.uv[ends[i]].y}, one.begin() + 5 * i);
        }
        sides.insert(one);
      }
    }
    return sides;
  };
  EXPECT_FALSE(sides_of(false).empty());
  EXPECT_EQ(sides_of(false), sides_of(true));
}

}  // namespace
}  // namespace foredraw::seam_edges_test

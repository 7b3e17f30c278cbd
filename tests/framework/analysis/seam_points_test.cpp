#include <foredraw/analysis/seam_points.h>

#include <foredraw/base/random.h>

#include <gtest/gtest.h>

#include <array>
#include <bit>

namespace foredraw::seam_points_test {
namespace {

/// Two triangles that meet in the edge from (0, 0, 0) to (1, 0, 0), with uvs of their own.
SeamEdges one_seam(std::array<glm::vec2, 2> here, std::array<glm::vec2, 2> there) {
  static const std::vector<glm::vec3> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0, -1, 0}};
  static const std::vector<std::uint32_t> indices{0, 1, 2, 4, 3, 5};
  const std::vector<glm::vec2> uvs{here[0], here[1], {.5f, .5f}, there[0], there[1], {.5f, .5f}};
  return seam_edges(std::array{UvMesh{positions, uvs, indices}});
}

std::uint32_t factor_of(float here, float there, std::uint32_t size) {
  const SeamEdges seams = one_seam({glm::vec2{0, 0}, {here, 0}}, {glm::vec2{0, .75f}, {0, .75f + there}});
  const auto factors = seam_factors(seams, {size, size});
  std::uint32_t factor = 0;
  for (std::size_t e = 0; e < factors.size(); ++e) {
    if (seams.edges[e].kind == EdgeKind::border) {
      EXPECT_EQ(factors[e], 0u);
    }
    factor += factors[e];
  }
  return factor;
}

TEST(SeamFactors, KeepPointsOneAndAHalfTexelsApartOnTheShorterSide) {
  EXPECT_EQ(factor_of(96.f / 512, .2f, 512), 64u);
  EXPECT_EQ(factor_of(95.f / 512, .2f, 512), 32u);
  EXPECT_EQ(factor_of(.2f, 6.f / 512, 512), 4u);
  EXPECT_EQ(factor_of(.2f, 5.f / 512, 512), 2u);
  EXPECT_EQ(factor_of(.2f, 2.f / 512, 512), 1u);
  EXPECT_EQ(factor_of(.2f, 0, 512), 1u) << "no length at all";
  EXPECT_EQ(factor_of(1e30f, 1e30f, 512), 64u);
}

TEST(SeamPoints, LieWhereAShaderPutsThem) {
  const SeamEdges seams = one_seam({glm::vec2{.1f, .2f}, {.37f, .41f}}, {glm::vec2{.9f, .8f}, {.55f, .83f}});
  const foredraw_height_map map{nullptr, 1000, 700, {0, 0}, 0};
  const std::vector<std::uint32_t> factors = seam_factors(seams, {1000, 700});
  const SeamPoints points = seam_points(seams, factors, map);
  ASSERT_EQ(points.points.size(), 2 + 63u) << "two corners, and the edge";
  std::size_t edges = 0;
  for (const SeamPoint& point : points.points) {
    if (point.edge == SeamPoint::no_edge) continue;
    const auto sides = seams.sides_of(seams.edges[point.edge]);
    for (std::size_t s = 0; s < sides.size(); ++s) {
      const float t = static_cast<float>(point.step) / 64;
      const float barycentric[3] = {1 - t, t, 0};
      std::uint32_t weights[3];
      foredraw_height_weights(barycentric, weights);
      std::int32_t x[3] = {foredraw_height_place(sides[s].uv[0].x, 1000),
                           foredraw_height_place(sides[s].uv[1].x, 1000)};
      std::int32_t y[3] = {foredraw_height_place(sides[s].uv[0].y, 700), foredraw_height_place(sides[s].uv[1].y, 700)};
      EXPECT_EQ(points.places_of(point)[s],
                glm::ivec2(foredraw_height_between(x, weights), foredraw_height_between(y, weights)));
    }
    ++edges;
  }
  EXPECT_EQ(edges, 63u);
}

/// By trying every factor on every edge.
TEST(ExactFactors, AreTheLargestThatHold) {
  const SeamEdges seams = one_seam({glm::vec2{0, 0}, {1, 0}}, {glm::vec2{0, 1}, {1, 1}});
  const foredraw_height_map map{nullptr, 256, 256, {2, 2}, 0};
  const std::vector<std::uint32_t> rule = seam_factors(seams, {256, 256});
  const SeamPoints points = seam_points(seams, rule, map);
  Random random(3);
  std::array<int, 8> seen{};
  for (int trial = 0; trial < 500; ++trial) {
    std::vector<bool> is_unequal(points.points.size(), false);
    for (std::size_t i = 0, n = random.below(3); i < n; ++i) {
      const auto step = (std::size_t{1} << random.below(6)) * (1 + random.below(3));
      if (step < 64) is_unequal[1 + step] = true;
    }
    if (trial % 20 == 0) is_unequal[trial / 20 % 2] = true;
    std::uint32_t wanted = 0;
    for (std::uint32_t factor = 1; factor <= 64 && !is_unequal[0] && !is_unequal[1]; factor *= 2) {
      bool holds = true;
      for (std::uint32_t k = 1; k < factor; ++k) holds = holds && !is_unequal[1 + k * (64 / factor)];
      if (holds) wanted = factor;
    }
    const auto factors = exact_factors(seams, points, is_unequal);
    for (std::size_t e = 0; e < factors.size(); ++e) {
      if (seams.edges[e].kind == EdgeKind::seam) {
        EXPECT_EQ(factors[e], wanted);
      }
    }
    ++seen[static_cast<std::size_t>(std::countr_zero(wanted | 128))];
  }
  for (const int times : seen) EXPECT_GT(times, 0) << "every answer was asked for";
}

}  // namespace
}  // namespace foredraw::seam_points_test

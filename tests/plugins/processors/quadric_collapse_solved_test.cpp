// What vertices carry where they come to lie: solved for, as level_vertices() writes it.

#include "support/simplified.h"

#include <limits>

namespace foredraw::quadric_collapse_solved_test {
namespace {

using testing::floats2;
using testing::floats3;
using testing::Simplified;
using testing::simplified;
using testing::stream;
using testing::TestMesh;
using testing::values;

/// A flat sheet whose points do not lie in rows.
TestMesh uneven_sheet() {
  TestMesh sheet = testing::grid(40, 40);
  Random random(3);
  for (glm::vec3& p : sheet.positions) {
    const auto moved = [&](float x) {
      const float by = static_cast<float>(random.unit() - 0.5) * 0.6f;
      return x > 0 && x < 40 ? x + by : x;
    };
    p.x = moved(p.x);
    p.y = moved(p.y);
  }
  return sheet;
}

constexpr AttributeWeights blind{0, 0, 0, 0, 0};

double worst_texcoord(const CutDraw& draw) {
  const std::vector<glm::vec3> places = values(draw, "POSITION"), uvs = values(draw, "TEXCOORD_0");
  double worst = 0;
  for (std::size_t v = 0; v < places.size(); ++v) {
    worst =
        std::max({worst, std::abs(uvs[v].x - (0.25 + places[v].x / 80.0)), std::abs(uvs[v].y - places[v].y / 50.0)});
  }
  return worst;
}

TEST(QuadricCollapseSolved, ATextureThatIsLinearOnAPlaneStaysSo) {
  const TestMesh sheet = uneven_sheet();
  const auto uv = stream("TEXCOORD_0", floats2, sheet, [&](std::uint32_t v) {
    return glm::vec2(0.25f + sheet.positions[v].x / 80, sheet.positions[v].y / 50);
  });
  for (const AttributeWeights& weights : {AttributeWeights{}, blind}) {
    const Simplified made = simplified(sheet, {uv}, weights);
    ASSERT_TRUE(made.sequence.solves);
    for (const std::size_t triangles : {3000, 1600, 800, 200, 40, 8}) {
      EXPECT_LT(worst_texcoord(made.at_triangles(triangles)), 2e-6) << triangles;
    }
  }
  EXPECT_GT(worst_texcoord(simplified(sheet, {uv}, blind, {.solves = false}).at_triangles(200)), 1e-3)
      << "blended along the edge, what lies beside it slides";
}

/// Half a step of a byte is what it takes to store it.
TEST(QuadricCollapseSolved, ARampOfColoursStaysOne) {
  const TestMesh sheet = uneven_sheet();
  const auto ramp = stream("COLOR_0", testing::unit_bytes4, sheet, [&](std::uint32_t v) {
    const float x = sheet.positions[v].x / 40;
    return glm::vec4(x, 1 - x, 0, 1);
  });
  const Simplified made = simplified(sheet, {ramp});
  for (const std::size_t triangles : {1600, 200, 20}) {
    const CutDraw left = made.at_triangles(triangles);
    const std::vector<glm::vec3> places = values(left, "POSITION"), colours = values(left, "COLOR_0");
    for (std::size_t v = 0; v < places.size(); ++v) {
      EXPECT_NEAR(colours[v].x, places[v].x / 40, 2.0 / 255) << triangles;
      EXPECT_NEAR(colours[v].y, 1 - places[v].x / 40, 2.0 / 255) << triangles;
      EXPECT_EQ(colours[v].z, 0);
      EXPECT_EQ(decode_component(*left.vertices->find("COLOR_0"), v, 3), 1);
    }
  }
}

TEST(QuadricCollapseSolved, NormalsOfASphereImprove) {
  const TestMesh ball = testing::sphere(96, 64);
  const auto normals =
      stream("NORMAL", floats3, ball, [&](std::uint32_t v) { return glm::normalize(ball.positions[v]); });
  const auto normal_at = [](glm::vec3 place) { return glm::normalize(place); };
  const Simplified solved = simplified(ball, {normals});
  const Simplified blended = simplified(ball, {normals}, {}, {.solves = false});
  for (const std::size_t triangles : {3000, 1200, 400}) {
    const CutDraw left = solved.at_triangles(triangles);
    for (const glm::vec3& normal : values(left, "NORMAL")) EXPECT_NEAR(glm::length(normal), 1, 1e-5);
    const double of_blended = testing::normal_error(blended.at_triangles(triangles), normal_at);
    EXPECT_LT(testing::normal_error(left, normal_at), 0.8 * of_blended) << triangles;
  }
}

/// A torus that is cut open: along each cut points have vertices with texture coordinates of 0 and of 1.
TEST(QuadricCollapseSolved, SeamsStayShutAndKeepTheirSides) {
  constexpr std::uint32_t around = 80, sides = 40;
  const TestMesh torus = testing::cut_open_torus(around, sides);
  const auto uv = stream("TEXCOORD_0", floats2, torus,
                         [](std::uint32_t v) { return testing::texcoord_on_torus(v, around, sides); });
  const Simplified made = simplified(torus, {uv});
  for (const std::size_t triangles : {3200, 1000, 400}) {
    const CutDraw left = made.at_triangles(triangles);
    const TestMesh coarse = testing::mesh_of(left);
    EXPECT_EQ(testing::edges(coarse).size(), 1u) << "a hole";
    EXPECT_EQ(testing::edges(coarse).begin()->first, 2);
    EXPECT_LT(testing::widest_texcoords(left), 0.7f) << "a corner from across a seam";
    for (const glm::vec3& uv_of_one : values(left, "TEXCOORD_0")) {
      EXPECT_GE(std::min(uv_of_one.x, uv_of_one.y), 0);
      EXPECT_LE(std::max(uv_of_one.x, uv_of_one.y), 1);
    }
  }
}

/// What is no number stays where it was, and none is made of it.
TEST(QuadricCollapseSolved, WhatIsNoNumberDoesNotSpread) {
  const TestMesh sheet = uneven_sheet();
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  const auto is_odd = [](std::uint32_t v) { return v % 97 == 0; };
  const auto uv = stream("TEXCOORD_0", floats2, sheet, [&](std::uint32_t v) {
    return is_odd(v) ? glm::vec2(nan, infinity) : glm::vec2(sheet.positions[v] / 40.0f);
  });
  const auto normals = stream("NORMAL", floats3, sheet, [&](std::uint32_t v) {
    return is_odd(v) ? glm::vec3(v % 2 == 0 ? nan : 0.0f) : glm::vec3(0, 0, 1);
  });
  const Simplified made = simplified(sheet, {uv, normals});
  for (const std::size_t triangles : {1600, 400, 50}) {
    const CutDraw left = made.at_triangles(triangles);
    const auto count = [&](std::string_view semantic) {
      return std::ranges::count_if(values(left, semantic),
                                   [](const glm::vec3& v) { return !std::isfinite(v.x + v.y + v.z); });
    };
    EXPECT_LE(count("TEXCOORD_0"), 18);
    EXPECT_LE(count("NORMAL"), 18);
    for (const glm::vec3& at : values(left, "TEXCOORD_0")) {
      if (std::isfinite(at.x + at.y)) EXPECT_LE(std::max(std::abs(at.x), std::abs(at.y)), 1);
    }
  }
}

TEST(QuadricCollapseSolved, EndpointsAreExact) {
  const TestMesh ball = testing::sphere(32, 24);
  const auto normals =
      stream("NORMAL", floats3, ball, [&](std::uint32_t v) { return glm::normalize(ball.positions[v]); });
  const Simplified made = simplified(ball, {normals}, {}, {.placement = CollapsePlacement::endpoint});
  EXPECT_FALSE(made.sequence.solves);
  EXPECT_TRUE(leaves_vertices(made.sequence, made.mesh));
  const CutDraw left = made.at_triangles(300);
  const auto places = values(left, "POSITION"), are = values(left, "NORMAL"), were = decode_vec3(normals);
  for (std::size_t v = 0; v < places.size(); ++v) {
    EXPECT_EQ(places[v], ball.positions[left.origin[v]]);
    EXPECT_EQ(are[v], were[left.origin[v]]);
  }
}

}  // namespace
}  // namespace foredraw::quadric_collapse_solved_test

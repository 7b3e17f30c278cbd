#include <foredraw/collapses/alike_vertices.h>
#include <foredraw/collapses/attribute_rows.h>

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace foredraw::attribute_rows_test {
namespace {

constexpr AttributeWeights nothing{.normals = 0, .texcoords = 0, .colors = 0, .joints = 0, .targets = 0};

/// A square of 3 by 4, whose diagonal is 5.
JoinedMesh square(const std::vector<VertexStream>& more, std::vector<std::vector<VertexStream>> targets = {},
                  float scale = 1) {
  testing::TestMesh mesh{{{0, 0, 0}, {3, 0, 0}, {3, 4, 0}, {0, 4, 0}}, {0, 1, 2, 0, 2, 3}};
  for (glm::vec3& position : mesh.positions) position *= scale;
  Draw draw = testing::draw_of(mesh);
  auto vertices = std::make_shared<VertexStreams>(*draw.levels[0].vertices);
  vertices->base.insert(vertices->base.end(), more.begin(), more.end());
  vertices->morph_targets = std::move(targets);
  draw.levels[0].vertices = vertices;
  Analyses analyses;
  const DrawId first[] = {0};
  return joined_mesh(testing::scene_of({draw}), first, analyses).value();
}

VertexStream floats(std::string semantic, std::uint8_t components, const std::vector<float>& values) {
  const auto bytes = std::as_bytes(std::span(values));
  return {std::move(semantic),
          {Component::float32, components, false, static_cast<std::uint16_t>(4 * components)},
          Shared<std::byte>(std::vector<std::byte>(bytes.begin(), bytes.end()))};
}

double squared_difference(const AttributeRows& rows, std::uint32_t a, std::uint32_t b) {
  double sum = 0;
  for (std::size_t i = 0; i < rows.width; ++i) sum += std::pow(double{rows.of(a)[i]} - rows.of(b)[i], 2);
  return sum;
}

TEST(AttributeRows, CountWhatHasAWeight) {
  const JoinedMesh mesh =
      square({floats("NORMAL", 3, std::vector<float>(12, 1)), floats("TEXCOORD_0", 2, std::vector<float>(8, 1)),
              floats("COLOR_0", 4, std::vector<float>(16, 1))});
  const auto width = [&](AttributeWeights weights) { return attribute_rows(mesh, weights).width; };
  EXPECT_EQ(width(nothing), 0u);
  AttributeWeights some = nothing;
  some.normals = 1;
  EXPECT_EQ(width(some), 3u);
  some.colors = 1;
  EXPECT_EQ(width(some), 7u);
  some.texcoords = some.joints = some.targets = 1;
  EXPECT_EQ(width(some), 9u) << "it has neither joints nor targets";
}

TEST(AttributeRows, ADifferenceIsALength) {
  AttributeWeights weights = nothing;
  weights.normals = 0.5;
  const AttributeRows normals =
      attribute_rows(square({floats("NORMAL", 3, {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0})}), weights);
  EXPECT_NEAR(squared_difference(normals, 0, 1), 2 * 2.5 * 2.5, 1e-5) << "half a diagonal";
  EXPECT_EQ(squared_difference(normals, 0, 3), 0);
  weights = nothing;
  weights.texcoords = 0.5;
  // A texture of which the square shows a quarter: one unit of it is 6 by 8.
  const AttributeRows texcoords =
      attribute_rows(square({floats("TEXCOORD_0", 2, {0, 0, 0.5f, 0, 0.5f, 0.5f, 0, 0.5f})}), weights);
  EXPECT_NEAR(squared_difference(texcoords, 0, 1), 0.25 * 12, 1e-4) << "half of 3 or 4, in the mean of areas";
}

TEST(AttributeRows, JointsKeepSquaredDistancesInTheMean) {
  AttributeWeights weights = nothing;
  weights.joints = 1;
  double sum = 0;
  constexpr int pairs = 200;
  for (int joint = 0; joint < pairs; ++joint) {
    const float first = static_cast<float>(2 * joint), second = first + 1;
    const JoinedMesh mesh =
        square({floats("JOINTS_0", 4, {first, 0, 0, 0, second, 0, 0, 0, first, 0, 0, 0, first, second, 0, 0}),
                floats("WEIGHTS_0", 4, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0})});
    const AttributeRows rows = attribute_rows(mesh, weights);
    sum += squared_difference(rows, 0, 1);
    EXPECT_EQ(squared_difference(rows, 0, 2), 0);
    EXPECT_NEAR(squared_difference(rows, 0, 3), squared_difference(rows, 0, 1) / 4, 1e-3);
  }
  EXPECT_NEAR(sum / pairs, 2 * 25, 5);
}

TEST(AttributeRows, TargetsCountAsFarAsTheyMove) {
  AttributeWeights weights = nothing;
  weights.targets = 2;
  const AttributeRows rows =
      attribute_rows(square({}, {{floats("POSITION", 3, {0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 3, 0})}}), weights);
  EXPECT_NEAR(squared_difference(rows, 0, 1), 4, 1e-5);
  EXPECT_NEAR(squared_difference(rows, 0, 3), 36, 1e-4);
}

TEST(AttributeRows, AreFinite) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  const AttributeRows rows = attribute_rows(
      square({floats("NORMAL", 3, {nan, infinity, 1e38f, 0, 0, 0, -1e38f, 0, 0, 0, 0, 0}),
              floats("TEXCOORD_0", 2, {nan, 0, 1e38f, 0, 0, 0, 0, infinity}),
              floats("COLOR_0", 3, std::vector<float>(12, infinity)),
              floats("JOINTS_0", 4, {nan, -1, infinity, 1e20f, 1, 2, 3, 4, 1, 2, 3, 4, 0, 0, 0, 0}),
              floats("WEIGHTS_0", 4, {1, nan, infinity, 3e38f, 3e38f, 3e38f, -3e38f, 3e38f, 1, 0, 0, 0, 0, 0, 0, 0})},
             {{floats("POSITION", 3, {1e6f, nan, infinity, 3e38f, 3e38f, -3e38f, 0, 0, 0, 0, 0, 0})},
              {floats("POSITION", 3, {1e6f, 0, 0, 3e38f, 3e38f, 3e38f, 0, 0, 0, 0, 0, 0})}}),
      {});
  EXPECT_EQ(rows.width, 9u + 6 + 6);
  for (const float value : rows.values) EXPECT_LT(std::abs(value), 1e8f);
}

/// Where a million diagonals are more than a float holds.
TEST(AttributeRows, AreFiniteInMeshesOfAnySize) {
  const AttributeRows rows =
      attribute_rows(square({floats("NORMAL", 3, {3e38f, 0, 0, -3e38f, 0, 0, 0, 0, 1, 0, 0, 1})}, {}, 1e35f), {});
  EXPECT_TRUE(std::isfinite(rows.of(0)[0] - rows.of(1)[0]));
  EXPECT_LT(rows.of(1)[0], 0);
}

/// So that no two vertices seem alike that a pose tears apart.
TEST(AttributeRows, TargetsMayMoveFar) {
  AttributeWeights weights = nothing;
  weights.targets = 0.1;
  const AttributeRows rows =
      attribute_rows(square({}, {{floats("POSITION", 3, {0, 0, 0, 0, 0, 1e6f, 0, 0, 0, 0, -1e6f, 0})}}), weights);
  EXPECT_NEAR(std::sqrt(squared_difference(rows, 0, 1)), 1e5, 1);
  EXPECT_NEAR(std::sqrt(squared_difference(rows, 1, 3)), std::sqrt(2.0) * 1e5, 1);
}

/// Draws of one mesh need not carry the same.
TEST(AttributeRows, WhatADrawLacksIsZero) {
  Draw one = testing::draw_of(testing::grid(2, 2)), two = testing::draw_of(testing::grid(2, 2));
  auto vertices = std::make_shared<VertexStreams>(*one.levels[0].vertices);
  vertices->base.push_back(floats("COLOR_0", 3, std::vector<float>(27, 1)));
  one.levels[0].vertices = vertices;
  Analyses analyses;
  const DrawId both[] = {0, 1};
  const JoinedMesh mesh = joined_mesh(testing::scene_of({one, two}), both, analyses).value();
  AttributeWeights weights = nothing;
  weights.colors = 1;
  const AttributeRows rows = attribute_rows(mesh, weights);
  ASSERT_EQ(rows.width, 4u);
  EXPECT_GT(rows.of(0)[0], 0);
  EXPECT_EQ(rows.of(9)[0], 0);
}

TEST(AttributeRows, ATextureOfOnePointIsNothing) {
  AttributeWeights weights = nothing;
  weights.texcoords = 1;
  for (const float at : {0.0f, 0.5f}) {
    const AttributeRows rows = attribute_rows(square({floats("TEXCOORD_0", 2, std::vector<float>(8, at))}), weights);
    EXPECT_EQ(rows.values, std::vector<float>(8, 0));
  }
}

/// Four vertices of one place.
TEST(AttributeRows, VerticesAreAlikeThatDifferInDirectionsAlone) {
  const std::vector<glm::vec3> at{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 4}};
  Draw draw = testing::draw_of({at, {0, 1, 4}});
  auto vertices = std::make_shared<VertexStreams>(*draw.levels[0].vertices);
  vertices->base.push_back(floats("NORMAL", 3, {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 1, 0, 0}));
  vertices->base.push_back(floats("TANGENT", 4, std::vector<float>(20, 1)));
  vertices->base.push_back(floats("_HEAT", 1, {5, 5, 5, 6, 5}));
  draw.levels[0].vertices = vertices;
  Analyses analyses;
  const DrawId first[] = {0};
  const JoinedMesh mesh = joined_mesh(testing::scene_of({draw}), first, analyses).value();
  const std::vector<std::uint32_t> alike{0, 0, 0, 3, 4};
  EXPECT_EQ(attribute_rows(mesh, {}).alike, alike) << "what no weight counts is a seam all the same";
  AttributeRows rows{.width = 4, .values = {}};
  for (std::size_t v = 0; v < at.size(); ++v) {
    for (const float number : {v == 3 ? 6.0f : 5.0f, v == 1 ? 1.0f : 0.0f, 1.0f, 0.0f}) rows.values.push_back(number);
  }
  EXPECT_TRUE(alike_vertices(rows, at).empty());
  rows.directions = {{1, 1}};
  EXPECT_EQ(alike_vertices(rows, at), alike);
}

/// Whole numbers to 65535 in a mesh that is small beside them.
TEST(AttributeRows, TexcoordsCountTheSameInAnyUnits) {
  AttributeWeights weights = nothing;
  weights.texcoords = 1;
  const auto rows = [&](float scale, float offset, float size) {
    std::vector<float> uvs{0, 0, 0.5f, 0, 0.5f, 0.25f, 0, 1};
    for (float& uv : uvs) uv = uv * scale + offset;
    return attribute_rows(square({floats("TEXCOORD_0", 2, uvs)}, {}, size), weights);
  };
  const AttributeRows plain = rows(1, 0, 0x1p-12f), whole = rows(0x1p16f, 4096, 0x1p-12f);
  for (std::uint32_t v = 1; v < 4; ++v) {
    EXPECT_GT(squared_difference(plain, 0, v), 0);
    EXPECT_NEAR(squared_difference(plain, 0, v) / squared_difference(whole, 0, v), 1, 1e-5) << v;
  }
}

}  // namespace
}  // namespace foredraw::attribute_rows_test

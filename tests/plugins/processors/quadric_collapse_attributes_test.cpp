#include "plugins/processors/quadric_collapse/quadric_collapse.h"

#include "support/collapses.h"

#include <foredraw/collapses/attribute_walk.h>

#include <gtest/gtest.h>

#include <cmath>

namespace foredraw::quadric_collapse_attributes_test {
namespace {

using testing::TestMesh;

/// One number of each vertex.
template <class Of>
AttributeRows rows_of(const TestMesh& mesh, const Of& of) {
  AttributeRows rows{1, {}};
  for (const glm::vec3& p : mesh.positions) rows.values.push_back(static_cast<float>(of(p)));
  return rows;
}

struct Carrying {
  TestMesh mesh;
  AttributeRows rows;
};

/// What is left of the mesh and of its rows where no more than so many vertices are used.
Carrying coarse(const TestMesh& mesh, const AttributeRows& rows, const AttributeRows& counted, std::size_t triangles) {
  const CollapseSequence sequence = quadric_collapse(mesh.positions, mesh.indices, {.least = triangles}, counted);
  Carrying left{testing::coarse(mesh, sequence, triangles), rows};
  AttributeWalk walk(sequence, mesh.positions, mesh.indices);
  for (const Collapse& collapse : sequence.collapses) {
    for (const JoinedVertex& joined : walk.next()) {
      float& kept = left.rows.values[joined.vertex];
      if (!joined.shares.empty()) {
        kept = static_cast<float>(shared_number(std::span<const WedgeShare>(joined.shares),
                                                [&](std::uint32_t v) { return double{left.rows.values[v]}; }));
      } else if (joined.stands_for_another()) {
        kept += (left.rows.values[joined.removed] - kept) * collapse.blend;
      }
    }
  }
  return left;
}

/// Of a mesh in the xy plane, at the points: the rms difference to `of`.
template <class Of>
double rms(const Carrying& flat, std::span<const glm::vec3> points, const Of& of) {
  const auto& [mesh, rows] = flat;
  double sum = 0;
  for (const glm::vec3& p : points) {
    double best = -1, value = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
      const auto corner = [&](std::size_t k) { return mesh.positions[mesh.indices[i + k]]; };
      const auto area = [](glm::vec3 a, glm::vec3 b, glm::vec3 c) {
        return double{b.x - a.x} * (c.y - a.y) - double{b.y - a.y} * (c.x - a.x);
      };
      const double whole = area(corner(0), corner(1), corner(2));
      if (!(whole > 0)) continue;
      const double a = area(p, corner(1), corner(2)) / whole, b = area(corner(0), p, corner(2)) / whole, c = 1 - a - b;
      if (std::min({a, b, c}) <= best) continue;
      best = std::min({a, b, c});
      value = a * rows.values[mesh.indices[i]] + b * rows.values[mesh.indices[i + 1]] +
              c * rows.values[mesh.indices[i + 2]];
    }
    sum += (value - of(p)) * (value - of(p));
  }
  return std::sqrt(sum / static_cast<double>(points.size()));
}

/// A picture on a plate, down to about 400 vertices of 40,000: a disc with a soft rim. Blind to it, any plate will do.
TEST(QuadricCollapseAttributes, APictureOnAPlateStays) {
  const TestMesh plate = testing::grid(199, 199);
  glm::vec3 most(0);
  for (const glm::vec3& p : plate.positions) most = glm::max(most, p);
  const auto disc = [&](const glm::vec3& p) {
    const double x = p.x / most.x - 0.5, y = p.y / most.y - 0.5, radius = std::sqrt(x * x + y * y);
    return most.x / (1 + std::pow(radius / 0.3, 16.0));
  };
  const AttributeRows rows = rows_of(plate, disc);
  const auto picture = [&](const AttributeRows& counted) {
    return rms(coarse(plate, rows, counted, 760), plate.positions, disc) / most.x;
  };
  const double counted = picture(rows), blind = picture({});
  EXPECT_LT(counted, 0.01);
  EXPECT_GT(blind, 10 * counted);
}

/// What is linear over a flat piece is kept by any of its triangulations, so it costs nothing.
TEST(QuadricCollapseAttributes, WhatIsLinearGoesForNothing) {
  const TestMesh plate = testing::grid(40, 40);
  const auto slope = [](const glm::vec3& p) { return 3 * p.x - p.y + 5; };
  const AttributeRows rows = rows_of(plate, slope);
  const Carrying left = coarse(plate, rows, rows, 2);
  EXPECT_LE(left.mesh.indices.size() / 3, 8u);
  EXPECT_LT(rms(left, plate.positions, slope), 1e-4 * slope({40, 0, 0}));
}

/// The same mesh, carrying a step across its middle: edges across the step are kept longest.
TEST(QuadricCollapseAttributes, AStepStaysWhereItIs) {
  const TestMesh plate = testing::grid(40, 40);
  glm::vec3 most(0);
  for (const glm::vec3& p : plate.positions) most = glm::max(most, p);
  const auto step = [&](const glm::vec3& p) { return p.x > most.x / 2 ? most.x : 0.0f; };
  const AttributeRows rows = rows_of(plate, step);
  const Carrying left = coarse(plate, rows, rows, 16);
  EXPECT_LE(left.mesh.indices.size() / 3, 16u);
  EXPECT_LT(rms(left, plate.positions, step) / most.x, 1e-3);
}

TEST(QuadricCollapseAttributes, SeamsAndOddMeshesRunWithThemToo) {
  std::vector<TestMesh> meshes = testing::odd_meshes();
  meshes.push_back(testing::box_of_sides(6));
  for (const TestMesh& mesh : meshes) {
    AttributeRows rows{3, {}};
    Random random(7);
    for (std::size_t i = 0; i < 3 * mesh.positions.size(); ++i) {
      rows.values.push_back(static_cast<float>(random.unit() - 0.5) * (i % 5 == 0 ? 1e30f : 1));
    }
    for (const CollapsePlacement placement : {CollapsePlacement::optimal, CollapsePlacement::endpoint}) {
      const CollapseSequence sequence = quadric_collapse(mesh.positions, mesh.indices, {.placement = placement}, rows);
      EXPECT_EQ(replay(sequence, mesh.positions, mesh.indices).mistake, "");
    }
  }
}

TEST(QuadricCollapseAttributes, DoNotDependOnWhoWorksOnWhichPieceWhen) {
  const TestMesh torus = testing::torus(150, 80);
  const AttributeRows rows = rows_of(torus, [](const glm::vec3& p) { return std::sin(5 * p.x) * std::cos(7 * p.y); });
  const CollapseSequence want = quadric_collapse(torus.positions, torus.indices, {}, rows);
  EXPECT_EQ(replay(want, torus.positions, torus.indices).mistake, "");
  const Executor backwards(2, [](std::size_t count, const std::function<void(std::size_t)>& task) {
    while (count > 0) task(--count);
  });
  const Executor two(2);
  for (const Executor* executor : {&two, &backwards}) {
    EXPECT_EQ(quadric_collapse(torus.positions, torus.indices, {.executor = executor}, rows), want);
  }
}

/// What is claimed is a distance: attributes do not add to it.
TEST(QuadricCollapseAttributes, ErrorsAreDistances) {
  const TestMesh torus = testing::closed_torus(40, 24);
  const AttributeRows rows =
      rows_of(torus, [](const glm::vec3& p) { return 10 * std::sin(5 * p.x) * std::cos(7 * p.y); });
  const CollapseSequence sequence = quadric_collapse(torus.positions, torus.indices, {.least = 600}, rows);
  const double farthest = testing::distance(torus, testing::coarse(torus, sequence, 600));
  EXPECT_LT(sequence.collapses.back().error, farthest);
  EXPECT_GT(sequence.collapses.back().error, farthest / 20);
}

}  // namespace
}  // namespace foredraw::quadric_collapse_attributes_test

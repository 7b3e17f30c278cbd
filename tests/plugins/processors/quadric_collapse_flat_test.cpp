// Meshes that are shaded flat: each face has vertices of its own, which differ in normals alone.

#include "support/simplified.h"

#include <foredraw/base/parallel.h>
#include <foredraw/collapses/alike_vertices.h>

#include <map>

namespace foredraw::quadric_collapse_flat_test {
namespace {

using testing::floats2;
using testing::floats3;
using testing::mesh_of;
using testing::normal_error;
using testing::Simplified;
using testing::simplified;
using testing::stream;
using testing::TestMesh;
using testing::values;

/// Each triangle with vertices of its own.
TestMesh flat(const TestMesh& mesh) {
  TestMesh apart;
  for (const std::uint32_t index : mesh.indices) {
    apart.indices.push_back(static_cast<std::uint32_t>(apart.positions.size()));
    apart.positions.push_back(mesh.positions[index]);
  }
  return apart;
}

VertexStream normals_of(const TestMesh& apart) {
  return stream("NORMAL", floats3, apart, [&](std::uint32_t v) {
    const glm::dvec3 a(apart.positions[v - v % 3]), b(apart.positions[v - v % 3 + 1]),
        c(apart.positions[v - v % 3 + 2]);
    return glm::vec3(glm::normalize(glm::cross(b - a, c - a)));
  });
}

/// Of the torus.
glm::vec3 normal_at(glm::vec3 place) {
  const glm::vec3 core = glm::normalize(glm::vec3(place.x, 0, place.z));
  return glm::normalize(place - core);
}

class FlatShaded : public ::testing::TestWithParam<CollapsePlacement> {
 protected:
  Simplified flat_simplified(const TestMesh& apart, std::vector<VertexStream> more = {}) const {
    more.push_back(normals_of(apart));
    return simplified(apart, more, {}, {.placement = GetParam()});
  }
};

/// Nearly as if it were shaded smoothly.
TEST_P(FlatShaded, ATorusBecomesCoarser) {
  const TestMesh torus = testing::closed_torus(60, 30), apart = flat(torus);
  const auto smooth = stream("NORMAL", floats3, torus, [&](std::uint32_t v) { return normal_at(torus.positions[v]); });
  const Simplified made = flat_simplified(apart), shared = simplified(torus, {smooth}, {}, {.placement = GetParam()});
  for (const std::size_t triangles : {1800, 720, 360}) {
    const CutDraw left = made.at_triangles(triangles);
    const TestMesh coarse = mesh_of(left);
    EXPECT_LE(coarse.indices.size() / 3, triangles);
    EXPECT_EQ(testing::euler(coarse), 0) << triangles;
    EXPECT_EQ(testing::edges(coarse).size(), 1u) << "a hole";
    const double of_shared = testing::distance(mesh_of(shared.at_triangles(triangles)), torus);
    EXPECT_LT(testing::distance(coarse, torus), 3 * of_shared) << triangles;
    EXPECT_LT(normal_error(left, normal_at), 5) << triangles;
  }
}

/// What lies on one side costs nothing; that normals come round a corner does.
TEST_P(FlatShaded, ABoxKeepsItsSides) {
  const TestMesh apart = flat(testing::box_of_sides(6));
  const CutDraw left = flat_simplified(apart).at_triangles(12);
  const TestMesh coarse = mesh_of(left);
  EXPECT_LT(testing::distance(coarse, apart), 1e-6);
  const std::vector<glm::vec3> normals = values(left, "NORMAL");
  for (std::size_t i = 0; i < coarse.indices.size(); i += 3) {
    const std::uint32_t* t = coarse.indices.data() + i;
    const glm::vec3 &a = coarse.positions[t[0]], &b = coarse.positions[t[1]], &c = coarse.positions[t[2]];
    const glm::vec3 up = glm::normalize(glm::cross(b - a, c - a));
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(glm::dot(normals[t[k]], up), 1, 1e-5);
  }
}

/// A torus that is cut open in its texture: corners stay on their side of each cut, and cuts stay where they were.
TEST_P(FlatShaded, TexturesKeepTheirSeams) {
  constexpr std::uint32_t around = 60, sides = 30;
  const TestMesh torus = testing::cut_open_torus(around, sides), apart = flat(torus);
  const auto uv = stream("TEXCOORD_0", floats2, apart,
                         [&](std::uint32_t v) { return testing::texcoord_on_torus(torus.indices[v], around, sides); });
  const Simplified made = flat_simplified(apart, {uv});
  for (const std::size_t triangles : {1800, 720}) {
    const CutDraw left = made.at_triangles(triangles);
    EXPECT_EQ(testing::edges(mesh_of(left)).size(), 1u) << "a hole";
    EXPECT_LT(testing::widest_texcoords(left), 0.7f) << "a corner from across a seam";
  }
}

/// Colours of faces are no directions: where they differ nothing jumps.
TEST_P(FlatShaded, FacesOfColoursOfTheirOwnStay) {
  const TestMesh apart = flat(testing::closed_torus(12, 8));
  const auto colours = stream("COLOR_0", testing::unit_bytes4, apart, [](std::uint32_t v) {
    return glm::vec4(static_cast<float>(v / 3) / 255, static_cast<float>(v / 3 % 7) / 7, 0, 1);
  });
  EXPECT_LT(flat_simplified(apart, {colours}).sequence.collapses.size(), 5u);
}

/// Where joints move vertices, those of a point stay together.
TEST_P(FlatShaded, PointsMoveAsOne) {
  const TestMesh apart = flat(testing::closed_torus(40, 20));
  const auto joints =
      stream("JOINTS_0", {Component::uint8, 4, false, 4}, apart, [](std::uint32_t) { return glm::vec4(0, 1, 0, 0); });
  const auto weights = stream("WEIGHTS_0", testing::floats4, apart, [&](std::uint32_t v) {
    const float one = 0.5f + 0.35f * apart.positions[v].x;
    return glm::vec4(one, 1 - one, 0, 0);
  });
  const Simplified made = flat_simplified(apart, {joints, weights});
  for (const std::size_t triangles : {800, 300}) {
    const CutDraw left = made.at_triangles(triangles);
    const std::vector<glm::vec3> places = values(left, "POSITION");
    std::map<std::array<float, 3>, float> weight_at;
    for (std::size_t v = 0; v < places.size(); ++v) {
      float weight = 0;
      for (std::size_t slot = 0; slot < 4; ++slot) {
        if (decode_component(*left.vertices->find("JOINTS_0"), v, slot) == 0) {
          weight += decode_component(*left.vertices->find("WEIGHTS_0"), v, slot);
        }
      }
      const auto [known, is_new] = weight_at.try_emplace({places[v].x, places[v].y, places[v].z}, weight);
      EXPECT_EQ(known->second, weight) << "a crack in a pose";
      EXPECT_NEAR(weight, 0.5f + 0.35f * places[v].x, 0.06f);
    }
  }
}

/// More than one piece.
TEST_P(FlatShaded, SequencesAreTheSameAtAnyNumberOfThreads) {
  const TestMesh apart = flat(testing::closed_torus(160, 80));
  const Simplified one = flat_simplified(apart);
  EXPECT_GT(one.sequence.collapses.size(), 12000u);
  const Executor executor(3);
  const CollapseSequence other =
      quadric_collapse(one.mesh.positions, one.mesh.indices, {.placement = GetParam(), .executor = &executor},
                       attribute_rows(one.mesh, {}));
  EXPECT_EQ(one.sequence, other);
}

INSTANTIATE_TEST_SUITE_P(Placements, FlatShaded,
                         ::testing::Values(CollapsePlacement::optimal, CollapsePlacement::endpoint),
                         [](const auto& one) {
                           return one.param == CollapsePlacement::optimal ? "Optimal" : "Endpoint";
                         });

TEST(FlatShadedAttributes, WithoutNormalsThatCountVerticesAreUnlike) {
  const TestMesh apart = flat(testing::closed_torus(12, 8));
  EXPECT_TRUE(quadric_collapse(apart.positions, apart.indices).collapses.empty());
}

}  // namespace
}  // namespace foredraw::quadric_collapse_flat_test

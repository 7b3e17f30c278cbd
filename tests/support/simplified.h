#pragma once
// Meshes whose vertices carry something, and what quadric-collapse makes of them.

#include "plugins/processors/quadric_collapse/quadric_collapse.h"
#include "support/collapses.h"

#include <foredraw/collapses/cut.h>
#include <foredraw/scene/encode_component.h>

#include <gtest/gtest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace foredraw::testing {

inline constexpr Format floats2{Component::float32, 2, false, 8}, floats3{}, floats4{Component::float32, 4, false, 16};
inline constexpr Format unit_bytes4{Component::uint8, 4, true, 4};

/// Numbers of each vertex in that format.
template <class Of>
VertexStream stream(std::string semantic, const Format& format, const TestMesh& mesh, const Of& of) {
  std::vector<std::byte> bytes(mesh.positions.size() * format.bytes);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const auto numbers = of(static_cast<std::uint32_t>(v));
    for (int c = 0; c < format.components; ++c) {
      encode_component(bytes.data() + v * format.bytes + c * bytes_of(format.component), format, numbers[c]);
    }
  }
  return {std::move(semantic), format, Shared<std::byte>(std::move(bytes))};
}

struct Simplified {
  JoinedMesh mesh;
  CollapseSequence sequence;

  CutDraw after(std::size_t collapses) const {
    return cut(sequence, collapses, collapsed(sequence, collapses, mesh), mesh).front();
  }
  CutDraw at_triangles(std::size_t triangles) const {
    const Replay run = replay(sequence, mesh.positions, mesh.indices, mesh.part);
    EXPECT_EQ(run.mistake, "");
    const auto reached = std::ranges::find_if(run.triangles, [&](std::uint32_t left) { return left <= triangles; });
    EXPECT_NE(reached, run.triangles.end());
    return after(static_cast<std::size_t>(reached - run.triangles.begin()));
  }
};

inline Simplified simplified(const TestMesh& mesh, std::vector<VertexStream> carried,
                             const AttributeWeights& weights = {}, const QuadricCollapseOptions& options = {}) {
  Draw draw = draw_of(mesh);
  auto vertices = std::make_shared<VertexStreams>(*draw.full().vertices);
  for (VertexStream& one : carried) vertices->base.push_back(std::move(one));
  draw.full().vertices = std::move(vertices);
  std::vector<Draw> draws;
  draws.push_back(std::move(draw));
  Analyses analyses;
  const std::vector<DrawId> all{0};
  Simplified made{joined_mesh(scene_of(std::move(draws)), all, analyses).value(), {}};
  made.sequence = quadric_collapse(made.mesh.positions, made.mesh.indices, options, attribute_rows(made.mesh, weights));
  return made;
}

inline std::vector<glm::vec3> values(const CutDraw& draw, std::string_view semantic) {
  return decode_vec3(*draw.vertices->find(semantic));
}

inline TestMesh mesh_of(const CutDraw& draw) {
  const auto indices = draw.indices.view();
  return {values(draw, "POSITION"), {indices.begin(), indices.end()}};
}

/// Root mean square angle, in degrees, between what triangles show in their middles and `normal_at` there.
template <class NormalAt>
double normal_error(const CutDraw& draw, const NormalAt& normal_at) {
  const TestMesh mesh = mesh_of(draw);
  const std::vector<glm::vec3> normals = values(draw, "NORMAL");
  double sum = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    glm::dvec3 place(0), normal(0);
    for (std::size_t k = 0; k < 3; ++k) {
      place += glm::dvec3(mesh.positions[mesh.indices[i + k]]) / 3.0;
      normal += glm::dvec3(normals[mesh.indices[i + k]]);
    }
    const double cosine = glm::dot(glm::dvec3(normal_at(glm::vec3(place))), glm::normalize(normal));
    sum += std::pow(std::acos(std::min(1.0, cosine)), 2);
  }
  return glm::degrees(std::sqrt(sum / (static_cast<double>(mesh.indices.size()) / 3)));
}

/// A torus that is cut open in both ways: points at the cuts have vertices on both sides, equal to the last bit. Rows
/// of `around` + 1 vertices, the last of which closes the row.
inline TestMesh cut_open_torus(std::uint32_t around, std::uint32_t sides) {
  TestMesh mesh = torus(around, sides);
  for (std::uint32_t y = 0; y <= sides; ++y) {
    for (std::uint32_t x = 0; x <= around; ++x) {
      mesh.positions[y * (around + 1) + x] = mesh.positions[y % sides * (around + 1) + x % around];
    }
  }
  return mesh;
}

/// Texture coordinates of that torus' vertices: 0 and 1 at the cuts.
inline glm::vec2 texcoord_on_torus(std::uint32_t vertex, std::uint32_t around, std::uint32_t sides) {
  const auto of = [](std::uint32_t row, std::uint32_t rows) {
    return static_cast<float>(row) / static_cast<float>(rows);
  };
  return {of(vertex % (around + 1), around), of(vertex / (around + 1), sides)};
}

/// The farthest that texture coordinates of one triangle lie apart, in u or v.
inline float widest_texcoords(const CutDraw& draw) {
  const std::vector<glm::vec3> uvs = values(draw, "TEXCOORD_0");
  const auto indices = draw.indices.view();
  float widest = 0;
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    const glm::vec3 a = uvs[indices[i]], b = uvs[indices[i + 1]], c = uvs[indices[i + 2]];
    const glm::vec3 extent = glm::max(glm::max(a, b), c) - glm::min(glm::min(a, b), c);
    widest = std::max({widest, extent.x, extent.y});
  }
  return widest;
}

}  // namespace foredraw::testing

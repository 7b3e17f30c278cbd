#pragma once
// Meshes whose vertices carry something, and what quadric-collapse makes of them.

#include "plugins/processors/quadric_collapse/quadric_collapse.h"
#include "support/collapses.h"

#include <foredraw/collapses/cut.h>
#include <foredraw/scene/encode_component.h>

#include <gtest/gtest.h>

namespace foredraw::testing {

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

}  // namespace foredraw::testing

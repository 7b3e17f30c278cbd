#pragma once
// A level of detail cut out of a sequence of collapses.

#include <foredraw/collapses/collapse_sequences.h>
#include <foredraw/collapses/joined_mesh.h>

namespace foredraw {

/// What one draw becomes.
struct CutDraw {
  std::shared_ptr<const VertexStreams> vertices;
  Shared<std::uint32_t> indices;
};

/// The draws of the mesh, in its sequence, after `collapses` of a clean sequence. Draws that shared vertices still do.
std::vector<CutDraw> cut(const CollapseSequence& sequence, std::size_t collapses, const JoinedMesh& mesh);

}  // namespace foredraw

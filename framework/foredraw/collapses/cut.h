#pragma once
// A level of detail cut out of a sequence of collapses.

#include <foredraw/collapses/collapse_sequences.h>
#include <foredraw/collapses/joined_mesh.h>
#include <foredraw/collapses/replay.h>

namespace foredraw {

/// What one draw becomes.
struct CutDraw {
  std::shared_ptr<const VertexStreams> vertices;
  Shared<std::uint32_t> indices;
  std::vector<std::uint32_t> origin;  ///< [vertex] = which of the mesh's it is
};

/// The mesh after `collapses` of a clean sequence. Where points move, they lie where the draws' formats can store them.
Collapsed collapsed(const CollapseSequence& sequence, std::size_t collapses, const JoinedMesh& mesh);

/// Of `after`, what one draw of the mesh has left: three vertices of the mesh a triangle.
std::span<const std::uint32_t> indices_of(const Collapsed& after, const JoinedMesh& mesh, std::size_t draw);

/// The draws of the mesh, in its sequence, after `collapses` of a clean sequence; `after` is the mesh then. Vertices
/// that no triangle uses are gone. Draws that shared vertices still do.
std::vector<CutDraw> cut(const CollapseSequence& sequence, std::size_t collapses, const Collapsed& after,
                         const JoinedMesh& mesh);

/// Whether no point that stays moves or is blended, so that the draws' own vertices will do at every level.
bool leaves_vertices(const CollapseSequence& sequence, const JoinedMesh& mesh);

/// The same as cut() of a sequence that leaves vertices: indices into the vertices that the draws have.
std::vector<CutDraw> cut_of_same_vertices(const Collapsed& after, const JoinedMesh& mesh);

}  // namespace foredraw

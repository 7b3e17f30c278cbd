#pragma once
// The vertices that a coarser level draws, with all that they have.

#include <foredraw/collapses/joined_mesh.h>
#include <foredraw/collapses/replay.h>

namespace foredraw {

struct LevelVertices {
  std::shared_ptr<const VertexStreams> vertices;
  std::vector<std::uint32_t> number;  ///< [vertex of the stream] = its number in the level, or no_vertex
};

/// [stream of the mesh] those that triangles of `after` use, in their old sequence and formats. A vertex that no
/// collapse changed keeps its bytes. Positions are the sequence's. Attributes are solved for where the sequence says so
/// (CollapseSequence::solves), numbers between those of the corners around. Otherwise they are blended as
/// Collapse::blend says, and joint weights and morph targets always are: weights of joints keep their sum; numbers that
/// count something else than an amount, such as identifiers, are those of the nearer vertex. So are those between which
/// nothing lies, as one is no number or two directions are opposite. Normals and tangents keep their length of 1. Where
/// joints and morph targets move a vertex is blended for all vertices of the point alike, so that no seam opens in a
/// pose that was closed.
std::vector<LevelVertices> level_vertices(const CollapseSequence& sequence, std::size_t collapses,
                                          const Collapsed& after, const JoinedMesh& mesh);

}  // namespace foredraw

#pragma once
// What the vertices of a level become in the next coarser one: their ancestors. Hoppe: Progressive Meshes, SIGGRAPH
// 1996, section 4.1.

#include <foredraw/collapses/cut.h>

#include <optional>

namespace foredraw {

/// [vertex of `fine`] = the vertex of `coarse` that stands for it: of the same side of a seam, where triangles use
/// that. Both are of one draw of the mesh; `at_coarse` is the mesh when it is as coarse. Triangles whose corners are
/// replaced by their ancestors are those of `coarse`, or have two corners at one place.
std::vector<std::uint32_t> ancestors(const CutDraw& fine, const CutDraw& coarse, const Collapsed& at_coarse,
                                     const JoinedMesh& mesh);

/// The mesh somewhere along its sequence.
struct CutLevel {
  Collapsed after;
  std::vector<CutDraw> draws;
};

/// Where along a clean sequence, whose run is given, the mesh is to the byte as these draws are at that level: level 0
/// is full detail. Nothing where it nowhere is, as behind a stage that ordered the level anew.
std::optional<CutLevel> find_cut(const CollapseSequence& sequence, const Replay& run, const JoinedMesh& mesh,
                                 const std::vector<const Level*>& levels);

struct Plugin;
Plugin geomorphs_plugin();

}  // namespace foredraw

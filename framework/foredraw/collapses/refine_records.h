#pragma once
// A sequence of collapses as arrays for runtime/selective_refine.h: what each split needs, and where on the surface it
// is. Hoppe: View-Dependent Refinement of Progressive Meshes, SIGGRAPH 1997.

#include <foredraw/collapses/progressive_records.h>
#include <foredraw/runtime/selective_refine_check.h>

namespace foredraw {

struct RefineRecords {
  ProgressiveRecords progressive;
  std::vector<std::uint32_t> corners;  ///< three a triangle, as it appears
  std::vector<std::uint32_t> needs;
  std::vector<foredraw_refine_node> nodes;  ///< and one more behind the last
  std::vector<std::uint32_t> point;         ///< [vertex] that it is of; see foredraw_refine_node
  std::uint32_t points = 0;                 ///< above all their numbers
  std::uint32_t borders = 0;  ///< edges of full detail, from point to point, that an odd number of triangles has

  /// What the headers take; both name the arrays here.
  foredraw_refine_mesh mesh() const;
  foredraw_refine_arrays arrays() const;
};

/// Of a clean sequence in which vertices stay where they are (leaves_vertices()).
RefineRecords refine_records(const CollapseSequence& sequence, std::span<const glm::vec3> positions,
                             std::span<const std::uint32_t> indices);

}  // namespace foredraw

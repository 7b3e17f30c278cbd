#pragma once
// A sequence of collapses as arrays for runtime/progressive_mesh.h: every state of the mesh is the front of its
// vertices and triangles.

#include <foredraw/collapses/collapse_sequence.h>
#include <foredraw/runtime/progressive_mesh.h>

#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace foredraw {

struct ProgressiveRecords {
  std::vector<std::uint32_t> vertex;    ///< [vertex] = which of the mesh's it is; those that no triangle uses are gone
  std::vector<std::uint32_t> triangle;  ///< [triangle] = which of the mesh's it is; those without area are gone
  std::vector<std::uint32_t> indices;   ///< three a triangle, of full detail
  std::vector<foredraw_split> splits;   ///< and one more behind the last
  std::vector<foredraw_patch> patches;
};

/// Of a clean sequence in which vertices stay where they are (leaves_vertices()). What stays longest comes first; what
/// goes in one collapse keeps the sequence that it had.
ProgressiveRecords progressive_records(const CollapseSequence& sequence, std::span<const glm::vec3> positions,
                                       std::span<const std::uint32_t> indices);

}  // namespace foredraw

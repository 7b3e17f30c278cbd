#pragma once
// A mesh as a stream that can be drawn long before it has arrived: a coarse mesh, and vertex splits that make it finer,
// in chunks. Hoppe: Progressive Meshes, SIGGRAPH 1996, sections 3 and 5.
// runtime/progressive_stream.h reads it, in C99.

#include "vertex_numbers.h"

#include <foredraw/collapses/collapse_sequence.h>
#include <foredraw/collapses/joined_mesh.h>

#include <atomic>
#include <cstddef>
#include <vector>

namespace foredraw {

struct ProgressiveStreamOptions : NumberBits {
  double growth = 1.5;               ///< each pass over the points knows so many times as many splits as the one before
  std::uint32_t chunk_size = 65536;  ///< bytes of a chunk, about; the first holds the coarsest mesh as well
};

struct ProgressiveStream {
  std::vector<std::byte> bytes;
  std::vector<std::uint32_t> vertex;     ///< [vertex] = which of the mesh's it is
  std::vector<std::uint32_t> collapse;   ///< [split] = which of the sequence's it undoes
  std::vector<std::uint32_t> chunk_end;  ///< [chunk] bytes up to its end
  std::vector<std::uint32_t> splits;     ///< [chunk] up to its end
};

/// Of a sequence that runs cleanly (replay()) and leaves vertices where they are (leaves_vertices()). Triangles without
/// area, and vertices that no other triangle has, are not in it; which corner of a triangle comes first is not kept.
/// Splits come in nearly the sequence's order: each behind those of the points that it lies between.
/// std::runtime_error where a place is not finite, or where no reader would take the stream, as at points with
/// thousands of triangles.
ProgressiveStream progressive_stream(const JoinedMesh& mesh, const CollapseSequence& sequence,
                                     const ProgressiveStreamOptions& options = {},
                                     const std::atomic<bool>* cancel = nullptr);

struct Plugin;
Plugin progressive_stream_plugin();

}  // namespace foredraw

#pragma once
// The splits of a progressive mesh in a sequence that suits the vertex cache, as far as they let themselves be moved.

#include <foredraw/collapses/refine_records.h>

namespace foredraw::bench {

/// [new] = old: each behind those that it needs. A window of splits ends where the mesh has grown to `window` times the
/// triangles; splits stay in their window. Within it, the next one is always, of those that may be done, one whose
/// triangles have the fewest vertices of full detail that a FIFO of 16 lacks.
std::vector<std::uint32_t> splits_by_place(const RefineRecords& records, double window);

/// [window] the split behind its last one.
std::vector<std::uint32_t> window_ends(const RefineRecords& records, double window);

/// Three a triangle, of full detail, as they come with the splits.
std::vector<std::uint32_t> indices_in(const RefineRecords& records, const std::vector<std::uint32_t>& splits);

}  // namespace foredraw::bench

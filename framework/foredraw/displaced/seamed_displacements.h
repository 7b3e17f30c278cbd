#pragma once
// Displacements of a surface whose seams have heights of their own.

#include <foredraw/displaced/stored_seams.h>
#include <foredraw/displaced/tessellated_mesh.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// displacements() of displaced_mesh.h, with heights of points on seams from their table: as foredraw_seamed_height()
/// has them. Both sides of a seam then move alike at any levels and spacing, as long as the map says the same at the
/// ends of its edges.
std::vector<float> seamed_displacements(const TessellatedMesh& mesh, std::span<const std::uint32_t> source,
                                        std::span<const std::array<std::int32_t, 2>> places,
                                        const foredraw_height_map& map, float factor, float offset,
                                        const StoredSeams& seams);

}  // namespace foredraw

#pragma once
#include <foredraw/analysis/seam_points.h>
#include <foredraw/runtime/seam_table.h>

#include <cstdint>
#include <vector>

namespace foredraw {

/// Heights of seams, to be stored apart: 2 bytes a height and one an edge. Where edges begin follows from their parts.
struct SeamTable {
  std::vector<std::uint16_t> heights;
  std::vector<std::uint32_t> firsts;                   ///< [edge]
  std::vector<std::uint8_t> parts_log2;                ///< [edge]
  std::vector<std::vector<foredraw_seam_side>> sides;  ///< [mesh] rising by number

  foredraw_seam_table view() const {
    return {heights.data(), heights.size(), firsts.data(), parts_log2.data(),
            static_cast<std::uint32_t>(firsts.size())};
  }
  std::size_t stored_bytes() const { return 2 * heights.size() + parts_log2.size(); }
};

/// Of the seam edges of `meshes` meshes, in their sequence; borders are left out. Each has as many parts as its factor
/// (seam_factors()). A height is the mean of the map's on all sides. Of a map that displacement-seams repaired, it is
/// what every side has there.
SeamTable seam_table(const SeamEdges& seams, const foredraw_height_map& map, std::size_t meshes);

}  // namespace foredraw

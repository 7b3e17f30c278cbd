#pragma once
#include <foredraw/analysis/seam_points.h>

#include <atomic>
#include <cstdint>
#include <vector>

namespace foredraw::processors::displacement_seams {

struct AveragedMap {
  std::vector<std::uint16_t> texels;
  std::vector<std::uint32_t> changed;  ///< their places, ascending
};

/// The paper's repair: the texels in which the sides of a point lie are all set to their mean; first at corners, then
/// at equidistant points along every seam, as many as the longer side has texels, and this so many times. Edges longer
/// than four times the map are left out. Once `cancel` is set, what comes out is of no use, and comes soon.
AveragedMap averaged_seams(const SeamEdges& seams, const foredraw_height_map& map, int iterations,
                           const std::atomic<bool>* cancel = nullptr);

}  // namespace foredraw::processors::displacement_seams

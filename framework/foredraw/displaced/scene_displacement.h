#pragma once
// What moves the surface of a scene's draw.

#include <foredraw/analysis/analyses.h>
#include <foredraw/displaced/height_map.h>
#include <foredraw/scene/scene.h>

#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace foredraw {

/// A map as it lies on a draw.
struct LaidOutMap {
  std::shared_ptr<const HeightMap> heights;
  Displacement displacement;                        ///< of the material
  std::vector<std::array<std::int32_t, 2>> places;  ///< [vertex] height_places()

  foredraw_height_map sampled() const { return foredraw::sampled(*heights, displacement.texture); }
};

/// Of the draw's full detail. Or why its material moves nothing, as the rest of a sentence.
std::variant<LaidOutMap, std::string> laid_out_map(const Scene& scene, DrawId draw, Analyses& analyses);

/// [vertex] smooth_directions() of a draw (full detail), together with the displaced draws that are in a mesh with it:
/// they share seams.
std::vector<glm::vec3> displacement_directions(const Scene& scene, DrawId draw, Analyses& analyses);

/// A stamp of all that these two hang on.
Stamp displacement_stamp(const Scene& scene, DrawId draw);

}  // namespace foredraw

#pragma once
// Maps of heights, and where the layouts of the draws that they lie on are cut.

#include <foredraw/analysis/seam_edges.h>
#include <foredraw/displaced/height_map.h>
#include <foredraw/scene/scene.h>

#include <atomic>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace foredraw {

/// One map as it is sampled in one way, with all draws that do so.
struct MapSeams {
  ImageId image = 0;
  std::shared_ptr<const HeightMap> heights;
  Texture texture;            ///< of the first draw: wrapping, and whether a texel is blended into its neighbours
  std::vector<DrawId> draws;  ///< rising
  SeamEdges seams;            ///< EdgeSide::mesh is the number of one of these draws

  foredraw_height_map sampled() const { return foredraw::sampled(*heights, texture); }
};

struct SceneSeams {
  std::vector<MapSeams> maps;                            ///< by image, wrapping and blending
  std::vector<std::pair<DrawId, std::string>> left_out;  ///< draws, and why, as the rest of a sentence
};

/// Of these draws (rising; full detail). Draws of one mesh have their seams with each other too; draws of different
/// ones lie in spaces of their own. Once `cancel` is set, what comes out is of no use, and comes soon.
SceneSeams seams_of_maps(const Scene& scene, const std::vector<DrawId>& draws, Analyses& analyses,
                         const std::atomic<bool>* cancel = nullptr);

}  // namespace foredraw

#pragma once
// An eye walks through a crowd, and methods that choose the levels of its characters are compared.
//
// N. Tatarchuk, J. Barczak, B. Purnomo: Real-Time Tessellation on GPU, SIGGRAPH 2008 course notes: levels by the number
// of characters, and its comparison of pipelines.

#include "crowd_methods.h"
#include "crowd_path.h"
#include "crowd_pipelines.h"

#include <atomic>
#include <optional>

namespace foredraw {

struct CrowdCostOptions {
  int instances = 1000;
  int frames = 300;
  double near = 2;         ///< the eye's height, in sizes of a character
  double far = 40;         ///< to the corners of the square around the eye, in sizes
  double eye_speed = 1.4;  ///< sizes a second
  double hysteresis = 0.35;
  CrowdFetching fetching = CrowdFetching::by_patch;
  int passes = 2;  ///< that draw the crowd: the picture, and one map of shadows
  std::uint64_t seed = 0;
};

/// What one method did, [frame].
struct CrowdMethodCost {
  CrowdMethod method = CrowdMethod::exact;
  std::vector<std::uint64_t> triangles;  ///< of a pass
  std::vector<double> rms;               ///< over all instances, of error / distance
  std::vector<double> largest;           ///< of these, by the largest distance of each level's surface
  std::vector<std::uint32_t> pops;       ///< instances at another level than in the frame before
};

struct CrowdCost {
  double size = 0;  ///< of a character, in its units
  std::vector<CrowdMethodCost> methods;
  std::array<PipelineCost, 4> pipelines;  ///< over all frames, with the levels of the last method
};

/// Of a character, in its units: the diameter of a ball of the same area.
double crowd_size(const CrowdLevels& levels, const Crowd& crowd);

/// Nothing where it was cancelled. The same everywhere. Throws std::invalid_argument where the crowd has no size.
std::optional<CrowdCost> crowd_cost(const Scene& scene, const CrowdLevels& levels, const Crowd& crowd,
                                    const CrowdCostOptions& options, const std::atomic<bool>* cancel = nullptr);

struct Plugin;
Plugin crowd_cost_plugin();

}  // namespace foredraw

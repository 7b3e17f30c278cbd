#pragma once
// The methods that a walk compares: each says for every seen object of a frame in which way it is drawn.

#include "frame_ways.h"

#include <foredraw/runtime/lod_methods.h>

#include <memory>
#include <string_view>
#include <vector>

namespace foredraw::evaluators::lod_walk {

enum class Method : std::uint8_t {
  none,      ///< full detail
  by_size,   ///< the coarsest level whose triangles stay under a size on the screen
  fed_back,  ///< the same with a size that follows the last frame's time
  budget,    ///< ours: hulls and a histogram of their slopes
};

inline constexpr std::array all_methods = {Method::none, Method::by_size, Method::fed_back, Method::budget};

constexpr std::string_view to_text(Method method) {
  switch (method) {
    case Method::none: return "none";
    case Method::by_size: return "static";
    case Method::fed_back: return "feedback";
    case Method::budget: break;
  }
  return "budget";
}

struct ChooserOptions {
  double budget = 0;      ///< nanoseconds of the objects of a frame
  double pixels = 1;      ///< of a triangle, at most: of `by_size`, and where `fed_back` begins
  double hysteresis = 0;  ///< as in BenefitOptions
};

class LevelChooser {
 public:
  virtual ~LevelChooser() = default;
  /// [seen object] the number of a way among its own. `last`: how the objects of the scene were drawn in the last
  /// frame; `not_seen` where they were not.
  virtual std::vector<std::uint32_t> choose(const FrameWays& frame, const std::vector<WayName>& last) = 0;
  /// What the frame that was chosen last took for its objects, in nanoseconds.
  virtual void took(double) {}
};

/// The scene and the meshes must outlive it.
std::unique_ptr<LevelChooser> level_chooser(Method method, const FrameScene& scene, const std::vector<MeshWays>& meshes,
                                            const ChooserOptions& options);

/// The way of that name among the object's.
std::uint32_t way_of(const FrameWays& frame, std::size_t seen, const WayName& name);

/// The level of an object by the size of its triangles on the screen.
inline std::uint32_t level_by_size(const MeshWays& mesh, float pixels, double most) {
  return foredraw_lod_by_size(mesh.triangles.data(), static_cast<std::uint32_t>(mesh.triangles.size()), pixels,
                              static_cast<float>(most));
}

}  // namespace foredraw::evaluators::lod_walk

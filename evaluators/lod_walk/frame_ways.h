#pragma once
// The ways in which each seen object of a frame can be drawn, with what they cost and what they are worth.

#include <foredraw/frames/frame_moment.h>
#include <foredraw/frames/picture_losses.h>
#include <foredraw/frames/rendering_costs.h>
#include <foredraw/runtime/lod_select.h>

#include <array>
#include <cstdint>
#include <vector>

namespace foredraw::evaluators::lod_walk {

/// What a level's or a rendering's accuracy is taken from.
enum class Accuracy : std::uint8_t {
  errors,    ///< the level's error on the screen
  samples,   ///< the level's number of vertices
  pictures,  ///< what pictures of the object lose, at its size on the screen
};

/// What counts in a benefit (Funkhouser, Sequin 1993, section 5). The defaults are for what pictures are compared by,
/// in which all pixels count alike; focus and motion say where people look.
struct BenefitOptions {
  Accuracy accuracy = Accuracy::pictures;
  double focus = 1;     ///< what an object in a corner of the picture is worth, beside one in its middle; 1: the same
  bool motion = false;  ///< what moves fast over the picture is worth less
  double hysteresis = 0.4;  ///< the last frame's way of an object is thought to lose so large a part less; 0: no less
};

/// A mesh at each level, and how near each rendering comes to the full one.
struct MeshWays {
  struct Level {
    std::uint32_t vertices = 0, draws = 0;
    double error = 0;  ///< in the mesh's units
  };
  std::vector<Level> levels;
  std::vector<std::uint32_t> triangles;                           ///< [level]
  PictureLosses losses;                                           ///< measured where accuracies or renderings need them
  std::array<double, all_renderings.size()> accuracies{1, 1, 1};  ///< [rendering]
  bool has_normal_map = false;
};

/// A level with a rendering.
struct WayName {
  std::uint32_t level = 0;
  Rendering rendering = Rendering::full;
  friend bool operator==(const WayName&, const WayName&) = default;
};

/// [seen object] each has its ways one behind the other, the cheapest first; of equally cheap ones the best last.
struct FrameWays {
  std::vector<SeenObject> seen;
  std::vector<std::uint32_t> first;    ///< and the number of ways behind the last
  std::vector<WayName> names;          ///< [way]
  std::vector<foredraw_lod_way> ways;  ///< [way] without hysteresis; costs in nanoseconds
  std::vector<float> worth;            ///< [way] the benefit before it was rounded

  foredraw_lod_scene scene(const std::vector<foredraw_lod_way>& of) const {
    return {static_cast<std::uint32_t>(seen.size()), first.data(), of.data()};
  }
};

/// [mesh] of all that nodes show.
std::vector<MeshWays> mesh_ways(const FrameScene& scene, const FrameMoment& moment, bool with_losses,
                                const Executor& executor);

/// What it is to draw the object so. The full rendering of what has no normal map is the one without.
ObjectWork work_of(const MeshWays& mesh, const WayName& name, const SeenObject& object, bool is_posed);

/// `speeds`: [seen object] pixels a frame. `with_renderings`: cheaper ones than the full one are ways too, where they
/// differ from it.
FrameWays frame_ways(const FrameScene& scene, const std::vector<MeshWays>& meshes, std::vector<SeenObject> seen,
                     const std::vector<float>& speeds, const RenderingCosts& costs, const BenefitOptions& options,
                     bool with_renderings);

/// The ways as they are worth it after the last frame: `last` is [object of the scene], no level where it was not seen.
std::vector<foredraw_lod_way> with_hysteresis(const FrameWays& frame, const std::vector<WayName>& last, double weight);

inline constexpr std::uint32_t not_seen = ~std::uint32_t{0};

}  // namespace foredraw::evaluators::lod_walk

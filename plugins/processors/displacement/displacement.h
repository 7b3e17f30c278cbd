#pragma once
// Gives draws a map of heights.

#include <foredraw/scene/scene.h>

#include <optional>
#include <string>
#include <vector>

namespace foredraw {

/// What of a displacement is given anew. The rest stays as the material has it.
struct GivenDisplacement {
  std::optional<ImageId> map;
  std::optional<float> factor;  ///< units for a height of 1
  std::optional<float> offset;  ///< units that every height is moved besides
  std::optional<std::uint32_t> texcoord;
};

struct DisplacementAnswer {
  std::vector<DrawId> displaced;                        ///< rising
  std::vector<std::pair<DrawId, std::string>> why_not;  ///< as the rest of a sentence: "it has no TEXCOORD_1"
  std::optional<float> factor;                          ///< that was chosen, where neither was given
};

/// Without a factor the map moves the surface by this part of the draws' diagonal.
inline constexpr double usual_displacement = 0.02;

/// Gives the materials of these draws (rising) a displacement, or changes what they have. A material that other draws
/// have too is copied; a draw without one gets one. A new map lies on the surface as the texture before did, or
/// repeats, by TEXCOORD_0.
DisplacementAnswer displace(Scene& scene, const std::vector<DrawId>& draws, const GivenDisplacement& given);

struct Plugin;
Plugin displacement_plugin();

}  // namespace foredraw

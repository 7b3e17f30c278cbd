#pragma once
// A few orders for all poses and views, by k-means. Source: Han, Sander: Triangle Reordering for Reduced Overdraw in
// Animated Scenes, I3D 2016, section 3.2. Names are the paper's: an order is an index buffer, what is sorted are
// patches, and looks (a keyframe seen from a viewpoint) are clustered.

#include "patch_distances.h"

#include <cstdint>

namespace foredraw {

/// By what one clustering is better than another: fragments shaded in all looks over pixels covered in all, so that
/// near looks weigh more than thin ones, or the mean of the looks' own ratios.
enum class OverdrawMetric { ratio, view_mean };

struct AnimatedKMeansOptions {
  int k = 5;               ///< 1 to 255; fewer where there are fewer looks
  int restarts = 0;        ///< so often it begins anew, from other looks; the best of all is kept
  int rounds = 30;         ///< at most, each time
  std::uint64_t seed = 0;  ///< of the looks that it begins with
  OverdrawMetric metric = OverdrawMetric::ratio;  ///< of rounds and starts, of which the best is kept
};

struct IndexBuffers {
  /// [buffer][draw][rank] = patch of the draw. The first is the one that serves best where there may be only one.
  std::vector<std::vector<std::vector<std::uint32_t>>> orders;
  std::vector<std::uint8_t> serving;  ///< [look] which buffer
  std::vector<OverdrawCount> counts;  ///< [look] drawn in it
};

/// Index buffers for the subject, whose draws' atoms are the patches, and which of them serves each look. Buffers that
/// would serve no look are left out; without looks there is one, with the patches as they came. `distances`: of the
/// subject. O(rounds * k * what the layers hold + rounds * looks * patches).
IndexBuffers animated_kmeans(const SubjectLayers& subject, const PatchDistances& distances,
                             const AnimatedKMeansOptions& options, const Executor& executor);

struct Plugin;
Plugin animated_kmeans_plugin();

}  // namespace foredraw

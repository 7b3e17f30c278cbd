#pragma once
// Where displacement makes a surface pass through itself.

#include <foredraw/analysis/analyses.h>
#include <foredraw/base/parallel.h>
#include <foredraw/scene/scene.h>

#include <atomic>
#include <cstddef>
#include <optional>
#include <string>

namespace foredraw {

struct SelfCrossings {
  std::size_t triangles = 0;  ///< that the draw was divided into
  std::size_t crossing = 0;   ///< of them: these pass through others, while what they lie on did not as it is stored
};

/// Of full detail in the pose that is stored, divided as finely as the map's texels, or less, into at most 131,072
/// triangles; by crossing_triangles(). None where no map displaces the draw or it cannot be read, where the draw has
/// more triangles itself, or `cancel` is set.
std::optional<SelfCrossings> self_crossings(const Scene& scene, DrawId draw, Analyses& analyses,
                                            const Executor& executor, const std::atomic<bool>* cancel = nullptr);

/// What a report says of it; empty where nothing crosses.
std::string note_of(const std::optional<SelfCrossings>& found);

}  // namespace foredraw

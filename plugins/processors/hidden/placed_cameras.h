#pragma once
// Where cameras are beside a subject: from the space of the scene into that of the subject.

#include "hidden.h"
#include "sight.h"

#include <foredraw/scene/subject.h>

#include <optional>

namespace foredraw::processors::hidden {

/// Where a pipeline says that cameras are, in the space of the scene, +Y up.
struct SceneCameras {
  SeenFrom seen_from = SeenFrom::outside;
  std::vector<glm::dmat4> boxes;  ///< for `box` and `points`: each takes the unit cube there

  bool are_outside() const { return seen_from == SeenFrom::outside || seen_from == SeenFrom::above; }
};

/// Beside what stands still in the space of the scene.
Cameras cameras_beside(const SceneCameras& cameras);

/// Beside what moves: from above is from anywhere. Nothing where cameras are inside: nobody knows where, then.
std::optional<Cameras> cameras_beside_moving(const SceneCameras& cameras);

/// Beside a mesh in its own space, as all nodes show it that hold it; as it is where none does. Nothing where that is
/// not known.
std::optional<Cameras> cameras_beside_mesh(const SceneCameras& cameras, const Scene& scene, MeshId mesh);

/// "x y z; x y z", or nothing where the text is none.
std::optional<std::vector<glm::dvec3>> points_in(const std::string& text);

}  // namespace foredraw::processors::hidden

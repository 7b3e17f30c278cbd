#pragma once
// A camera that an animation moves along a way.

#include "gltf_document.h"

#include <glm/vec3.hpp>

#include <functional>
#include <vector>

namespace foredraw::bench {

/// From one corner to the next, the corners rounded by parabolas that begin `rounding` before them; corners lie more
/// than twice that apart.
struct CameraPath {
  std::vector<glm::dvec3> corners;
  double rounding = 1;
  double ahead = 1;  ///< how far along the way lies what the camera looks at
  double seconds = 12;
};

/// Where the camera is, one place for each step of equal length on the way: from the start to the end, `steps` + 1.
std::vector<glm::dvec3> places_on(const CameraPath& path, std::size_t steps);

/// Adds a perspective camera (60 degrees high, a picture of 16:9), a node "camera" for it, a root of scene 0, and the
/// animation "walk" that moves and turns the node: linear keys, 30 a second, at one speed. `height` is added to the
/// camera's and to what it looks at (of a ground that is not flat).
void add_walk(GltfDocument& to, const CameraPath& path, const std::function<double(const glm::dvec3&)>& height = {});

}  // namespace foredraw::bench

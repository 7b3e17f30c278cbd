#pragma once
// A scene for walks: spheres over a plane, each with levels of detail.

#include "support/meshes.h"

#include <foredraw/scene/scene.h>

#include <cmath>

namespace foredraw::testing {

/// A sphere of radius 1 with so many levels, each of a quarter of the triangles of the one before. The error of a level
/// is how far the middle of a slice is from the sphere.
inline Draw levelled_sphere(std::uint32_t slices, std::size_t levels) {
  Draw draw = draw_of(sphere(slices, slices / 2), "sphere");
  for (std::size_t level = 1; level < levels; ++level) {
    const std::uint32_t left = std::max(slices >> level, 4u);
    Draw coarser = draw_of(sphere(left, left / 2));
    coarser.full().error = 1 - std::cos(3.14159265f / static_cast<float>(left));
    draw.levels.push_back(coarser.full());
  }
  return draw;
}

/// side x side spheres of two kinds, four units apart.
inline Scene levelled_field(int side, std::uint32_t slices = 64, std::size_t levels = 5) {
  Scene scene = scene_of({levelled_sphere(slices, levels), levelled_sphere(slices / 2, levels - 1)});
  scene.nodes.clear();
  for (int i = 0; i < side * side; ++i) {
    Node node;
    node.mesh = static_cast<MeshId>(i % 3 == 0 ? 1 : 0);
    node.transform.translation = {4.0f * static_cast<float>(i % side), 0, 4.0f * static_cast<float>(i / side)};
    scene.nodes.push_back(node);
  }
  return scene;
}

}  // namespace foredraw::testing

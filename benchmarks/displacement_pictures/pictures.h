#pragma once
// Scenes, stages and pictures of the reference renderer.

#include <foredraw/frames/reference_renderer.h>
#include <foredraw/scene/scene.h>

#include <filesystem>
#include <string>
#include <vector>

namespace foredraw::bench {

/// After stages on one line, with the built-in plugins. std::runtime_error where one fails.
Scene after(const std::string& stages, const Scene& scene);

/// Of a scene with one object: from its mesh into the world, and the sphere that it fills there.
struct Placed {
  glm::mat4 world{1};
  BoundingSphere sphere;
};
Placed placed(const Scene& scene);

/// Every object at its finest level.
FramePicture drawn(Scene scene, const FrameCamera& camera, FrameSize size);

/// Writes pictures of one height side by side, as PNG of 8 bits.
void write_png(const std::filesystem::path& path, const std::vector<FramePicture>& pictures);

}  // namespace foredraw::bench

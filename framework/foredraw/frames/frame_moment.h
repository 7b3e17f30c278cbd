#pragma once
// A scene at one moment, and what a camera sees of it.

#include <foredraw/frames/frame_camera.h>
#include <foredraw/frames/frame_scene.h>
#include <foredraw/viewing/animation.h>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

namespace foredraw {

/// Where an object is, in world space.
struct PlacedBounds {
  BoundingSphere sphere;
  glm::dmat3 half_box{0};  ///< from the sphere's centre to the middles of three sides of the box
};

/// Where everything is at one time.
struct FrameMoment {
  PosedNodes nodes;
  std::vector<glm::mat4> world;      ///< [object] from the mesh's space; joints move what has a skin instead
  std::vector<PlacedBounds> bounds;  ///< [object]
};

/// All clips at that time at once. Morph targets are thought to stay in the bounds.
FrameMoment frame_moment(const FrameScene& scene, double seconds);

/// Whether the front faces of an object turn clockwise. Its node decides, joints or not (glTF 2.0, 3.7.4).
bool is_mirrored(const FrameScene& scene, const FrameMoment& moment, std::size_t object);

/// An object that a camera sees.
struct SeenObject {
  std::uint32_t object = 0;
  float distance = 0;       ///< of the sphere's nearest point from the eye, along the view; at least the near plane's
  float across = 0;         ///< pixels of the sphere's diameter
  float pixels = 0;         ///< of the picture that the mesh covers, if nothing hides it: at most all of them
  float shown = 0;          ///< of these, that show; the same until something says what hides the mesh
  float pixels_a_unit = 0;  ///< at that distance, of a unit in the mesh's space: what an error of one comes to
  glm::vec2 place{0};       ///< of the sphere's centre in the picture, in pixels from its middle, upwards
  float from_middle = 0;    ///< 0 in the middle of the picture, 1 in its corners and beyond
};

/// Those whose boxes reach into the frustum, the nearest one first; equally near ones by number.
std::vector<SeenObject> seen_objects(const FrameScene& scene, const FrameMoment& moment, const FrameCamera& camera,
                                     FrameSize size);

}  // namespace foredraw

#pragma once
// Scenes that are hard for anti-aliasing, made on the spot. A unit is a pixel of pictures by pixel_camera().

#include <foredraw/frames/frame_camera.h>
#include <foredraw/scene/scene.h>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <vector>

namespace foredraw::testing {

/// A mesh with or without wires, of one colour.
struct ThinMesh {
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;
  std::vector<glm::vec4> wires;  ///< [vertex] as wire_radius.h has them; 0 of what is no wire
  std::vector<glm::vec4> axes;   ///< [vertex]

  /// A tube along the points, with open ends, in `sides` sides around; its inscribed circle has the radius.
  void add_tube(const std::vector<glm::vec3>& points, float radius, int sides);
  /// A flat strip along the points, one-sided; `across`: of length 1, the direction of its breadth.
  void add_ribbon(const std::vector<glm::vec3>& points, const glm::vec3& across, float half_breadth);
  void add_box(const glm::vec3& half, const glm::vec3& along_x, const glm::vec3& along_y, const glm::vec3& centre);
};

/// `has_wires`: with the attributes.
Scene scene_of(const ThinMesh& mesh, const glm::vec3& colour, bool has_wires);

/// From far away, so that one unit at the origin is one pixel.
FrameCamera pixel_camera(FrameSize size, double distance = 1000);

/// The same from all around, evenly over a sphere.
std::vector<FrameCamera> pixel_cameras_around(FrameSize size, int views);

/// The camera once for each frame, sliding by parts of a pixel.
std::vector<FrameCamera> sliding(const FrameCamera& camera, int frames, const glm::dvec2& step);

ThinMesh lines_at_all_angles(float radius, FrameSize size);  ///< ten, of two thirds of the picture
/// The same lines as flat strips, each turned another way about its line, from the front to nearly edge-on.
ThinMesh ribbons_at_all_angles(float half_breadth, FrameSize size);
ThinMesh crossing_wires(float radius, float length);  ///< three, one before the other
/// 8 spans of 3 wires that hang through, along -z; for road_camera().
ThinMesh road_wires(float radius);
FrameCamera road_camera();
ThinMesh turned_box(float edge);             ///< pixels along each edge
ThinMesh bars(float width, FrameSize size);  ///< ten at all angles; square
ThinMesh cylinder(float radius, int sides, float length);
ThinMesh grass_cards(int blades, std::uint64_t seed, FrameSize size);  ///< one-sided triangles, three to a blade

}  // namespace foredraw::testing

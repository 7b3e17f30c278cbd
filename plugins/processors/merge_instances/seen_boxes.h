#pragma once
// How likely a camera sees any of a box.

#include <foredraw/geometry/box.h>

#include <glm/vec3.hpp>

namespace foredraw::processors::merge_instances {

/// The part of all frustums that see anything of a scene which also touch a box in it: cameras stand anywhere and look
/// anywhere, all equally likely.
///
/// A convex body that is moved and turned at random meets another with a measure of V1 + V2 + (S1 M2 + S2 M1) / 4 pi,
/// of volumes, surfaces and integrals of mean curvature (Blaschke's kinematic formula; Santalo, "Integral Geometry and
/// Geometric Probability", 1976, III.15.4). The frustum is a pyramid of 16:9 that opens 60 degrees upright.
class SeenBoxes {
 public:
  /// `view_distance`: of the frustum, in the scene's units; above 0.
  SeenBoxes(const Box<glm::vec3>& scene, double view_distance)
      : volume_(frustum_volume * view_distance * view_distance * view_distance),
        surface_(frustum_surface * view_distance * view_distance),
        curvature_(frustum_curvature * view_distance),
        of_scene_(1 / measure(scene)) {}

  /// From above 0 to 1; larger boxes are seen more often.
  double operator()(const Box<glm::vec3>& box) const { return measure(box) * of_scene_; }

  // Of the pyramid of height 1.
  static constexpr double frustum_volume = 0.7901234567901233;
  static constexpr double frustum_surface = 6.395430215088049;
  static constexpr double frustum_curvature = 10.756973903504594;

 private:
  double measure(const Box<glm::vec3>& box) const {
    const glm::dvec3 side = glm::dvec3(box.max) - glm::dvec3(box.min);
    const double volume = side.x * side.y * side.z;
    const double surface = 2 * (side.x * side.y + side.y * side.z + side.z * side.x);
    // A box's curvature lies in its edges, four of each direction, that turn by a right angle: pi for each side's
    // length.
    return volume_ + volume + surface_ * (side.x + side.y + side.z) / 4 + curvature_ * surface * one_in_four_pi;
  }

  static constexpr double one_in_four_pi = 0.0795774715459477;
  double volume_, surface_, curvature_;
  double of_scene_ = 1;
};

}  // namespace foredraw::processors::merge_instances

#pragma once
// From positions to corners in the picture, and from corners' depths to fragments'.

#include <foredraw/scene/views.h>
#include <foredraw/viewing/coverage.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>

namespace foredraw {

/// Depth steps in one radius of the bounding sphere.
inline constexpr double depth_steps = 0x1p23;

/// All that is seen at one point of the picture, in radii from the centre of the sphere.
struct LineOfSight {
  static constexpr double length = 4;  ///< from before the sphere to behind it

  glm::dvec3 from;
  glm::dvec3 direction;  ///< unit length
};

/// Looks at the centre of a sphere of radius 1, which just fits into the picture. Only + - * / sqrt and rounding to
/// whole numbers, so that corners are the same on every machine.
class Camera {
 public:
  Camera(const View& view, int size)
      : size_(size),
        towards_(view.direction),
        distance_(view.distance),
        extent_(size * subpixels),
        half_(extent_ / 2.0) {
    // +Y is up, but for views along it.
    const glm::dvec3 up = std::abs(towards_.y) < 0.999 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
    const glm::dvec3 right = glm::cross(up, towards_);
    right_ = right / std::sqrt(glm::dot(right, right));
    up_ = glm::cross(towards_, right_);
    // The sphere's outline is where lines from the camera touch it.
    if (is_perspective()) focal_ = std::sqrt(distance_ * distance_ - 1);
  }

  int size() const { return size_; }
  bool is_perspective() const { return distance_ > 0; }
  /// The picture's axes and the one towards the camera: each of length 1, and at right angles.
  const glm::dvec3& right() const { return right_; }
  const glm::dvec3& up() const { return up_; }
  const glm::dvec3& towards() const { return towards_; }
  /// From the eye to the plane on which the sphere's outline has radius 1; 1 where the view is orthographic.
  double focal() const { return focal_; }

  double distance() const { return distance_; }
  double extent() const { return extent_; }
  double half() const { return half_; }

  /// Depth steps from the eye to depth 0; perspective only.
  double steps_before_sphere() const { return (distance_ - 1) * depth_steps; }

  Corner project(const glm::dvec3& position) const {
    const double near = glm::dot(position, towards_);
    const double scale = is_perspective() ? half_ * focal_ / (distance_ - near) : half_;
    // Inside of the sphere nothing but rounding leaves the picture.
    return {static_cast<std::int32_t>(rounded(half_ + glm::dot(position, right_) * scale, extent_)),
            static_cast<std::int32_t>(rounded(half_ + glm::dot(position, up_) * scale, extent_)),
            static_cast<std::uint32_t>(rounded((1 - near) * depth_steps, 2 * depth_steps - 1))};
  }

  /// Of the point x to the right and y upwards from the lower left corner, in the units of Corner.
  LineOfSight line_of_sight(double x, double y) const {
    const glm::dvec3 aside = right_ * (x / half_ - 1) + up_ * (y / half_ - 1);
    if (!is_perspective()) return {aside + towards_ * (LineOfSight::length / 2), -towards_};
    const glm::dvec3 towards_point = aside - towards_ * focal_;
    const glm::dvec3 direction = towards_point / std::sqrt(glm::dot(towards_point, towards_point));
    // From the eye it is the farther away from the sphere the less of it floats would keep.
    const glm::dvec3 eye = towards_ * distance_;
    return {eye - direction * (glm::dot(eye, direction) + LineOfSight::length / 2), direction};
  }

 private:
  static double rounded(double value, double most) { return std::clamp(std::floor(value + 0.5), 0.0, most); }

  int size_;
  glm::dvec3 towards_;
  glm::dvec3 right_;
  glm::dvec3 up_;
  double distance_;
  double extent_;
  double half_;
  double focal_ = 1;
};

/// The fragment's depth between three corners, rounded down. Exact: the sum stays below 2^64.
class OrthographicDepth {
 public:
  OrthographicDepth(const Camera&, const Corner& a, const Corner& b, const Corner& c, std::int64_t area)
      : a_(a.depth), b_(b.depth), c_(c.depth), area_(static_cast<std::uint64_t>(area)) {}

  std::uint32_t at(const std::array<std::int64_t, 3>& weights) const {
    return static_cast<std::uint32_t>((static_cast<std::uint64_t>(weights[0]) * a_ +
                                       static_cast<std::uint64_t>(weights[1]) * b_ +
                                       static_cast<std::uint64_t>(weights[2]) * c_) /
                                      area_);
  }

 private:
  std::uint64_t a_, b_, c_, area_;
};

/// The same where what runs evenly over the picture is 1 / distance from the eye. Rounded to the nearest step, so that
/// triangles that face the camera keep their corners' depth.
class PerspectiveDepth {
 public:
  PerspectiveDepth(const Camera& camera, const Corner& a, const Corner& b, const Corner& c, std::int64_t area)
      : before_(camera.steps_before_sphere()),
        a_(1 / (before_ + a.depth)),
        b_(1 / (before_ + b.depth)),
        c_(1 / (before_ + c.depth)),
        area_(static_cast<double>(area)) {}

  std::uint32_t at(const std::array<std::int64_t, 3>& weights) const {
    const double inverse = static_cast<double>(weights[0]) * a_ + static_cast<double>(weights[1]) * b_ +
                           static_cast<double>(weights[2]) * c_;
    return static_cast<std::uint32_t>(std::max(0.0, area_ / inverse - before_ + 0.5));
  }

 private:
  double before_, a_, b_, c_, area_;
};

}  // namespace foredraw

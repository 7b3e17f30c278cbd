#pragma once
// A mesh about 1 across, about the middle of its box: for libraries that compare with numbers of that size.

#include <foredraw/collapses/collapse_recorder.h>

#include <glm/vec3.hpp>

#include <span>

namespace foredraw {

/// The unit is a power of two. For one point, or none, the diagonal is 0.
struct UnitFrame {
  glm::dvec3 middle{0};
  double unit = 1;      ///< how long a unit of the frame is
  double diagonal = 0;  ///< of the box, in units of the frame

  glm::dvec3 from_mesh(const glm::vec3& at) const { return (glm::dvec3(at) - middle) / unit; }
  glm::vec3 to_mesh(const glm::dvec3& at) const { return glm::vec3(at * unit + middle); }
};

/// Of the points of triangles, as far as they are finite.
UnitFrame unit_frame(std::span<const glm::vec3> positions, const CollapseRecorder& recorder);

}  // namespace foredraw

#pragma once
// What is looked at together, and from where.

#include <foredraw/base/parallel.h>
#include <foredraw/viewing/raster_part.h>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace foredraw::processors::hidden {

/// [triangle] 0 or 1.
using Flags = std::vector<std::uint8_t>;

/// Where cameras may be, in the space that a thing's positions are in.
struct Cameras {
  /// Directions, of any length above 0. Cameras are outside, and along one of these no lower than the middle of the
  /// thing's bounding sphere. None: anywhere outside.
  std::vector<glm::dvec3> ups;
  /// Each takes the unit cube to a box that cameras are in, which may be a single point. Where there are any, cameras
  /// are nowhere else.
  std::vector<glm::dmat4> boxes;
};

/// Parts as they stand at one moment. What looks into the vectors of somebody else must not outlive them.
struct Sight {
  std::vector<RasterPart> parts;         ///< without masks: what has holes is as good as whole, but hides nothing
  Flags hides;                           ///< [part] whether it hides what lies behind it
  std::vector<std::uint32_t> triangles;  ///< [triangle, counted through the parts] its number in flags
  Cameras cameras;
  bool is_rigid = true;  ///< it stands so in every pose
};

}  // namespace foredraw::processors::hidden

#pragma once
// Ribbons that cross and hang together, such as shrouds with ratlines.

#include "wire_points.h"

namespace foredraw::processors::wire_radius {

struct Net {
  std::uint32_t shell = 0;
  double length = 0;      ///< of all its ribbons: half its borders
  double half_width = 0;  ///< of a ribbon, on average
  WireParts parts;
};

/// Shells that are open, and very much longer along their borders than their area would have it. A point's centre is on
/// the line of its ribbon, in the middle of what is cut straight across it. Where ribbons cross, a point belongs to
/// several, and has a centre for each.
std::vector<Net> find_nets(const WeldedMesh& mesh);

}  // namespace foredraw::processors::wire_radius

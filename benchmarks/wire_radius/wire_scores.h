#pragma once
// How well wires that were found agree with those that are known.

#include "wire_sets.h"

#include <plugins/processors/wire_radius/wire_radius.h>

namespace foredraw::bench {

/// Sums over meshes; lengths are in their units.
struct WireScore {
  double known = 0;                  ///< length of the known wires
  double reached = 0;                ///< of that, what was found: a wire's length times the part of its area
  double found = 0;                  ///< length of what was found and is known to be a wire or none
  double right = 0;                  ///< of that, what is a wire
  double either = 0;                 ///< length of what was found where both are right
  std::vector<double> centre_error;  ///< [vertex that a known centre] as part of the half width
  std::vector<double> radius_error;  ///< the same of the half width itself

  double recall() const { return known > 0 ? reached / known : 1; }
  double precision() const { return found > 0 ? right / found : 1; }
  void add(const WireScore& other);
};

WireScore score(const KnownMesh& known, const FoundWires& found);

}  // namespace foredraw::bench

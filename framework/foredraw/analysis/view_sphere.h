#pragma once
// View sets: where a subject is looked at from, spelled alike in every pipeline table and option list.

#include <foredraw/scene/views.h>

#include <cstdint>
#include <optional>
#include <string>

namespace foredraw {

/// A view set as a pipeline spells it.
struct ViewSet {
  std::string views = "icosphere";  ///< icosphere | fibonacci | axes | random; a bare number: that icosphere
  std::optional<int> count;         ///< absent: 162 for an icosphere, 100 else; axes are always 6
  std::int64_t seed = 0;            ///< of random
  std::optional<double> distance;   ///< in bounding-sphere radii; absent: orthographic
  int size = 256;                   ///< pixels

  friend bool operator==(const ViewSet&, const ViewSet&) = default;
};

/// Why the set can not be made ("an icosphere has 12, 42, 162, 642 or 2562 views, not 100"), or nothing.
std::optional<std::string> mistake_in(const ViewSet& set);

/// The views of a set without mistakes. Directions are the same bits on every machine.
Views make_views(const ViewSet& set);

}  // namespace foredraw

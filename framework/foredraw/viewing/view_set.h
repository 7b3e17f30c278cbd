#pragma once
// View sets: where a subject is looked at from, spelled alike in every pipeline table and option list.

#include <foredraw/scene/views.h>

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

namespace foredraw {

/// A view set as a pipeline spells it.
struct ViewSet {
  /// icosphere | fibonacci | axes | random | cone; a bare number: that icosphere; a file (view_list.h): its path, with
  /// a dot or a slash in it.
  std::string views = "icosphere";
  std::optional<int> count;              ///< absent: 162 for an icosphere, 100 else; axes are always 6
  std::int64_t seed = 0;                 ///< of random
  std::string axis = "0 1 0";            ///< of a cone, "x y z" of any length
  double angle = 90;                     ///< of a cone: the farthest that a view is from its axis, in degrees
  std::optional<std::int64_t> rotation;  ///< seed of a random rotation of the whole set; absent: as it is
  std::optional<double> distance;        ///< in bounding-sphere radii; absent: orthographic
  int size = 128;                        ///< pixels

  friend bool operator==(const ViewSet&, const ViewSet&) = default;
};

/// What is wrong with the set as it is spelled, or nothing. No file is read.
std::optional<std::string> mistake_in(const ViewSet& set);

/// The views of a set; or why there are none ("an icosphere has 12, 42, 162, 642 or 2562 views, not 100"). A file is
/// read once. Directions are the same bits on every machine.
std::variant<Views, std::string> views_of(const ViewSet& set);

/// The same for who knows that there is no mistake; else std::invalid_argument.
Views make_views(const ViewSet& set);

}  // namespace foredraw

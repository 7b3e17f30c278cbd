#pragma once
#include <foredraw/technique/options.h>
#include <foredraw/viewing/view_set.h>

#include <concepts>

namespace foredraw {

/// The rows of a view set, for options that derive from ViewSet.
template <class Options>
requires std::derived_from<Options, ViewSet>
void add_view_rows(OptionTable<Options>& table) {
  table.number_or_text(&ViewSet::views, "views",
                       "Where to look from: icosphere, fibonacci, axes, random, cone, or a file with one view per "
                       "line; a bare number means an icosphere of that many views",
                       OptionType::views);
  table.template row<std::optional<int>>(
      &ViewSet::count, "count", "Number of views (default: 162 for an icosphere, else 100)", {1, 100000, "views"});
  table.template row<std::int64_t>(&ViewSet::seed, "seed", "Seed of random views", {.least = 0});
  table.template row<std::string>(&ViewSet::axis, "axis", "Axis of a cone of views, as 'x y z'");
  table.template row<double>(
      &ViewSet::angle, "angle",
      "Widest angle between a cone's views and its axis; 90 covers the half sphere around the axis",
      {0.1, 180, "degrees"});
  table.template row<std::optional<std::int64_t>>(
      &ViewSet::rotation, "rotation", "Seed of a random rotation of the whole set (default: none)", {.least = 0});
  table.template row<std::optional<double>>(&ViewSet::distance, "distance",
                                            "Distance of the camera from the centre (default: orthographic views)",
                                            {1.01, 1e6, "bounding-sphere radii"});
  table.template row<int>(&ViewSet::size, "size", "Width and height of the picture that the subject fills",
                          {16, 4096, "pixels"});
}

}  // namespace foredraw

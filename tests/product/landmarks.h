#pragma once
// A product as a plugin outside of the framework brings it: of some draws a few vertices and triangles, by number.

#include <foredraw/technique/plugin.h>

namespace foredraw::testing {

struct Landmarks {
  static constexpr std::string_view product = "landmarks";
  struct OfDraw {
    DrawId draw = 0;
    std::vector<std::uint32_t> vertices, triangles;
    std::vector<std::uint32_t> parts = {};  ///< where the second one begins, and so on; of level 1 there is one at half
    friend bool operator==(const OfDraw&, const OfDraw&) = default;
  };
  std::vector<OfDraw> draws;
  friend bool operator==(const Landmarks&, const Landmarks&) = default;
};

/// Makes them of a vertex in the midst and the last one, and of the first and last triangle, of each draw.
/// `wrong`: names a vertex that there is not. `parts`: each draw has two, one of a third of its triangles, and one of
/// the rest.
Plugin landmarks_plugin();

}  // namespace foredraw::testing

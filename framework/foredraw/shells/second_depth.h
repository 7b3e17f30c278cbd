#pragma once
// What an engine may draw with front faces culled, to get the depth of the nearest back face: the product of a stage
// that puts closed shells first.

#include <foredraw/scene/draw.h>

#include <cstdint>
#include <string_view>
#include <vector>

namespace foredraw {

struct SecondDepth {
  static constexpr std::string_view product = "second-depth";

  /// Of full detail.
  struct OfDraw {
    DrawId draw = 0;
    std::uint32_t triangles = 0;  ///< so many at the start of the draw, above 0; with those of its mesh they are closed
    friend bool operator==(const OfDraw&, const OfDraw&) = default;
  };
  std::vector<OfDraw> draws;  ///< rising

  /// 0 where the draw has none.
  std::uint32_t triangles_of(DrawId draw) const {
    for (const OfDraw& of : draws) {
      if (of.draw == draw) return of.triangles;
    }
    return 0;
  }

  friend bool operator==(const SecondDepth&, const SecondDepth&) = default;
};

}  // namespace foredraw

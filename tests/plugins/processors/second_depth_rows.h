#pragma once
// Rows of depths, as runtime/second_depth.h is asked about them.

#include <foredraw/runtime/second_depth.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>

namespace foredraw::testing {

/// Seven samples of a row.
struct Row {
  std::array<float, 7> depth{}, second{};

  /// From functions of the place, in pixels.
  static Row of(const std::function<float(float)>& depth, const std::function<float(float)>& second) {
    Row row;
    for (std::size_t i = 0; i < 7; ++i) {
      row.depth[i] = depth(static_cast<float>(i) - 3);
      row.second[i] = second(static_cast<float>(i) - 3);
    }
    return row;
  }
  Row reversed() const {
    Row row = *this;
    for (float& d : row.depth) d = 1 - d;
    for (float& d : row.second) d = 1 - d;
    return row;
  }
  Row stored(double most) const {
    Row row = *this;
    for (float& d : row.depth) d = static_cast<float>(std::rint(static_cast<double>(d) * most) / most);
    for (float& d : row.second) d = static_cast<float>(std::rint(static_cast<double>(d) * most) / most);
    return row;
  }
  Row mirrored() const {
    Row row = *this;
    std::ranges::reverse(row.depth);
    std::ranges::reverse(row.second);
    return row;
  }
};

inline float edge_of(const Row& row, const foredraw_second_depth_rule& rule = foredraw_second_depth_float(0),
                     int before = 3, int behind = 3) {
  return foredraw_second_depth_edge(&rule, row.depth.data(), row.second.data(), before, behind);
}

}  // namespace foredraw::testing

#pragma once
// How low and how high a displacement map is where a triangle lies.

#include <foredraw/runtime/displaced_height.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace foredraw {

/// Texels, 0 to 65535; least above most: of nothing.
struct HeightRange {
  std::uint16_t least = 65535, most = 0;

  void add(const HeightRange& other) {
    least = std::min(least, other.least);
    most = std::max(most, other.most);
  }
  friend bool operator==(const HeightRange&, const HeightRange&) = default;
};

/// Answers from the map and coarser and coarser copies of it: 4/3 bytes a texel.
class HeightRanges {
 public:
  /// The map's texels have to stay where they are.
  explicit HeightRanges(const foredraw_height_map& map);

  /// Of all texels that any point of the triangle has a part of: no foredraw_displaced_height() between the corners,
  /// which are height places, is outside. Exact for triangles less than 64 texels wide and high; larger ones count what
  /// lies beside them, too, up to a 64th of their size. O(1).
  HeightRange over(const std::array<std::array<std::int32_t, 2>, 3>& corners) const;

 private:
  struct Level {
    std::uint32_t width = 0, height = 0;
    std::vector<HeightRange> cells;  ///< empty: the map's texels are
  };
  HeightRange cell(const Level& level, std::size_t at) const;

  foredraw_height_map map_;
  std::vector<Level> levels_;  ///< each of half the size of the one before, rounded up
};

}  // namespace foredraw

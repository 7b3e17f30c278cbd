#pragma once
// Where a tessellator puts points on an edge.

#include <cstdint>

namespace foredraw {

/// How a tessellator spaces points, in the words of shaders (equal_spacing, fractional_odd_spacing, ...).
enum class TessellationSpacing : std::uint8_t {
  equal,            ///< as many equal parts as the level, rounded up
  fractional_odd,   ///< an odd number of parts, two of which grow out of the corners of others as the level grows
  fractional_even,  ///< the same, with an even number
};

/// Places on edges and weights of corners are whole multiples of 1 / 65536.
inline constexpr std::uint32_t weight_one = 65536;

/// The level that the tessellator works with. What is above 0 is clamped to [1, 64] (equal), [1, 63] (fractional odd)
/// or [2, 64] (fractional even); then equal spacing rounds it up to a whole number, and fractional spacing to the
/// nearest multiple of 1 / 65536, ties to even ones. 0, what is negative and NaN give 0: the patch is not drawn. Levels
/// that come out alike put the same points on an edge.
float effective_level(float level, TessellationSpacing spacing);

/// The points on one edge.
class EdgeDivision {
 public:
  EdgeDivision() = default;
  /// `level`: as effective_level() gives it, and not 0.
  EdgeDivision(float level, TessellationSpacing spacing);

  /// 1 to 64; the edge has one point more, both ends included.
  std::uint32_t parts() const { return 2 * fine_ - (is_odd_ ? 1 : 0); }
  /// Where point `point` lies, up to parts(), in 1 / 65536 of the edge. Seen from the other end the points are the
  /// same: place(parts() - i) is 65536 - place(i). With
  /// fractional even spacing, a part that has just begun to grow may be turned over by rounding, by up to 7 / 65536.
  std::uint32_t place(std::uint32_t point) const;

 private:
  bool is_odd_ = true;
  // The points of one half. With a fractional level they lie between where they are with `coarse_` of them and where
  // they are with `fine_`, one more.
  std::uint32_t coarse_ = 1, fine_ = 1;
  std::uint32_t fraction_ = 0;                                       ///< how far from coarse to fine, in 1 / 65536
  std::uint32_t split_ = ~0u;                                        ///< the point out of which the next one grows
  std::uint32_t coarse_part_ = weight_one, fine_part_ = weight_one;  ///< lengths
};

}  // namespace foredraw

#pragma once
// Directions, rotations and lengths as few small whole numbers, each with the arithmetic that says what the numbers
// stand for: that of the filters of EXT_meshopt_compression and KHR_meshopt_compression (their appendix B). Who rounds
// values to what these give loses nothing more where a file keeps the small numbers alone.

#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace foredraw {

/// To the nearest, halves away from zero, and into the type's range; what is no number is 0.
template <class T>
T nearest_whole(float value) {
  constexpr auto most = static_cast<float>(std::numeric_limits<T>::max());
  const float away = value + (value < 0 ? -0.5f : 0.5f);
  return std::isnan(away) ? T{0} : static_cast<T>(std::clamp(away, std::is_signed_v<T> ? -most : 0.0f, most));
}

/// A point of an octahedron that reaches `one` from its middle, the lower half folded out around the upper.
struct OctahedralPoint {
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::int32_t one = 1;
};

/// The direction of the point, of length 1 as T's largest value says it (int8_t or int16_t).
template <class T>
std::array<T, 3> direction_of(const OctahedralPoint& point) {
  auto x = static_cast<float>(point.x);
  auto y = static_cast<float>(point.y);
  const float z = static_cast<float>(point.one) - std::abs(x) - std::abs(y);
  const float folded = std::min(z, 0.0f);
  x += x < 0 ? -folded : folded;
  y += y < 0 ? -folded : folded;
  const float scale = static_cast<float>(std::numeric_limits<T>::max()) / std::sqrt(x * x + y * y + z * z);
  return {nearest_whole<T>(x * scale), nearest_whole<T>(y * scale), nearest_whole<T>(z * scale)};
}

/// A unit quaternion (x, y, z, w, of length 32767) without its greatest component, which follows from the others and is
/// not negative: those behind it, in turn, as parts of sqrt(1/2), which is `one` | 3.
struct SmallestThree {
  std::array<std::int16_t, 3> parts{};
  std::int16_t one = 32767;   ///< its low two bits say nothing
  std::uint8_t greatest = 0;  ///< 0 to 3
};

std::array<std::int16_t, 4> rotation_of(const SmallestThree& coded);

/// The point of an octahedron of 2^(bits-1) - 1 whose direction, as T says it, is nearest. `direction` need not have
/// length 1; where it has none, or is not finite, the point is that of +z. 2 to 8 bits for int8_t, to 16 for int16_t.
template <class T>
OctahedralPoint nearest_point(const glm::dvec3& direction, int bits);

/// The point of such an octahedron whose direction is just this; nullopt where none has it.
template <class T>
std::optional<OctahedralPoint> point_of(const std::array<T, 3>& direction, int bits);

/// The coded form with 2^(bits-1) - 1 for sqrt(1/2) that is nearest to a quaternion (x, y, z, w) of any length but 0
/// and either sign; 4 to 16 bits.
SmallestThree nearest_rotation(const std::array<double, 4>& rotation, int bits);

/// The coded form that stands for just this; nullopt where none does.
std::optional<SmallestThree> coded_rotation(const std::array<std::int16_t, 4>& rotation, int bits);

/// The least exponent e for which the value is a whole multiple of 2^e; nullopt for 0 and for what is not finite.
std::optional<int> lattice_of(float value);

}  // namespace foredraw

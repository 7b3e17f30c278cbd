#pragma once
#include <glm/vec2.hpp>

#include <cmath>

namespace foredraw {

/// A turn in the plane.
struct Turn {
  double sine = 0;
  double cosine = 1;
};

/// By an angle in radians; by none where it is not finite. From the series, because what a library says of sine and
/// cosine may depend on the processor in the last bit.
inline Turn turn_by(double angle) {
  constexpr double circle = 6.283185307179586;
  if (!std::isfinite(angle)) return {};
  const double x = angle - circle * std::floor(angle / circle + 0.5);
  Turn turn{0, 0};
  double term = 1;
  for (int n = 0; n < 40; ++n) {  // x is below 4
    double& sum = n % 2 == 0 ? turn.cosine : turn.sine;
    sum += n % 4 < 2 ? term : -term;
    term *= x / (n + 1);
  }
  return turn;
}

/// Counter-clockwise, where y points down.
inline glm::dvec2 turned(const glm::dvec2& point, const Turn& by) {
  return {by.cosine * point.x + by.sine * point.y, by.cosine * point.y - by.sine * point.x};
}

}  // namespace foredraw

#pragma once
// What a vertex should carry where it comes to lie. Hoppe: New Quadric Metric for Simplifying Meshes with Appearance
// Attributes, Visualization 1999. Over each face an attribute is a linear function. At a given place the value whose
// squared differences from all faces around, by area, are least is the mean of these functions, by area. A linear
// function is made of its values at three corners, so that the mean is a sum of what the corners carry, in shares that
// follow from places alone: they are the same for all attributes. Shares of corners that lie behind may be negative.

#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace foredraw {

struct WedgeShare {
  std::uint32_t vertex = 0;
  double share = 0;
};

/// What shares make of numbers, of which `of(vertex)` tells.
template <class Of>
double shared_sum(std::span<const WedgeShare> shares, const Of& of) {
  double sum = 0;
  for (const auto& [vertex, share] : shares) sum += share * of(vertex);
  return sum;
}

/// The same, but between the numbers of the corners. What none of them has need not exist: textures end at the borders
/// of their islands, colours at 0 and 1. Not finite where one of them is not.
template <class Of>
double shared_number(std::span<const WedgeShare> shares, const Of& of) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const WedgeShare& one : shares) {
    const double value = of(one.vertex);
    least = std::min(least, value);
    most = std::max(most, value);
  }
  return std::clamp(shared_sum(shares, of), least, most);
}

/// Of the vertex that the faces around share, or that two vertices become: a wedge. Faces are told one by one.
class WedgeShares {
 public:
  static constexpr std::size_t most_faces = 256;  ///< of more there are no shares

  void start(glm::vec3 place);
  void add(const std::array<glm::vec3, 3>& corners, const std::array<std::uint32_t, 3>& vertices);
  /// They sum up to 1. None where faces are too narrow to say what lies beside them, or where the place lies so far
  /// from all of them that shares would be large: differences between corners, and what rounding left of them, would
  /// grow with each step.
  std::span<const WedgeShare> finish();

 private:
  void add(std::uint32_t vertex, double share);

  glm::dvec3 place_{0};
  double area_ = 0;
  std::size_t faces_ = 0;
  std::vector<WedgeShare> shares_;
};

}  // namespace foredraw

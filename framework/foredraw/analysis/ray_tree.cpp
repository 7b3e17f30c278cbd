#include <foredraw/analysis/ray_tree.h>

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace foredraw {

namespace {

constexpr std::size_t most_in_ray_leaf = 4;
constexpr std::size_t deepest = 64;  // halves of 2^32 triangles at most

bool is_all_finite(const glm::vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

/// A ray in the space where it runs along +z from the origin, sheared there rather than turned.
struct ShearedRay {
  glm::dvec3 from, direction, inverse;
  int x, y, z;
  double shear_x, shear_y;

  ShearedRay(const glm::dvec3& from, const glm::dvec3& direction) : from(from), direction(direction) {
    const glm::dvec3 size = glm::abs(direction);
    z = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    x = (z + 1) % 3;
    y = (x + 1) % 3;
    if (direction[z] < 0) std::swap(x, y);  // keeps what turns counter-clockwise so
    shear_x = direction[x] / direction[z];
    shear_y = direction[y] / direction[z];
    // A ray along a plane of a box is in it or not for all of its way: the largest number stands for infinity, as 0
    // times it is 0.
    for (int axis = 0; axis < 3; ++axis) {
      inverse[axis] = direction[axis] != 0 ? 1 / direction[axis] : std::numeric_limits<double>::max();
    }
  }
};

/// Whether the ray passes the box in front of its beginning; a little too often, never too seldom.
bool may_pass(const ShearedRay& ray, const float (&low)[3], const float (&high)[3]) {
  double enters = 0, leaves = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (static_cast<double>(low[axis]) - ray.from[axis]) * ray.inverse[axis];
    const double b = (static_cast<double>(high[axis]) - ray.from[axis]) * ray.inverse[axis];
    enters = std::max(enters, std::min(a, b));
    leaves = std::min(leaves, std::max(a, b));
  }
  return enters <= leaves * (1 + 0x1p-48);
}

}  // namespace

RayTree::RayTree(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                 std::span<const Blocks> blocks) {
  for (std::size_t t = 0; t < blocks.size(); ++t) {
    if (blocks[t] == Blocks::neither) continue;
    Triangle triangle{{}, static_cast<std::uint32_t>(t), blocks[t]};
    for (std::size_t c = 0; c < 3; ++c) triangle.corners[c] = positions[indices[3 * t + c]];
    if (std::ranges::all_of(triangle.corners, is_all_finite)) triangles_.push_back(triangle);
  }
  if (!triangles_.empty()) split(0, triangles_.size());
}

/// By halves at the middle of the longest side of the middles' box.
void RayTree::split(std::size_t first, std::size_t count) {
  const auto middle = [](const Triangle& t, int axis) {
    return t.corners[0][axis] + t.corners[1][axis] + t.corners[2][axis];
  };
  glm::vec3 low(std::numeric_limits<float>::infinity()), high(-low), low_middle(low), high_middle(high);
  const auto begin = triangles_.begin() + static_cast<std::ptrdiff_t>(first);
  const auto end = begin + static_cast<std::ptrdiff_t>(count);
  for (auto t = begin; t != end; ++t) {
    for (const glm::vec3& corner : t->corners) {
      low = glm::min(low, corner);
      high = glm::max(high, corner);
    }
    const glm::vec3 at(middle(*t, 0), middle(*t, 1), middle(*t, 2));
    low_middle = glm::min(low_middle, at);
    high_middle = glm::max(high_middle, at);
  }
  const std::size_t number = nodes_.size();
  nodes_.push_back({{{low.x, low.y, low.z}, {high.x, high.y, high.z}},
                    static_cast<std::uint32_t>(first),
                    static_cast<std::uint32_t>(count)});
  if (count <= most_in_ray_leaf) return;
  const glm::vec3 size = high_middle - low_middle;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  // Equal middles are told apart by number: the tree is the same on every machine.
  std::nth_element(begin, begin + static_cast<std::ptrdiff_t>(count / 2), end,
                   [&](const Triangle& a, const Triangle& b) {
                     return std::pair(middle(a, axis), a.number) < std::pair(middle(b, axis), b.number);
                   });
  split(first, count / 2);
  nodes_[number].first = static_cast<std::uint32_t>(nodes_.size());
  nodes_[number].count = 0;
  nodes_[number].axis = static_cast<std::uint32_t>(axis);
  split(first + count / 2, count - count / 2);
}

template <class Visit>
void RayTree::for_each_met(const Ray& ray, Visit visit) const {
  if (nodes_.empty()) return;
  const ShearedRay sheared(ray.from, ray.direction);
  const double along = ray.direction[sheared.z];
  /// Whether to go on.
  const auto meet = [&](const Triangle& triangle) {
    if (triangle.number == ray.except) return true;
    std::array<glm::dvec3, 3> at;
    std::array<double, 3> across_x, across_y;
    for (std::size_t c = 0; c < 3; ++c) {
      at[c] = glm::dvec3(triangle.corners[c]) - ray.from;
      across_x[c] = at[c][sheared.x] - sheared.shear_x * at[c][sheared.z];
      across_y[c] = at[c][sheared.y] - sheared.shear_y * at[c][sheared.z];
    }
    // Twice the areas that the ray cuts the triangle into: of one sign, or 0 at an edge, where it meets it.
    const double u = across_x[2] * across_y[1] - across_y[2] * across_x[1];
    const double v = across_x[0] * across_y[2] - across_y[0] * across_x[2];
    const double w = across_x[1] * across_y[0] - across_y[1] * across_x[0];
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return true;
    const double area = u + v + w;
    if (area == 0) return true;  // seen edge on: nothing of it is in the way
    const double way = (u * at[0][sheared.z] + v * at[1][sheared.z] + w * at[2][sheared.z]) / (area * along);
    if (!(way > ray.nearest)) return true;
    return visit(triangle, area > 0, way);
  };
  std::array<std::uint32_t, deepest> open;
  std::size_t waiting = 0;
  open[waiting++] = 0;
  while (waiting > 0) {
    const std::uint32_t number = open[--waiting];
    const Node& node = nodes_[number];
    if (!may_pass(sheared, node.box.low, node.box.high)) continue;
    if (node.count == 0) {
      // The nearer child first: what starts inside a body meets its surface there.
      const bool is_first_nearer = ray.direction[static_cast<int>(node.axis)] >= 0;
      open[waiting++] = is_first_nearer ? node.first : number + 1;
      open[waiting++] = is_first_nearer ? number + 1 : node.first;
      continue;
    }
    for (std::uint32_t t = node.first; t < node.first + node.count; ++t) {
      if (!meet(triangles_[t])) return;
    }
  }
}

bool RayTree::escapes(const Ray& ray) const {
  bool is_free = true;
  for_each_met(ray, [&](const Triangle& triangle, bool faces_beginning, double) {
    is_free = triangle.blocks == (faces_beginning ? Blocks::front : Blocks::back);
    return is_free;
  });
  return is_free;
}

std::optional<RayTree::Hit> RayTree::first(const Ray& ray) const {
  std::optional<Hit> nearest;
  for_each_met(ray, [&](const Triangle& triangle, bool faces_beginning, double way) {
    if (triangle.blocks == (faces_beginning ? Blocks::back : Blocks::front)) return true;
    const bool is_nearer =
        !nearest || way < nearest->way || (way == nearest->way && triangle.number < nearest->triangle);
    if (is_nearer) nearest = Hit{triangle.number, faces_beginning, way};
    return true;
  });
  return nearest;
}

}  // namespace foredraw

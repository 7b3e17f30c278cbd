#include <foredraw/analysis/ray_tree.h>

#include <foredraw/geometry/finite.h>

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace foredraw {

namespace {

/// A ray in the space where it runs along +z from the origin, sheared there rather than turned.
struct ShearedRay {
  int x, y, z;
  double shear_x, shear_y;

  explicit ShearedRay(const glm::dvec3& direction) {
    const glm::dvec3 size = glm::abs(direction);
    z = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    x = (z + 1) % 3;
    y = (x + 1) % 3;
    if (direction[z] < 0) std::swap(x, y);  // keeps what turns counter-clockwise so
    shear_x = direction[x] / direction[z];
    shear_y = direction[y] / direction[z];
  }
};

/// The ray as boxes are tested with it: in floats, which round so little that a box that it passes is never missed.
struct RayPastBoxes {
  static constexpr float slack = 1 + 0x1p-20f;

  std::array<float, 3> inverse;  ///< 1 / the direction, of which the longest component is 1
  std::array<float, 3> from[2];  ///< where it begins, or a little below; a little above
  std::array<std::size_t, 3> is_downwards;
  double scale;  ///< ways along this one for a way of 1 along the ray

  RayPastBoxes(const glm::dvec3& begin, const glm::dvec3& direction, int longest) {
    constexpr double most = std::numeric_limits<float>::max();
    scale = std::abs(direction[longest]);
    for (int axis = 0; axis < 3; ++axis) {
      // A ray along a plane of a box is in it or not for all of its way: the largest number stands for infinity, as 0
      // times it is 0.
      const double to_one = direction[axis] != 0 ? scale / direction[axis] : most;
      inverse[axis] = static_cast<float>(std::clamp(to_one, -most, most));
      is_downwards[axis] = inverse[axis] < 0;
      const auto at = static_cast<float>(std::clamp(begin[axis], -most, most));
      const float apart = std::abs(at) * 0x1p-22f + std::numeric_limits<float>::min();
      from[0][axis] = at - apart;
      from[1][axis] = at + apart;
    }
  }
};

constexpr std::size_t most_in_ray_leaf = 4;

}  // namespace

RayTree::RayTree(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                 std::span<const Blocks> blocks) {
  std::vector<Triangle> triangles;
  std::vector<BoxTree::Box> boxes;
  for (std::size_t t = 0; t < blocks.size(); ++t) {
    if (blocks[t] == Blocks::neither) continue;
    Triangle triangle{{}, static_cast<std::uint32_t>(t), blocks[t]};
    for (std::size_t c = 0; c < 3; ++c) triangle.corners[c] = positions[indices[3 * t + c]];
    if (!std::ranges::all_of(triangle.corners, [](const glm::vec3& corner) { return is_finite(corner); })) continue;
    triangles.push_back(triangle);
    BoxTree::Box& box = boxes.emplace_back();
    for (const glm::vec3& corner : triangle.corners) box.add(corner);
  }
  BoxTree tree = box_tree(boxes, most_in_ray_leaf);
  nodes_ = std::move(tree.nodes);
  triangles_.reserve(triangles.size());
  for (const std::uint32_t number : tree.order) triangles_.push_back(triangles[number]);
}

template <class Visit>
void RayTree::for_each_met(const Ray& ray, Visit visit) const {
  if (nodes_.empty()) return;
  const ShearedRay sheared(ray.direction);
  const RayPastBoxes past(ray.from, ray.direction, sheared.z);
  const double along = ray.direction[sheared.z];
  double farthest = std::numeric_limits<double>::infinity();
  const auto meet = [&](const Triangle& triangle) {
    if (triangle.number == ray.except) return;
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
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return;
    const double area = u + v + w;
    if (area == 0) return;  // seen edge on: nothing of it is in the way
    const double way = (u * at[0][sheared.z] + v * at[1][sheared.z] + w * at[2][sheared.z]) / (area * along);
    if (way > ray.nearest) farthest = std::min(farthest, visit(triangle, area > 0, way));
  };
  struct Waiting {
    std::uint32_t first, count;
    float enters;
  };
  std::array<Waiting, BoxTree::most_waiting> open;
  std::size_t waiting = 0;
  open[waiting++] = {0, 0, 0};
  while (waiting > 0) {
    const Waiting next = open[--waiting];
    if (static_cast<double>(next.enters) > farthest * past.scale * RayPastBoxes::slack) continue;
    for (std::uint32_t t = next.first; t < next.first + next.count; ++t) {
      meet(triangles_[t]);
      if (farthest < 0) return;
    }
    if (next.count > 0) continue;
    const BoxTree::Node& node = nodes_[next.first];
    Four enters = {}, leaves = enters + std::numeric_limits<float>::infinity();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t downwards = past.is_downwards[axis];
      const Four in = (four(node.planes[downwards][axis]) - past.from[1 - downwards][axis]) * past.inverse[axis];
      const Four out = (four(node.planes[1 - downwards][axis]) - past.from[downwards][axis]) * past.inverse[axis];
      enters = enters < in ? in : enters;
      leaves = out < leaves ? out : leaves;
    }
    leaves *= RayPastBoxes::slack;
    // The nearer child first: what starts inside a body meets its surface there.
    const std::size_t bottom = waiting;
    for (std::size_t c = 0; c < BoxTree::width; ++c) {
      if (!(enters[c] <= leaves[c])) continue;
      std::size_t to = waiting++;
      for (; to > bottom && open[to - 1].enters < enters[c]; --to) open[to] = open[to - 1];
      open[to] = {node.first[c], node.count[c], enters[c]};
    }
  }
}

bool RayTree::escapes(const Ray& ray) const {
  bool is_free = true;
  for_each_met(ray, [&](const Triangle& triangle, bool faces_beginning, double) {
    is_free = triangle.blocks == (faces_beginning ? Blocks::front : Blocks::back);
    return is_free ? std::numeric_limits<double>::infinity() : -1;
  });
  return is_free;
}

std::optional<RayTree::Hit> RayTree::first(const Ray& ray) const {
  std::optional<Hit> nearest;
  for_each_met(ray, [&](const Triangle& triangle, bool faces_beginning, double way) {
    const bool is_in_the_way = triangle.blocks != (faces_beginning ? Blocks::back : Blocks::front);
    const bool is_nearer = is_in_the_way && (!nearest || way < nearest->way ||
                                             (way == nearest->way && triangle.number < nearest->triangle));
    if (is_nearer) nearest = Hit{triangle.number, faces_beginning, way};
    return nearest ? nearest->way : std::numeric_limits<double>::infinity();
  });
  return nearest;
}

int RayTree::winding(const Ray& ray) const {
  int winding = 0;
  for_each_met(ray, [&](const Triangle&, bool faces_beginning, double) {
    winding += faces_beginning ? -1 : 1;
    return std::numeric_limits<double>::infinity();
  });
  return winding;
}

}  // namespace foredraw

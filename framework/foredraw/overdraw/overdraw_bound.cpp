#include <foredraw/overdraw/overdraw_bound.h>

#include <foredraw/geometry/finite.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>

namespace foredraw {

namespace {

constexpr double tolerance = 1e-6;  // of the diameter

/// Points in boxes within boxes, asked whether any of them lies before a plane.
class PointTree {
 public:
  explicit PointTree(std::vector<glm::dvec3> points) : points_(std::move(points)) {
    if (!points_.empty()) build(0, points_.size());
  }

  double diameter() const { return nodes_.empty() ? 0 : glm::length(nodes_[0].most - nodes_[0].least); }

  /// Whether the scalar product of some point and the normal is above the limit.
  bool reaches(const glm::dvec3& normal, double limit) const { return !nodes_.empty() && reaches(0, normal, limit); }

 private:
  static constexpr std::size_t leaf_size = 16;

  struct Node {
    glm::dvec3 least, most;
    std::size_t begin, end;
    std::size_t second = 0;  ///< its second half; its first one is the next node. 0: it has none
  };

  std::size_t build(std::size_t begin, std::size_t end) {
    const std::size_t number = nodes_.size();
    Node node{points_[begin], points_[begin], begin, end};
    for (std::size_t i = begin; i < end; ++i) {
      node.least = glm::min(node.least, points_[i]);
      node.most = glm::max(node.most, points_[i]);
    }
    nodes_.push_back(node);
    if (end - begin <= leaf_size) return number;
    const glm::dvec3 extent = node.most - node.least;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return points_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end),
                     [axis](const glm::dvec3& a, const glm::dvec3& b) { return a[axis] < b[axis]; });
    build(begin, middle);
    const std::size_t second = build(middle, end);
    nodes_[number].second = second;
    return number;
  }

  bool reaches(std::size_t number, const glm::dvec3& normal, double limit) const {
    const Node& node = nodes_[number];
    double farthest = 0;
    for (int axis = 0; axis < 3; ++axis) {
      farthest += std::max(normal[axis] * node.least[axis], normal[axis] * node.most[axis]);
    }
    if (farthest <= limit) return false;
    if (node.second == 0) {
      for (std::size_t i = node.begin; i < node.end; ++i) {
        if (glm::dot(points_[i], normal) > limit) return true;
      }
      return false;
    }
    return reaches(number + 1, normal, limit) || reaches(node.second, normal, limit);
  }

  std::vector<glm::dvec3> points_;
  std::vector<Node> nodes_;
};

/// Calls back with the corners of every triangle, counter-clockwise as seen from its front.
template <class Visit>
bool every_triangle(std::span<const RasterPart> parts, Visit visit) {
  for (const RasterPart& part : parts) {
    for (std::size_t i = 0; i + 2 < part.indices.size(); i += 3) {
      const glm::dvec3 a = part.positions[part.indices[i]];
      const glm::dvec3 b = part.positions[part.indices[i + (part.is_mirrored ? 2 : 1)]];
      const glm::dvec3 c = part.positions[part.indices[i + (part.is_mirrored ? 1 : 2)]];
      if (!visit(part, a, b, c)) return false;
    }
  }
  return true;
}

std::optional<std::vector<glm::dvec3>> points_of(std::span<const RasterPart> parts) {
  std::vector<glm::dvec3> points;
  for (const RasterPart& part : parts) {
    std::vector<char> is_taken(part.positions.size(), 0);
    for (const std::uint32_t index : part.indices) {
      if (is_taken[index]) continue;
      is_taken[index] = 1;
      if (!is_finite(part.positions[index])) return std::nullopt;
      points.emplace_back(part.positions[index]);
    }
  }
  return points;
}

}  // namespace

std::optional<double> overdraw_bound(std::span<const RasterPart> parts, double most) {
  auto points = points_of(parts);
  if (!points) return std::nullopt;
  double area = 0;
  every_triangle(parts, [&](const RasterPart& part, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    area += glm::length(glm::cross(b - a, c - a)) * (part.culls_back_faces ? 1 : 2);
    return true;
  });
  const PointTree tree(std::move(*points));
  const double slack = tolerance * tree.diameter();
  const double least_on_hull = area / most;
  double beside_hull = 0;
  const bool is_near =
      every_triangle(parts, [&](const RasterPart& part, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
        const glm::dvec3 across = glm::cross(b - a, c - a);
        const double size = glm::length(across);
        if (!(size > 0)) return true;
        const glm::dvec3 normal = across / size;
        const double limit = std::max({glm::dot(normal, a), glm::dot(normal, b), glm::dot(normal, c)}) + slack;
        const double other = -std::min({glm::dot(normal, a), glm::dot(normal, b), glm::dot(normal, c)}) + slack;
        const bool is_outermost = part.mask == nullptr && (!tree.reaches(normal, limit) ||
                                                           (!part.culls_back_faces && !tree.reaches(-normal, other)));
        if (!is_outermost) beside_hull += size;
        if (!part.culls_back_faces) beside_hull += size;  // its inner side
        return area - beside_hull >= least_on_hull;
      });
  if (!is_near || !(area > 0)) return std::nullopt;
  return area / (area - beside_hull);
}

}  // namespace foredraw

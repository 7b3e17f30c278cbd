#include <foredraw/io/mesh/private/polygon_mesh.h>

#include <glm/geometric.hpp>

#include <algorithm>

namespace foredraw::mesh_files {

namespace {

/// Twice the signed area of the triangle abc.
double turn(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

/// Along the axis in which the polygon's area vector (Newell's) is longest, turned so that the polygon winds left.
std::vector<glm::dvec2> flattened(std::span<const glm::vec3> points) {
  glm::dvec3 area(0);
  const glm::dvec3 origin(points[0]);
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    area += glm::cross(glm::dvec3(points[i]) - origin, glm::dvec3(points[i + 1]) - origin);
  }
  const glm::dvec3 size = glm::abs(area);
  const int axis = size.z >= size.x && size.z >= size.y ? 2 : size.y >= size.x ? 1 : 0;
  const int first = (axis + 1) % 3, second = (axis + 2) % 3;
  const double sign = area[axis] < 0 ? -1 : 1;
  std::vector<glm::dvec2> flat;
  flat.reserve(points.size());
  for (const glm::vec3& point : points) {
    flat.emplace_back(sign * (double(point[first]) - origin[first]), double(point[second]) - origin[second]);
  }
  return flat;
}

/// A polygon losing one ear after the other.
class Clipping {
 public:
  explicit Clipping(std::span<const glm::vec3> points) : flat_(flattened(points)) {
    const auto n = static_cast<std::uint32_t>(points.size());
    for (std::uint32_t i = 0; i < n; ++i) {
      before_.push_back((i + n - 1) % n);
      after_.push_back((i + 1) % n);
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      if (corner(i) <= 0) blocking_.push_back(i);
    }
  }

  /// The corner's turn: negative where it points inwards.
  double corner(std::uint32_t i) const { return turn(flat_[before_[i]], flat_[i], flat_[after_[i]]); }

  bool is_convex() const { return blocking_.empty(); }  ///< then every corner is an ear

  /// Whether the triangle at `i` holds no other corner, nor has one on its rim. Only corners that point inwards, or lie
  /// on a straight line, can be in its way, and those that do neither any more never will again.
  bool is_ear(std::uint32_t i, std::size_t& tests_left) {
    if (corner(i) <= 0) return false;  // a straight one makes a triangle without area
    std::erase_if(blocking_, [&](std::uint32_t r) { return is_gone(r) || corner(r) > 0; });
    tests_left -= std::min(tests_left, blocking_.size() + 1);
    const std::uint32_t a = before_[i], c = after_[i];
    const glm::dvec2 pa = flat_[a], pb = flat_[i], pc = flat_[c];
    return std::none_of(blocking_.begin(), blocking_.end(), [&](std::uint32_t r) {
      const glm::dvec2 p = flat_[r];
      if (r == a || r == c || p == pa || p == pb || p == pc) return false;  // also one that stands there twice
      return turn(pa, pb, p) >= 0 && turn(pb, pc, p) >= 0 && turn(pc, pa, p) >= 0;
    });
  }

  std::array<std::uint32_t, 3> cut(std::uint32_t i) {
    const std::array<std::uint32_t, 3> triangle{before_[i], i, after_[i]};
    after_[before_[i]] = after_[i];
    before_[after_[i]] = before_[i];
    after_[i] = i;
    return triangle;
  }

  std::uint32_t before(std::uint32_t i) const { return before_[i]; }
  std::uint32_t after(std::uint32_t i) const { return after_[i]; }

 private:
  bool is_gone(std::uint32_t i) const { return after_[i] == i; }

  std::vector<glm::dvec2> flat_;
  std::vector<std::uint32_t> before_, after_, blocking_;
};

}  // namespace

void Triangulator::cut(std::span<const glm::vec3> points, std::vector<std::array<std::uint32_t, 3>>& triangles) {
  const auto n = static_cast<std::uint32_t>(points.size());
  if (n == 3) {
    triangles.push_back({0, 1, 2});
    return;
  }
  Clipping polygon(points);
  // From the second corner on, so that a convex polygon becomes the fan around its first.
  std::uint32_t at = 1, left = n, passed = 0;
  bool is_earless = false, is_unfinished = false;
  while (left > 3) {
    const bool may_work = tests_left_ > 0 || polygon.is_convex();
    const bool may_look = passed < left && may_work;
    if (may_look && !polygon.is_ear(at, tests_left_)) {
      at = polygon.after(at);
      ++passed;
      continue;
    }
    is_earless = is_earless || passed >= left;
    is_unfinished = is_unfinished || (passed < left && !may_work);
    triangles.push_back(polygon.cut(at));
    at = triangles.back()[2];
    --left;
    if (may_look) passed = 0;
  }
  triangles.push_back({polygon.before(at), at, polygon.after(at)});
  if (is_earless) ++earless_;
  if (is_unfinished) ++unfinished_;
}

}  // namespace foredraw::mesh_files

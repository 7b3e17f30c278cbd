#include <foredraw/analysis/closest_points.h>

#include <foredraw/analysis/part_boxes.h>
#include <foredraw/geometry/finite.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace foredraw {

namespace {

double square_of(const glm::dvec3& v) { return glm::dot(v, v); }

/// The nearest point as a + b * (second corner - a) + c * (third corner - a).
struct OnTriangle {
  double squared = std::numeric_limits<double>::infinity();
  double b = 0, c = 0;
};

/// The distance is that of a point of the triangle, never of its plane alone: so it is the true one or more, however
/// thin the triangle is.
OnTriangle nearest_on(const glm::dvec3& ab, const glm::dvec3& ac, const glm::dvec3& ap) {
  constexpr double thin = 1e-12;
  const glm::dvec3 normal = glm::cross(ab, ac);
  const double area = square_of(normal), length_ab = square_of(ab), length_ac = square_of(ac);
  OnTriangle best;
  const auto offer = [&](double b, double c) {
    const double squared = square_of(ap - (b * ab + c * ac));
    if (squared < best.squared) best = {squared, b, c};
  };
  if (area > 0) {
    const double c = glm::dot(glm::cross(ab, ap), normal), b = glm::dot(glm::cross(ap, ac), normal);
    if (b >= 0 && c >= 0 && b + c <= area) {
      offer(b / area, c / area);
      if (area > thin * length_ab * length_ac) return best;  // else its plane is hardly known
    }
  }
  const auto along = [](double way, double length) { return length > 0 ? std::clamp(way / length, 0.0, 1.0) : 0; };
  const glm::dvec3 bc = ac - ab;
  offer(along(glm::dot(ap, ab), length_ab), 0);
  offer(0, along(glm::dot(ap, ac), length_ac));
  const double from_b = along(glm::dot(ap - ab, bc), square_of(bc));
  offer(1 - from_b, from_b);
  return best;
}

OnTriangle nearest_on(const TriangleCorners& t, const glm::dvec3& point) {
  return nearest_on(t[1] - t[0], t[2] - t[0], point - t[0]);
}

TriangleCorners in_doubles(const std::array<glm::vec3, 3>& t) {
  return {glm::dvec3(t[0]), glm::dvec3(t[1]), glm::dvec3(t[2])};
}

/// A point as boxes are tested with it: in floats, a little below and a little above, so that no box seems farther than
/// it is.
struct PointAmongBoxes {
  float above[3], below[3];

  PointAmongBoxes(const glm::dvec3& point, const glm::dvec3& middle, double scale) {
    constexpr double most = 0x1p60, of_itself = 0x1p-22, of_extent = 0x1p-40;
    for (int axis = 0; axis < 3; ++axis) {
      const double at = std::clamp((point[axis] - middle[axis]) * scale, -most, most);
      const double apart = std::abs(at) * of_itself + of_extent;
      below[axis] = static_cast<float>(at - apart);
      above[axis] = static_cast<float>(at + apart);
    }
  }

  /// [child] the square of its distance or a little less.
  Four squared_distance(const BoxTree::Node& node) const {
    Four sum = {};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Four under = four(node.planes[0][axis]) - above[axis], over = below[axis] - four(node.planes[1][axis]);
      Four out = under > over ? under : over;
      out = out > 0 ? out : Four{};
      sum += out * out;
    }
    return sum;
  }
};

}  // namespace

double squared_distance(const TriangleCorners& corners, const glm::dvec3& point) {
  return nearest_on(corners, point).squared;
}

Closest closest_on(const TriangleCorners& corners, const glm::dvec3& point) {
  const OnTriangle at = nearest_on(corners, point);
  return {0, std::sqrt(at.squared), corners[0] + at.b * (corners[1] - corners[0]) + at.c * (corners[2] - corners[0]),
          glm::dvec3(std::max(1 - at.b - at.c, 0.0), at.b, at.c)};
}

ClosestPoints::ClosestPoints(const Surface& surface) {
  std::vector<std::uint32_t> finite;
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high(-low);
  triangles_.resize(surface.indices.size() / 3);
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    for (std::size_t c = 0; c < 3; ++c) triangles_[t][c] = surface.positions[surface.indices[3 * t + c]];
    if (!is_finite(triangles_[t])) continue;
    finite.push_back(t);
    for (const glm::vec3& corner : triangles_[t]) {
      for (int axis = 0; axis < 3; ++axis) extent_ = std::max<double>(extent_, std::abs(corner[axis]));
      low = glm::min(low, glm::dvec3(corner));
      high = glm::max(high, glm::dvec3(corner));
    }
  }
  if (finite.empty()) return;
  // Far from its origin a surface is small beside the steps of floats there: boxes are small around its middle.
  middle_ = (low + high) / 2.0;
  const glm::dvec3 half = high - middle_;
  int exponent = 0;
  std::frexp(std::max({half.x, half.y, half.z}), &exponent);
  scale_ = std::ldexp(1.0, -exponent);
  const auto scaled = [&](std::uint32_t t) {
    std::array<glm::vec3, 3> corners = triangles_[t];
    for (glm::vec3& corner : corners) corner = glm::vec3((glm::dvec3(corner) - middle_) * scale_);
    return corners;
  };
  constexpr std::size_t most_further = std::size_t{1} << 20;  // boxes, beside one or two for each triangle
  std::vector<std::uint8_t> parts(finite.size());
  std::size_t sum = 0;
  for (std::size_t i = 0; i < finite.size(); ++i) {
    parts[i] = static_cast<std::uint8_t>(boxes_worth_having(scaled(finite[i])));
    sum += parts[i];
  }
  while (sum > 2 * finite.size() + most_further) {
    sum = 0;
    for (std::uint8_t& of : parts) sum += of = static_cast<std::uint8_t>((of + 1) / 2);
  }
  std::vector<BoxTree::Box> boxes;
  std::vector<std::uint32_t> triangle_of;
  boxes.reserve(sum);
  triangle_of.reserve(sum);
  for (std::size_t i = 0; i < finite.size(); ++i) {
    add_part_boxes(scaled(finite[i]), parts[i], boxes);
    triangle_of.resize(boxes.size(), finite[i]);
  }
  BoxTree tree = box_tree(boxes, 1);
  for (BoxTree::Node& node : tree.nodes) {
    for (std::size_t c = 0; c < BoxTree::width; ++c) {
      if (node.count[c] > 0) node.first[c] = triangle_of[tree.order[node.first[c]]];
    }
  }
  nodes_ = std::move(tree.nodes);
}

TriangleCorners ClosestPoints::corners(std::uint32_t triangle) const { return in_doubles(triangles_[triangle]); }

Closest ClosestPoints::nearest(const glm::dvec3& point, std::uint32_t hint) const {
  if (nodes_.empty()) return {};
  const PointAmongBoxes among(point, middle_, scale_);
  std::uint32_t nearest = no_triangle;
  double squared = std::numeric_limits<double>::infinity();
  constexpr float farthest = std::numeric_limits<float>::max();
  float limit = farthest;  // boxes beyond hold nothing that is nearer, or equally near
  const auto try_triangle = [&](std::uint32_t triangle) {
    const double found = squared_distance(corners(triangle), point);
    if (found > squared || (found == squared && triangle >= nearest)) return;
    nearest = triangle;
    squared = found;
    const double scaled = squared * (scale_ * scale_ * (1 + 0x1p-20)) + std::numeric_limits<float>::min();
    limit = scaled < static_cast<double>(farthest) ? static_cast<float>(scaled) : farthest;
  };
  if (hint < triangles_.size() && is_finite(triangles_[hint])) try_triangle(hint);

  struct Waiting {
    std::uint32_t first, is_leaf;
    float squared;
  };
  std::array<Waiting, BoxTree::most_waiting> open;
  std::size_t waiting = 0;
  open[waiting++] = {0, 0, 0};
  while (waiting > 0) {
    const Waiting next = open[--waiting];
    if (next.squared > limit) continue;
    if (next.is_leaf != 0) {
      if (next.first != hint && next.first != nearest) try_triangle(next.first);
      continue;
    }
    const BoxTree::Node& node = nodes_[next.first];
    const Four away = among.squared_distance(node);
    // The nearest child first.
    const std::size_t bottom = waiting;
    for (std::size_t c = 0; c < BoxTree::width; ++c) {
      if (!(away[c] <= limit)) continue;
      std::size_t to = waiting++;
      for (; to > bottom && open[to - 1].squared < away[c]; --to) open[to] = open[to - 1];
      open[to] = {node.first[c], node.count[c], away[c]};
    }
  }
  Closest result = closest_on(corners(nearest), point);
  result.triangle = nearest;
  return result;
}

std::shared_ptr<const ClosestPoints> closest_points_of(Analyses& analyses, const VertexStreams& vertices,
                                                       const Shared<std::uint32_t>& indices) {
  const auto positions = positions_of(analyses, vertices);
  const Stamp parts[] = {content_hash(std::span(positions->values)), indices.stamp()};
  return analyses.get<ClosestPoints>(combine(parts), [&] {
    return ClosestPoints({positions->values, indices.view()});
  });
}

}  // namespace foredraw

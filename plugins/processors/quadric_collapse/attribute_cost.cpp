#include "attribute_cost.h"
#include "local_distance.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <utility>

namespace foredraw::processors::quadric_collapse {

void AttributeCosts::measure(std::uint32_t f) {
  if (empty()) return;
  constexpr double flattest = 0.01;  // in slivers differences across would count without bounds
  const Face& face = mesh_.face(f);
  const glm::dvec3 from(mesh_.point(face.point[0]).place), normal = mesh_.plane(f).normal;
  const glm::dvec3 one = glm::dvec3(mesh_.point(face.point[1]).place) - from;
  const glm::dvec3 two = glm::dvec3(mesh_.point(face.point[2]).place) - from;
  const double longest = flattest * std::max({dot(one, one), dot(two, two), dot(two - one, two - one)});
  const double squared = std::max(dot(normal, normal), longest * longest), area = mesh_.plane(f).area();
  const glm::dvec3 to_one = cross(two, normal) / squared, to_two = cross(normal, one) / squared;
  const float* here = rows_.of(face.vertex[0]);
  const float* there = rows_.of(face.vertex[1]);
  const float* beyond = rows_.of(face.vertex[2]);
  glm::dvec3* slopes = slopes_.data() + f * rows_.width;
  Symmetric solved, blended;
  for (std::size_t i = 0; i < rows_.width && area > 0; ++i) {
    const double value = here[i];
    slopes[i] = to_one * (there[i] - value) + to_two * (beyond[i] - value);
    (i < solved_ ? solved : blended).add(slopes[i], area);
  }
  if (!squares_.empty()) squares_[f] = solved;
  if (!blended_squares_.empty()) blended_squares_[f] = blended;
}

void AttributeCosts::add_up(std::uint32_t point) {
  if (changes_[point] == mesh_.changes(point).faces) return;
  changes_[point] = mesh_.changes(point).faces;
  const std::size_t width = rows_.width;
  constexpr std::uint32_t none = ~std::uint32_t{0};
  std::uint32_t before = none;
  const auto each_face = [&](const auto& see) {
    for (const std::uint32_t f : mesh_.ring(point)) see(f, mesh_.face(f).vertex[mesh_.face(f).corner_of(point)]);
  };
  each_face([&](std::uint32_t, std::uint32_t vertex) {
    if (vertex == std::exchange(before, vertex)) return;
    sums_[vertex] = {};
    std::fill_n(sums_by_number_.data() + vertex * width, width, glm::dvec3(0));
  });
  each_face([&](std::uint32_t f, std::uint32_t vertex) {
    const double area = mesh_.plane(f).area();
    if (!(area > 0)) return;
    Sums& sum = sums_[vertex];
    sum.area += area;
    if (!squares_.empty()) sum.squares.add(squares_[f]);
    if (!blended_squares_.empty()) sum.squares.add(blended_squares_[f]);
    glm::dvec3* by_number = sums_by_number_.data() + vertex * width;
    const glm::dvec3* slopes = slopes_.data() + f * width;
    for (std::size_t i = 0; i < width; ++i) by_number[i] += slopes[i] * area;
  });
}

struct AttributeCosts::Edge {
  std::uint32_t p, q;
  std::span<const std::uint32_t> shared;
  glm::dvec3 along{0};  ///< from p to q
  glm::dvec3 step{0};   ///< along, by its length squared
};

/// Vertices at both ends that become one.
struct AttributeCosts::Ends {
  std::uint32_t at_p, at_q;
};

/// Seen from p, faces at p say s.x of their slopes s, and faces at q difference + s.(x - along). Along the edge a
/// blended attribute grows by its difference for each `step`.
void AttributeCosts::add_wedge(const Ends& ends, const Edge& edge, Quadric& from_p, Quadric& from_q) const {
  const Sums &of_p = sums_[ends.at_p], &of_q = sums_[ends.at_q];
  const glm::dvec3* by_p = sums_by_number_.data() + ends.at_p * rows_.width;
  const glm::dvec3* by_q = sums_by_number_.data() + ends.at_q * rows_.width;
  const float* here = rows_.of(ends.at_p);
  const float* there = rows_.of(ends.at_q);
  from_p.matrix.add(of_p.squares);
  from_q.matrix.add(of_q.squares);
  // What both have counts once where it is solved for. Both lie on it.
  std::array<std::uint32_t, 2> both;
  std::size_t count = 0;
  double area_q = of_q.area;
  for (const std::uint32_t f : edge.shared) {
    const Face& face = mesh_.face(f);
    const double area = mesh_.plane(f).area();
    if (!(area > 0) || count == both.size() || face.vertex[face.corner_of(edge.q)] != ends.at_q) continue;
    both[count++] = f;
    area_q -= area;
    if (!squares_.empty()) from_q.matrix.add(squares_[f], -1);
  }
  const double area = of_p.area + area_q, share = area > 0 ? 1 / area : 0;
  for (std::size_t i = 0; i < solved_; ++i) {
    const double difference = double{there[i]} - here[i];
    glm::dvec3 slopes_q = by_q[i];
    for (std::size_t k = 0; k < count; ++k) {
      slopes_q -= slopes_[both[k] * rows_.width + i] * mesh_.plane(both[k]).area();
    }
    from_q.vector -= slopes_q * difference;
    from_q.constant += area_q * difference * difference;
    from_p.subtract_square(by_p[i] + slopes_q, area_q * difference - dot(slopes_q, edge.along), share);
  }
  if (solved_ == rows_.width) return;
  glm::dvec3 mixed_p(0), mixed_q(0);
  double squared = 0;
  for (std::size_t i = solved_; i < rows_.width; ++i) {
    const double difference = double{there[i]} - here[i];
    mixed_p += by_p[i] * difference;
    mixed_q += by_q[i] * difference;
    squared += difference * difference;
  }
  from_p.matrix.add(edge.step, of_p.area * squared);
  from_q.matrix.add(edge.step, of_q.area * squared);
  from_p.matrix.add_both(-mixed_p, edge.step);
  from_q.matrix.add_both(-mixed_q, edge.step);
}

/// A vertex that no face joins to one of the other point. What is blended stays as it is.
void AttributeCosts::add_alone(std::uint32_t vertex, Quadric& from) const {
  const Sums& of = sums_[vertex];
  if (!(of.area > 0)) return;
  from.matrix.add(of.squares);
  const glm::dvec3* by_number = sums_by_number_.data() + vertex * rows_.width;
  for (std::size_t i = 0; i < solved_; ++i) from.matrix.add(by_number[i], -1 / of.area);
}

Quadric AttributeCosts::around(std::uint32_t p, std::uint32_t q, std::span<const std::uint32_t> shared) {
  add_up(p), add_up(q);
  const glm::dvec3 along = glm::dvec3(mesh_.point(q).place) - glm::dvec3(mesh_.point(p).place);
  const double length = dot(along, along);
  const Edge edge{p, q, shared, along, length > 0 ? along / length : glm::dvec3(0)};
  Quadric from_p, from_q;
  const auto ends_in = [&](std::uint32_t f) {
    const Face& face = mesh_.face(f);
    return Ends{face.vertex[face.corner_of(p)], face.vertex[face.corner_of(q)]};
  };
  std::bitset<LocalDistance::most_faces> joins;  // [i]: whether that face joins its vertices, one to one
  const std::size_t faces = std::min(shared.size(), joins.size());
  const auto is_joined = [&](auto end, std::uint32_t vertex) {
    for (std::size_t i = 0; i < faces; ++i) {
      if (joins[i] && ends_in(shared[i]).*end == vertex) return true;
    }
    return false;
  };
  for (std::size_t i = 0; i < faces; ++i) {
    const Ends ends = ends_in(shared[i]);
    if (is_joined(&Ends::at_p, ends.at_p) || is_joined(&Ends::at_q, ends.at_q)) continue;
    joins.set(i);
    add_wedge(ends, edge, from_p, from_q);
  }
  for (const std::uint32_t point : {p, q}) {
    if (!mesh_.point(point).is_sharp) continue;
    const std::span<const std::uint32_t> ring = mesh_.ring(point);
    const auto vertex_in = [&](std::uint32_t f) { return mesh_.face(f).vertex[mesh_.face(f).corner_of(point)]; };
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::uint32_t vertex = vertex_in(ring[i]);
      const bool is_known = std::ranges::any_of(ring.first(i), [&](std::uint32_t f) { return vertex_in(f) == vertex; });
      if (is_known || is_joined(point == p ? &Ends::at_p : &Ends::at_q, vertex)) continue;
      add_alone(vertex, point == p ? from_p : from_q);
    }
  }
  from_p.add_about(from_q, along);
  return from_p;
}

}  // namespace foredraw::processors::quadric_collapse

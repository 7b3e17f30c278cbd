#include "attribute_cost.h"

#include <algorithm>

namespace foredraw::collapsing {

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
  squares_[f] = {};
  if (!(area > 0)) return;
  for (std::size_t i = 0; i < rows_.width; ++i) {
    const double value = here[i];
    slopes[i] = to_one * (there[i] - value) + to_two * (beyond[i] - value);
    squares_[f].add(slopes[i], area);
  }
}

const AttributeCosts::Sums& AttributeCosts::sums_at(std::uint32_t point) {
  Sums& sum = sums_[point];
  if (sum.changes == mesh_.changes(point).faces) return sum;
  sum = {mesh_.changes(point).faces, 0, {}};
  glm::dvec3* by_number = sums_by_number_.data() + point * rows_.width;
  std::fill_n(by_number, rows_.width, glm::dvec3(0));
  for (const std::uint32_t f : mesh_.ring(point)) {
    const double area = mesh_.plane(f).area();
    if (!(area > 0)) continue;
    sum.area += area;
    sum.squares.add(squares_[f]);
    const glm::dvec3* slopes = slopes_.data() + f * rows_.width;
    for (std::size_t i = 0; i < rows_.width; ++i) by_number[i] += slopes[i] * area;
  }
  return sum;
}

/// Along the edge an attribute grows by its difference for each `step`. What faces say beyond that is squared.
Symmetric AttributeCosts::around_smooth(std::uint32_t at, std::uint32_t other, const glm::dvec3& step, Both shared) {
  const Sums& sum = sums_at(at);
  const glm::dvec3* by_number = sums_by_number_.data() + at * rows_.width;
  const Face& between = mesh_.face(shared.front());
  const float* here = rows_.of(between.vertex[between.corner_of(at)]);
  const float* there = rows_.of(between.vertex[between.corner_of(other)]);
  glm::dvec3 mixed(0);
  double squared = 0;
  for (std::size_t i = 0; i < rows_.width; ++i) {
    const double difference = double{there[i]} - here[i];
    mixed += by_number[i] * difference;
    squared += difference * difference;
  }
  Symmetric matrix = sum.squares;
  matrix.add(step, sum.area * squared);
  matrix.add_both(-mixed, step);
  return matrix;
}

/// The same where vertices differ from face to face. A vertex that no face joins to one of the other point stays as it
/// is.
Symmetric AttributeCosts::around_sharp(std::uint32_t at, std::uint32_t other, const glm::dvec3& step,
                                       Both shared) const {
  Symmetric matrix;
  for (const std::uint32_t f : mesh_.ring(at)) {
    const double area = mesh_.plane(f).area();
    if (!(area > 0)) continue;
    const std::uint32_t own = mesh_.face(f).vertex[mesh_.face(f).corner_of(at)];
    std::uint32_t becomes = own;
    for (const std::uint32_t g : shared) {
      const Face& between = mesh_.face(g);
      if (between.vertex[between.corner_of(at)] == own) becomes = between.vertex[between.corner_of(other)];
    }
    const float* here = rows_.of(own);
    const float* there = rows_.of(becomes);
    const glm::dvec3* slopes = slopes_.data() + f * rows_.width;
    for (std::size_t i = 0; i < rows_.width; ++i) matrix.add(slopes[i] - step * (double{there[i]} - here[i]), area);
  }
  return matrix;
}

Symmetric AttributeCosts::around(std::uint32_t at, std::uint32_t other, Both shared) {
  const glm::dvec3 along = glm::dvec3(mesh_.point(other).place) - glm::dvec3(mesh_.point(at).place);
  const double length = dot(along, along);
  const glm::dvec3 step = length > 0 ? along / length : glm::dvec3(0);
  return mesh_.point(at).is_sharp ? around_sharp(at, other, step, shared) : around_smooth(at, other, step, shared);
}

void AttributeCosts::blend(std::span<const VertexPair> pairs, float blend) {
  for (const VertexPair& pair : pairs) {
    float* to = rows_.of(pair.kept);
    const float* from = rows_.of(pair.removed);
    for (std::size_t i = 0; i < rows_.width; ++i) to[i] += (from[i] - to[i]) * blend;
  }
}

}  // namespace foredraw::collapsing

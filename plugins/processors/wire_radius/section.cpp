#include "section.h"

#include "hull_boxes.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace foredraw::processors::wire_radius {

namespace {

/// Two directions square to this one and to each other.
std::array<glm::dvec3, 2> square_to(const glm::dvec3& normal) {
  const glm::dvec3 size = glm::abs(normal);
  const glm::dvec3 other = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
                           : size.y <= size.z                   ? glm::dvec3(0, 1, 0)
                                                                : glm::dvec3(0, 0, 1);
  const glm::dvec3 u = glm::normalize(glm::cross(normal, other));
  return {u, glm::cross(normal, u)};
}

}  // namespace

double Plane::height(const glm::dvec3& point) const { return glm::dot(point - at, normal); }

bool Cutter::crosses(std::uint32_t triangle, const Plane& plane) const {
  const auto& [a, b, c] = mesh_.triangles[triangle];
  const bool first = plane.height(mesh_.points[a]) >= 0;
  return first != (plane.height(mesh_.points[b]) >= 0) || first != (plane.height(mesh_.points[c]) >= 0);
}

std::uint32_t Cutter::walk(std::uint32_t triangle, const Plane& plane, std::size_t most_steps) const {
  // At an end of the surface the way leads round the end, and no nearer to the plane.
  constexpr std::size_t most_in_vain = 32;
  double nearest = std::numeric_limits<double>::infinity();
  std::uint32_t before = none;
  for (std::size_t step = 0, in_vain = 0; step < most_steps && in_vain < most_in_vain; ++step, ++in_vain) {
    double heights[3];
    int above = 0;
    for (int i = 0; i < 3; ++i) {
      heights[i] = plane.height(mesh_.points[mesh_.triangles[triangle][static_cast<std::size_t>(i)]]);
      above += heights[i] >= 0;
    }
    if (above == 1 || above == 2) return triangle;
    for (const double height : heights) {
      if (std::abs(height) < nearest) in_vain = 0;
      nearest = std::min(nearest, std::abs(height));
    }
    std::uint32_t next = none;
    double least = 0;
    for (std::size_t e = 0; e < 3; ++e) {
      const std::uint32_t other = mesh_.across[triangle][e];
      const double away = std::abs(heights[e] + heights[(e + 1) % 3]);
      if (other == none || other == before || (next != none && away >= least)) continue;
      next = other;
      least = away;
    }
    if (next == none) return none;
    before = triangle;
    triangle = next;
  }
  return none;
}

/// From the triangle across that edge, and on; `outline` gets a point for each edge.
bool Cutter::trace(std::uint32_t triangle, std::uint32_t edge, const Plane& plane, double most_perimeter,
                   std::size_t most_steps, std::vector<glm::dvec3>& outline, bool& closed) {
  const std::uint32_t start = triangle;
  outline.clear();
  closed = false;
  double way = 0;
  std::uint32_t from = mesh_.triangles[triangle][edge], to = mesh_.triangles[triangle][(edge + 1) % 3];
  double below = plane.height(mesh_.points[from]), above = plane.height(mesh_.points[to]);
  for (;;) {
    outline.push_back(mesh_.points[from] + (mesh_.points[to] - mesh_.points[from]) * (below / (below - above)));
    if (outline.size() > 1) way += glm::distance(outline[outline.size() - 2], outline.back());
    const std::uint32_t next = mesh_.across[triangle][edge];
    if (next == none) {
      const glm::dvec3 border = mesh_.points[to] - mesh_.points[from];
      borders_ += glm::normalize(above >= 0 ? border : -border);
      return true;
    }
    if (next == start) {
      closed = true;
      return true;
    }
    if (triangles_.size() >= most_steps || way > most_perimeter) return false;
    triangles_.push_back(next);
    // Out by one of the two edges at the corner that is new.
    const auto& corners = mesh_.triangles[next];
    std::uint32_t third = 0;
    while (corners[third] == from || corners[third] == to) ++third;
    const double height = plane.height(mesh_.points[corners[third]]);
    const std::uint32_t after = corners[(third + 1) % 3];
    const double height_after = after == from ? below : above;
    triangle = next;
    if ((height >= 0) != (height_after >= 0)) {
      edge = third;
      from = corners[third];
      to = after;
      below = height;
      above = height_after;
    } else {
      edge = (third + 2) % 3;
      below = after == from ? above : below;
      from = corners[edge];
      to = corners[third];
      above = height;
    }
  }
}

bool Cutter::cut(std::uint32_t triangle, const Plane& plane, std::size_t most_steps, double most_perimeter) {
  triangles_.assign(1, triangle);
  std::uint32_t out[2] = {none, none};
  const auto& corners = mesh_.triangles[triangle];
  for (std::uint32_t e = 0; e < 3; ++e) {
    const bool from = plane.height(mesh_.points[corners[e]]) >= 0;
    const bool to = plane.height(mesh_.points[corners[(e + 1) % 3]]) >= 0;
    if (from != to) (out[0] == none ? out[0] : out[1]) = e;
  }
  if (out[1] == none) return false;
  borders_ = glm::dvec3(0);
  bool closed = false;
  if (!trace(triangle, out[0], plane, most_perimeter, most_steps, outline_, closed)) return false;
  section_.closed = closed;
  if (!closed) {
    if (!trace(triangle, out[1], plane, most_perimeter, most_steps, backwards_, closed)) return false;
    std::ranges::reverse(backwards_);
    outline_.insert(outline_.begin(), backwards_.begin(), backwards_.end());
  }
  measure_line(plane);
  return section_.perimeter <= most_perimeter;
}

void Cutter::measure_line(const Plane& plane) {
  const std::array<glm::dvec3, 2> axes = square_to(plane.normal);
  at_ = plane.at;
  across_[0] = axes[0];
  across_[1] = axes[1];
  flat_.clear();
  for (const glm::dvec3& point : outline_) {
    flat_.emplace_back(glm::dot(point - plane.at, across_[0]), glm::dot(point - plane.at, across_[1]));
  }
  section_.perimeter = area_ = 0;
  middle_ = of_line_ = glm::dvec2(0);
  for (std::size_t i = 0; i + (section_.closed ? 0 : 1) < flat_.size(); ++i) {
    const glm::dvec2 a = flat_[i], b = flat_[(i + 1) % flat_.size()];
    const double length = glm::distance(a, b), doubled = a.x * b.y - a.y * b.x;
    section_.perimeter += length;
    of_line_ += (a + b) * (length / 2);
    area_ += doubled / 2;
    middle_ += (a + b) * (doubled / 6);
  }
  const double round = section_.perimeter * section_.perimeter / (4 * std::numbers::pi);
  section_.roundness = section_.closed && round > 0 ? std::abs(area_) / round : 0;
  has_widths_ = false;
}

const Section& Cutter::section() {
  if (!has_widths_) measure_widths();
  return section_;
}

glm::dvec3 Cutter::centre() {
  return section_.closed && section_.roundness > 1e-3 ? in_space(middle_ / area_) : section().centre;
}

void Cutter::measure_widths() {
  has_widths_ = true;
  const glm::dvec2 first = flat_.front();
  if (!section_.closed || !convex_polygon(flat_, area_ > 0, hull_)) convex_hull(flat_, hull_);
  section_.least = section_.greatest = 0;
  HullBox least_box;
  std::size_t least_edge = 0;
  glm::dvec2 across(1, 0);
  // Of a hull with many edges a part is enough: next to each other, they differ little.
  constexpr std::size_t enough_edges = 24;
  const std::size_t stride = std::max<std::size_t>(1, hull_.size() / enough_edges);
  HullBoxes boxes(hull_);
  for (std::size_t e = 0; e < hull_.size() && hull_.size() > 1; e += stride) {
    const HullBox box = boxes.at(e);
    if (e == 0 || box.depth < least_box.depth) {
      least_box = box;
      least_edge = e;
    }
    if (box.depth > 2 * section_.greatest) {
      section_.greatest = box.depth / 2;
      across = {-box.along.y, box.along.x};
    }
    if (box.high - box.low > 2 * section_.greatest) {
      section_.greatest = (box.high - box.low) / 2;
      across = box.along;
    }
  }
  section_.least = least_box.depth / 2;
  section_.across = across.x * across_[0] + across.y * across_[1];
  if (section_.closed && section_.roundness > 1e-3) {
    section_.centre = in_space(middle_ / area_);
  } else if (hull_.size() > 1 && !section_.closed) {
    const glm::dvec2 inwards(-least_box.along.y, least_box.along.x);
    section_.centre = in_space(hull_[least_edge] + least_box.along * ((least_box.low + least_box.high) / 2) +
                               inwards * (least_box.depth / 2));
  } else {
    section_.centre = in_space(section_.perimeter > 0 ? of_line_ / section_.perimeter : first);
  }
  section_.opening = glm::dvec3(0);
  if (!section_.closed && section_.perimeter > 0) {
    const glm::dvec3 way = section_.centre - in_space(of_line_ / section_.perimeter);
    const double length = glm::length(way);
    if (length > 1e-3 * section_.greatest) section_.opening = way / length;
  }
}

glm::dvec3 Cutter::axis(const Plane& plane) const {
  if (!section_.closed) {
    const double length = glm::length(borders_);
    return length > 0 ? borders_ / length : plane.normal;
  }
  glm::dmat3 normals(0);
  double sum = 0;
  for (const std::uint32_t t : triangles_) {
    const auto& [a, b, c] = mesh_.triangles[t];
    const glm::dvec3 normal = glm::cross(mesh_.points[b] - mesh_.points[a], mesh_.points[c] - mesh_.points[a]);
    const double length = glm::length(normal);
    if (!(length > 0)) continue;
    // The part of the section that lies in this triangle.
    const glm::dvec3 line = glm::cross(normal / length, plane.normal);
    double low = 0, high = 0;
    bool is_first = true;
    for (std::size_t e = 0; e < 3; ++e) {
      const glm::dvec3 &from = mesh_.points[mesh_.triangles[t][e]], &to = mesh_.points[mesh_.triangles[t][(e + 1) % 3]];
      const double below = plane.height(from), above = plane.height(to);
      if ((below >= 0) == (above >= 0)) continue;
      const double at = glm::dot(from + (to - from) * (below / (below - above)) - plane.at, line);
      low = is_first ? at : std::min(low, at);
      high = is_first ? at : std::max(high, at);
      is_first = false;
    }
    const glm::dvec3 unit = normal / length;
    normals += glm::outerProduct(unit, unit) * (high - low);
    sum += high - low;
  }
  if (!(sum > 0)) return plane.normal;
  // Inverse iteration; where normals are all alike, it stays next to the plane's.
  normals = normals / sum + glm::dmat3(0.01);
  const double determinant = glm::dot(normals[0], glm::cross(normals[1], normals[2]));
  if (!(determinant > 0)) return plane.normal;
  glm::dvec3 axis = plane.normal;
  for (int i = 0; i < 3; ++i) {
    axis = glm::normalize(glm::dvec3(glm::dot(glm::cross(normals[1], normals[2]), axis),
                                     glm::dot(glm::cross(normals[2], normals[0]), axis),
                                     glm::dot(glm::cross(normals[0], normals[1]), axis)));
  }
  return glm::dot(axis, plane.normal) < 0 ? -axis : axis;
}

double Cutter::next_corner(const Plane& plane) const {
  double next = 0;
  bool is_first = true;
  for (const std::uint32_t t : triangles_) {
    for (const std::uint32_t point : mesh_.triangles[t]) {
      const double height = plane.height(mesh_.points[point]);
      if (height < 0 || (!is_first && height >= next)) continue;
      next = height;
      is_first = false;
    }
  }
  return next;
}

}  // namespace foredraw::processors::wire_radius

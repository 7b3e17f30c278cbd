#include "collapsing_mesh.h"

#include <foredraw/analysis/welded_positions.h>

#include <algorithm>
#include <cmath>

namespace foredraw::collapsing {

CollapsingMesh::CollapsingMesh(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices) {
  const std::vector<std::uint32_t> first = welded(positions);
  std::vector<std::uint32_t> point_of(positions.size(), 0);
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    if (first[v] == v) {
      point_of[v] = static_cast<std::uint32_t>(names_.size());
      names_.push_back(v);
    } else {
      point_of[v] = point_of[first[v]];
    }
  }
  points_.resize(names_.size());
  changes_.resize(names_.size());
  marks_.resize(names_.size(), 0);
  slots_.resize(names_.size());
  for (std::size_t p = 0; p < points_.size(); ++p) {
    points_[p].place = positions[names_[p]];
    const glm::vec3& at = points_[p].place;
    points_[p].is_fixed = !(std::isfinite(at.x) && std::isfinite(at.y) && std::isfinite(at.z));
  }
  faces_.reserve(indices.size() / 3);
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    Face face;
    for (int k = 0; k < 3; ++k) {
      face.vertex[k] = indices[i + k];
      face.point[k] = point_of[indices[i + k]];
    }
    if (face.point[0] == face.point[1] || face.point[1] == face.point[2] || face.point[2] == face.point[0]) continue;
    for (const std::uint32_t p : face.point) ++points_[p].size;
    faces_.push_back(face);
  }
  planes_.resize(faces_.size());
  for (std::uint32_t f = 0; f < faces_.size(); ++f) measure(f);
  alive_ = faces_.size();
  std::uint32_t end = 0;
  for (Point& point : points_) {
    point.first = end;
    point.room = point.size;
    end += point.size;
    point.size = 0;
  }
  rings_.resize(end);
  for (std::uint32_t f = 0; f < faces_.size(); ++f) {
    for (const std::uint32_t p : faces_[f].point) rings_[points_[p].first + points_[p].size++] = f;
  }
}

void CollapsingMesh::measure(std::uint32_t f) {
  const Face& face = faces_[f];
  const glm::dvec3 a(points_[face.point[0]].place);
  const glm::dvec3 normal =
      cross(glm::dvec3(points_[face.point[1]].place) - a, glm::dvec3(points_[face.point[2]].place) - a);
  const double length = std::sqrt(dot(normal, normal));
  const bool has_area = length > 0 && std::isfinite(length);
  planes_[f] = has_area ? FacePlane{normal, 0.5 / length} : FacePlane{};
}

void CollapsingMesh::drop(std::uint32_t point, std::uint32_t face) {
  Point& at = points_[point];
  std::uint32_t* ring = rings_.data() + at.first;
  for (std::uint32_t i = 0; i < at.size; ++i) {
    if (ring[i] != face) continue;
    for (++i; i < at.size; ++i) ring[i - 1] = ring[i];
    --at.size;
  }
  ++changes_[point].faces;
}

void CollapsingMesh::append(std::uint32_t point, std::uint32_t face) {
  Point& at = points_[point];
  if (at.size == at.room) {
    const std::uint32_t room = at.size + at.size / 2 + 4;
    const auto first = static_cast<std::uint32_t>(rings_.size());
    rings_.resize(rings_.size() + room);
    std::copy_n(rings_.begin() + at.first, at.size, rings_.begin() + first);
    at.first = first;
    at.room = room;
  }
  rings_[at.first + at.size++] = face;
}

std::span<const Neighbour> CollapsingMesh::neighbours(std::uint32_t p) {
  ++mark_;
  std::uint32_t count = 0;
  found_.resize(std::max<std::size_t>(found_.size(), 2 * ring(p).size()));
  for (const std::uint32_t f : ring(p)) {
    const Face& face = faces_[f];
    const int k = face.corner_of(p);
    for (const int other : {k == 2 ? 0 : k + 1, k == 0 ? 2 : k - 1}) {
      const std::uint32_t q = face.point[other];
      if (marks_[q] != mark_) {
        marks_[q] = mark_;
        slots_[q] = count;
        found_[count++] = {q, 0, {}};
      }
      Neighbour& one = found_[slots_[q]];
      if (one.faces < 2) one.shared[one.faces] = f;
      ++one.faces;
    }
  }
  return {found_.data(), count};
}

void CollapsingMesh::shared_faces(std::uint32_t p, std::uint32_t q, std::vector<std::uint32_t>& shared) const {
  shared.clear();
  const bool from_p = points_[p].size <= points_[q].size;
  const std::uint32_t other = from_p ? q : p;
  for (const std::uint32_t f : ring(from_p ? p : q)) {
    if (faces_[f].has(other)) shared.push_back(f);
  }
}

void CollapsingMesh::mark_neighbours(std::uint32_t p) {
  ++mark_;
  for (const std::uint32_t f : ring(p)) {
    for (const std::uint32_t q : faces_[f].point) marks_[q] = mark_;
  }
}

}  // namespace foredraw::collapsing

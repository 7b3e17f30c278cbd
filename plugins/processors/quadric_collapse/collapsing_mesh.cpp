#include "collapsing_mesh.h"

#include "mesh_pieces.h"

#include <foredraw/analysis/welded_positions.h>
#include <foredraw/geometry/finite.h>

#include <algorithm>
#include <cmath>

namespace foredraw::processors::quadric_collapse {

namespace {

/// Which vertices are the first ones at their place.
std::vector<std::uint32_t> first_vertices(std::span<const std::uint32_t> first) {
  std::vector<std::uint32_t> names;
  for (std::uint32_t v = 0; v < first.size(); ++v) {
    if (first[v] == v) names.push_back(v);
  }
  return names;
}

}  // namespace

CollapsingMesh::CollapsingMesh(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                               std::size_t piece) {
  const std::vector<std::uint32_t> first = welded(positions);
  const std::vector<std::uint32_t> names = first_vertices(first);
  std::vector<glm::vec3> places(names.size());
  std::ranges::transform(names, places.begin(), [&](std::uint32_t v) { return positions[v]; });
  const MeshPieces pieces = mesh_pieces(places, piece);
  first_ = pieces.first;
  points_.resize(names.size());
  names_.resize(names.size());
  pieces_.resize(names.size());
  changes_.resize(names.size());
  is_rim_.resize(names.size(), 1);
  std::vector<std::uint32_t> point_of(positions.size(), 0);
  for (std::uint32_t i = 0, p = 0; i < piece_count(); ++i) {
    for (; p < first_[i + 1]; ++p) {
      const std::uint32_t was = pieces.points[p];
      const glm::vec3& at = points_[p].place = places[was];
      points_[p].is_fixed = !is_finite(at);
      names_[p] = names[was];
      pieces_[p] = i;
      point_of[names[was]] = p;
    }
  }

  const auto face_at = [&](std::size_t i) {
    Face face;
    for (int k = 0; k < 3; ++k) {
      face.vertex[k] = indices[i + k];
      face.point[k] = point_of[first[indices[i + k]]];
    }
    return face;
  };
  const auto is_face = [](const Face& face) {
    return face.point[0] != face.point[1] && face.point[1] != face.point[2] && face.point[2] != face.point[0];
  };
  // Faces lie with the piece of their first corner.
  std::vector<std::uint32_t> next(piece_count() + 1, 0);
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const Face face = face_at(i);
    if (!is_face(face)) continue;
    for (const std::uint32_t p : face.point) ++points_[p].size;
    ++next[pieces_[face.point[0]] + 1];
  }
  for (std::size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
  faces_.resize(next.back());
  planes_.resize(next.back());
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const Face face = face_at(i);
    if (is_face(face)) faces_[next[pieces_[face.point[0]]]++] = face;
  }
  rings_.resize(3 * faces_.size());
  std::uint32_t* end = rings_.data();
  for (Point& point : points_) {
    point.faces = end;
    point.room = point.size;
    end += point.size;
    point.size = 0;
  }
  for (std::uint32_t f = 0; f < faces_.size(); ++f) {
    measure(f);
    for (const std::uint32_t p : faces_[f].point) points_[p].faces[points_[p].size++] = f;
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

void CollapsingMesh::shared_faces(std::uint32_t p, std::uint32_t q, std::vector<std::uint32_t>& shared) const {
  shared.clear();
  const bool from_p = points_[p].size <= points_[q].size;
  const std::uint32_t other = from_p ? q : p;
  for (const std::uint32_t f : ring(from_p ? p : q)) {
    if (faces_[f].has(other)) shared.push_back(f);
  }
}

bool CollapsingMesh::touches_others(std::uint32_t p) const {
  return std::ranges::any_of(ring(p), [&](std::uint32_t f) {
    return std::ranges::any_of(faces_[f].point, [&](std::uint32_t q) { return pieces_[q] != pieces_[p]; });
  });
}

void CollapsingMesh::find_rim(std::size_t piece) {
  if (piece_count() == 1) return;
  for (std::uint32_t p = first_[piece]; p < first_[piece + 1]; ++p) {
    is_rim_[p] = is_rim_[p] && !points_[p].is_gone && touches_others(p);
  }
}

void CollapsingMesh::join_pieces() {
  for (std::uint32_t& piece : pieces_) piece /= 2;
  for (std::size_t i = 0; 2 * i < first_.size(); ++i) first_[i] = first_[2 * i];
  first_.resize(first_.size() / 2 + 1);
  if (piece_count() == 1) std::ranges::fill(is_rim_, 1);
}

void MeshEditor::drop(std::uint32_t point, std::uint32_t face) {
  Point& at = mesh_.points_[point];
  std::uint32_t* const end = at.faces + at.size;
  std::uint32_t* const found = std::find(at.faces, end, face);
  std::copy(found + 1, end, found);
  --at.size;
  ++mesh_.changes_[point].faces;
}

void MeshEditor::append(std::uint32_t point, std::uint32_t face) {
  Point& at = mesh_.points_[point];
  if (at.size == at.room) {
    at.room = at.size + at.size / 2 + 4;
    auto* roomier =
        static_cast<std::uint32_t*>(memory_.allocate(at.room * sizeof(std::uint32_t), alignof(std::uint32_t)));
    std::copy_n(at.faces, at.size, roomier);
    at.faces = roomier;
  }
  at.faces[at.size++] = face;
}

void MeshEditor::find_rim_around(std::uint32_t p) {
  if (mesh_.piece_count() == 1) return;
  for (const std::uint32_t f : mesh_.ring(p)) {
    for (const std::uint32_t q : mesh_.faces_[f].point) mesh_.is_rim_[q] = mesh_.touches_others(q);
  }
}

std::span<const Neighbour> MeshEditor::neighbours(std::uint32_t p, bool in_piece) {
  mark_ += marks_;
  std::uint32_t count = 0;
  found_.resize(std::max<std::size_t>(found_.size(), 2 * mesh_.ring(p).size()));
  for (const std::uint32_t f : mesh_.ring(p)) {
    const Face& face = mesh_.faces_[f];
    const int k = face.corner_of(p);
    for (const int other : {k == 2 ? 0 : k + 1, k == 0 ? 2 : k - 1}) {
      if (in_piece && mesh_.pieces_[face.point[other]] != mesh_.pieces_[p]) continue;
      Point& q = mesh_.points_[face.point[other]];
      if (q.mark != mark_) {
        q.mark = mark_;
        q.slot = count;
        found_[count++] = {face.point[other], 0, {}};
      }
      Neighbour& one = found_[q.slot];
      if (one.faces < 2) one.shared[one.faces] = f;
      ++one.faces;
    }
  }
  return {found_.data(), count};
}

void MeshEditor::mark_neighbours(std::uint32_t p) {
  mark_ += marks_;
  for (const std::uint32_t f : mesh_.ring(p)) {
    for (const std::uint32_t q : mesh_.faces_[f].point) mesh_.points_[q].mark = mark_;
  }
}

}  // namespace foredraw::processors::quadric_collapse

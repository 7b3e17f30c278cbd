#pragma once
// A triangle mesh that loses one edge after the other. Points are what lies at one place; the vertices there differ in
// attributes, and triangles name both.

#include "symmetric.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace foredraw::collapsing {

struct Face {
  std::array<std::uint32_t, 3> point{};
  std::array<std::uint32_t, 3> vertex{};

  /// Which corner the point is.
  int corner_of(std::uint32_t p) const { return point[0] == p ? 0 : point[1] == p ? 1 : 2; }
  bool has(std::uint32_t p) const { return point[0] == p || point[1] == p || point[2] == p; }
};

/// Of a face.
struct FacePlane {
  glm::dvec3 normal{0};  ///< its length is twice the area
  double weight = 0;     ///< weight * normal normal^T measures area * distance^2; 0: has no area

  double area() const { return weight > 0 ? 0.25 / weight : 0; }
};

/// Two cache lines.
struct alignas(128) Point {
  glm::vec3 place{0};
  std::uint32_t first = 0, size = 0, room = 0;  ///< its faces in the mesh's `rings`
  bool is_gone = false;
  bool is_fixed = false;  ///< stays: it is not finite
  bool is_sharp = false;  ///< some edge here is of one face, of more than two, or of unlike vertices
  Quadric memory;         ///< of the planes of all faces that ever were; about its place
};

/// How often something happened to a point: entries of a queue that are older are known by it.
struct Changes {
  std::uint32_t moves = 0;  ///< it took another's place, or went
  std::uint32_t faces = 0;  ///< a face here changed
};

/// A point that another has an edge to, and the faces of that edge.
struct Neighbour {
  std::uint32_t point = 0;
  std::uint32_t faces = 0;                ///< how many
  std::array<std::uint32_t, 2> shared{};  ///< the first two
};

class CollapsingMesh {
 public:
  /// Positions of vertices; three indices a triangle. Triangles with two corners at one place are left out.
  CollapsingMesh(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices);

  std::size_t face_count() const { return alive_; }
  std::span<Point> points() { return points_; }
  std::size_t point_count() const { return points_.size(); }
  Point& point(std::uint32_t p) { return points_[p]; }
  const Point& point(std::uint32_t p) const { return points_[p]; }
  const Face& face(std::uint32_t f) const { return faces_[f]; }
  const FacePlane& plane(std::uint32_t f) const { return planes_[f]; }
  std::span<const std::uint32_t> ring(std::uint32_t p) const {
    return {rings_.data() + points_[p].first, points_[p].size};
  }
  const Changes& changes(std::uint32_t p) const { return changes_[p]; }
  /// For what is looked at soon.
  void prefetch_planes(std::uint32_t p) const {
    for (const std::uint32_t f : ring(p)) __builtin_prefetch(&planes_[f]);
  }
  /// The first vertex at that point.
  std::uint32_t name_of(std::uint32_t p) const { return names_[p]; }

  /// Each neighbour of the point once, in the order of its faces.
  std::span<const Neighbour> neighbours(std::uint32_t p);
  /// Faces that have both, into `shared`.
  void shared_faces(std::uint32_t p, std::uint32_t q, std::vector<std::uint32_t>& shared) const;
  /// Marks the points around p; is_marked() holds for them until the next call.
  void mark_neighbours(std::uint32_t p);
  bool is_marked(std::uint32_t p) const { return marks_[p] == mark_; }
  void unmark(std::uint32_t p) { marks_[p] = mark_ - 1; }

  /// `removed` becomes `kept`, which moves to `place`. Faces with both go; `renamed(vertex)` says which vertex of the
  /// kept point a removed one becomes. Faces around are told anew.
  template <class Renamed>
  void collapse(std::uint32_t removed, std::uint32_t kept, glm::vec3 place, const Renamed& renamed);

 private:
  void measure(std::uint32_t face);
  void drop(std::uint32_t point, std::uint32_t face);
  void append(std::uint32_t point, std::uint32_t face);

  std::vector<Point> points_;
  std::vector<Face> faces_;
  std::vector<FacePlane> planes_;
  std::vector<Changes> changes_;
  std::vector<std::uint32_t> rings_, names_, marks_, slots_;  // slots_: [marked point] = its place in found_
  std::vector<Neighbour> found_;
  std::uint32_t mark_ = 0;
  std::size_t alive_ = 0;
};

template <class Renamed>
void CollapsingMesh::collapse(std::uint32_t removed, std::uint32_t kept, glm::vec3 place, const Renamed& renamed) {
  points_[kept].place = place;
  ++changes_[kept].moves;
  ++changes_[removed].moves;
  points_[removed].is_gone = true;
  for (const std::uint32_t f : ring(removed)) {
    if (!faces_[f].has(kept)) continue;
    --alive_;
    for (const std::uint32_t p : faces_[f].point) {
      if (p != removed) drop(p, f);
    }
  }
  for (std::uint32_t i = 0; i < points_[removed].size; ++i) {
    const std::uint32_t f = rings_[points_[removed].first + i];
    Face& face = faces_[f];
    if (face.has(kept)) continue;
    const int corner = face.corner_of(removed);
    face.vertex[corner] = renamed(face.vertex[corner]);
    face.point[corner] = kept;
    append(kept, f);
  }
  for (const std::uint32_t f : ring(kept)) {
    measure(f);
    for (const std::uint32_t p : faces_[f].point) ++changes_[p].faces;
  }
}

}  // namespace foredraw::collapsing

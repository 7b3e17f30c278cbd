#pragma once
// A triangle mesh that loses one edge after the other. Points are what lies at one place; the vertices there differ in
// attributes, and triangles name both. The mesh lies in pieces, which are worked on at once: see MeshEditor.

#include "symmetric.h"

#include <array>
#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

namespace foredraw::processors::quadric_collapse {

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
  std::uint32_t size = 0;          ///< how many faces it has
  std::uint32_t* faces = nullptr;  ///< [size]
  std::uint32_t room = 0;          ///< for faces
  bool is_gone = false;
  bool is_fixed = false;   ///< stays: it is not finite
  bool is_sharp = false;   ///< some edge here is of one face, of more than two, or of several vertices
  bool is_seam = false;    ///< the same, where not directions alone differ
  std::uint64_t mark = 0;  ///< an editor's, as the slot is
  std::uint32_t slot = 0;
  Quadric memory;  ///< of the planes of all faces that ever were; about its place
};
static_assert(sizeof(Point) == 128);

/// How often something happened to a point: entries of a queue that are older are known by it.
struct Changes {
  std::uint32_t moves = 0;  ///< it took another's place, or went
  std::uint32_t faces = 0;  ///< a face here changed
};

class CollapsingMesh {
 public:
  /// Positions of vertices; three indices a triangle. Triangles with two corners at one place are left out. Pieces have
  /// at most `piece` points.
  CollapsingMesh(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices, std::size_t piece);
  CollapsingMesh(const CollapsingMesh&) = delete;
  CollapsingMesh& operator=(const CollapsingMesh&) = delete;

  std::size_t face_count() const { return faces_.size(); }  ///< that were there at first
  std::size_t point_count() const { return points_.size(); }
  Point& point(std::uint32_t p) { return points_[p]; }
  const Point& point(std::uint32_t p) const { return points_[p]; }
  const Face& face(std::uint32_t f) const { return faces_[f]; }
  const FacePlane& plane(std::uint32_t f) const { return planes_[f]; }
  std::span<const std::uint32_t> ring(std::uint32_t p) const { return {points_[p].faces, points_[p].size}; }
  const Changes& changes(std::uint32_t p) const { return changes_[p]; }
  /// For what is looked at soon.
  void prefetch_planes(std::uint32_t p) const {
    for (const std::uint32_t f : ring(p)) __builtin_prefetch(&planes_[f]);
  }
  /// The first vertex at that point.
  std::uint32_t name_of(std::uint32_t p) const { return names_[p]; }
  /// Faces that have both, into `shared`.
  void shared_faces(std::uint32_t p, std::uint32_t q, std::vector<std::uint32_t>& shared) const;

  // Pieces. Points of one have numbers one after the other.

  std::size_t piece_count() const { return first_.size() - 1; }
  std::uint32_t first_point(std::size_t piece) const { return first_[piece]; }  ///< of that one, or of none behind it
  std::uint32_t piece_of(std::uint32_t p) const { return pieces_[p]; }
  /// Whether both, and all that is around them, are of one piece.
  bool is_inside(std::uint32_t p, std::uint32_t q) const { return !is_rim_[p] && !is_rim_[q]; }
  /// Finds out which points of the piece that were no inner ones are inner ones. At first none is, and none is where
  /// there is one piece.
  void find_rim(std::size_t piece);
  /// Two pieces become one, and so do the next two.
  void join_pieces();

 private:
  friend class MeshEditor;

  void measure(std::uint32_t face);
  bool touches_others(std::uint32_t p) const;

  std::vector<Point> points_;
  std::vector<Face> faces_;
  std::vector<FacePlane> planes_;
  std::vector<Changes> changes_;
  std::vector<std::uint32_t> rings_, names_;
  std::vector<std::uint32_t> pieces_, first_;  // [point] its piece; [piece] its first point
  std::vector<std::uint8_t> is_rim_;           // [point]
};

/// A point that another has an edge to, and the faces of that edge.
struct Neighbour {
  std::uint32_t point = 0;
  std::uint32_t faces = 0;                ///< how many
  std::array<std::uint32_t, 2> shared{};  ///< the first two
};

/// Looks around in the mesh and changes it. Several may do so at once, each inside a piece of its own: who takes an
/// edge for which is_inside() holds writes nothing that another one reads, and reads nothing that another one writes.
class MeshEditor {
 public:
  /// `number`: of this one among so many.
  MeshEditor(CollapsingMesh& mesh, std::size_t number, std::size_t count) : mesh_(mesh), mark_(number), marks_(count) {}

  /// Each neighbour of the point once, in the order of its faces; or each in its own piece.
  std::span<const Neighbour> neighbours(std::uint32_t p, bool in_piece = false);
  /// Marks the points around p; is_marked() holds for them until the next call.
  void mark_neighbours(std::uint32_t p);
  bool is_marked(std::uint32_t p) const { return mesh_.points_[p].mark == mark_; }
  void unmark(std::uint32_t p) { mesh_.points_[p].mark = no_mark; }

  /// `removed` becomes `kept`, which moves to `place`. Faces with both go; `renamed(vertex)` says which vertex of the
  /// kept point a removed one becomes. Faces around are told anew. How many went.
  template <class Renamed>
  std::size_t collapse(std::uint32_t removed, std::uint32_t kept, glm::vec3 place, const Renamed& renamed);

 private:
  static constexpr std::uint64_t no_mark = 0;

  void drop(std::uint32_t point, std::uint32_t face);
  void append(std::uint32_t point, std::uint32_t face);
  void find_rim_around(std::uint32_t p);

  CollapsingMesh& mesh_;
  std::pmr::monotonic_buffer_resource memory_;  // of rings that outgrew their place
  std::vector<Neighbour> found_;
  std::uint64_t mark_, marks_;  // the last one, and how far the next one is: no other editor has the same
};

template <class Renamed>
std::size_t MeshEditor::collapse(std::uint32_t removed, std::uint32_t kept, glm::vec3 place, const Renamed& renamed) {
  mesh_.points_[kept].place = place;
  ++mesh_.changes_[kept].moves;
  ++mesh_.changes_[removed].moves;
  mesh_.points_[removed].is_gone = true;
  std::size_t gone = 0;
  for (const std::uint32_t f : mesh_.ring(removed)) {
    if (!mesh_.faces_[f].has(kept)) continue;
    ++gone;
    for (const std::uint32_t p : mesh_.faces_[f].point) {
      if (p != removed) drop(p, f);
    }
  }
  for (const std::uint32_t f : mesh_.ring(removed)) {
    Face& face = mesh_.faces_[f];
    if (face.has(kept)) continue;
    const int corner = face.corner_of(removed);
    face.vertex[corner] = renamed(face.vertex[corner]);
    face.point[corner] = kept;
    append(kept, f);
  }
  for (const std::uint32_t f : mesh_.ring(kept)) {
    mesh_.measure(f);
    for (const std::uint32_t p : mesh_.faces_[f].point) ++mesh_.changes_[p].faces;
  }
  if (!mesh_.is_inside(removed, kept)) find_rim_around(kept);
  return gone;
}

}  // namespace foredraw::processors::quadric_collapse

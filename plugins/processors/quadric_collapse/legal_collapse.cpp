#include "legal_collapse.h"

#include <foredraw/geometry/finite.h>

#include <algorithm>
#include <limits>

namespace foredraw::processors::quadric_collapse {

bool LegalCollapses::has_face(std::uint32_t p, std::uint32_t a, std::uint32_t b) const {
  return std::ranges::any_of(mesh_.ring(p),
                             [&](std::uint32_t f) { return mesh_.face(f).has(a) && mesh_.face(f).has(b); });
}

bool LegalCollapses::keeps_topology(std::uint32_t p, std::uint32_t q) {
  mesh_.shared_faces(p, q, shared_);
  const Point& a = mesh_.point(p);
  const Point& b = mesh_.point(q);
  if (shared_.empty() || a.is_fixed || b.is_fixed) return false;
  if (a.size + b.size == 2 * shared_.size()) return false;  // nothing would be left of it
  // Two borders that an edge of the inside joins would become one point of both.
  const bool is_inner = shared_.size() == 2;
  if (is_inner && is_border(p) && is_border(q)) return false;
  std::uint32_t wanted = 0;
  for (std::size_t i = 0; i < shared_.size(); ++i) {
    const auto third_of = [&](std::uint32_t f) {
      for (const std::uint32_t n : mesh_.face(f).point) {
        if (n != p && n != q) return n;
      }
      return p;
    };
    const std::uint32_t third = third_of(shared_[i]);
    bool is_new = true;
    for (std::size_t j = 0; j < i; ++j) is_new = is_new && third_of(shared_[j]) != third;
    wanted += is_new;
  }
  editor_.mark_neighbours(p);
  // A face of q whose other corners p has too, as in a tetrahedron, would lie on one of p.
  for (const std::uint32_t f : mesh_.ring(q)) {
    const Face& face = mesh_.face(f);
    if (face.has(p)) continue;
    const int k = face.corner_of(q);
    const std::uint32_t one = face.point[(k + 1) % 3], two = face.point[(k + 2) % 3];
    if (editor_.is_marked(one) && editor_.is_marked(two) && has_face(p, one, two)) return false;
  }
  std::uint32_t thirds = 0;
  for (const std::uint32_t f : mesh_.ring(q)) {
    for (const std::uint32_t n : mesh_.face(f).point) {
      if (n == p || n == q || !editor_.is_marked(n)) continue;
      ++thirds;
      editor_.unmark(n);
    }
  }
  return thirds == wanted;
}

/// Whether some edge at p is of one face, or of more than two.
bool LegalCollapses::is_border(std::uint32_t p) const {
  if (!mesh_.point(p).is_sharp) return false;
  for (const std::uint32_t f : mesh_.ring(p)) {
    for (const std::uint32_t n : mesh_.face(f).point) {
      if (n == p) continue;
      const auto both = std::ranges::count_if(mesh_.ring(p), [&](std::uint32_t g) { return mesh_.face(g).has(n); });
      if (both != 2) return true;
    }
  }
  return false;
}

bool LegalCollapses::pair_vertices(std::uint32_t removed, std::uint32_t kept, JoinedVertices& joined) {
  joined.clear(), kinds_.clear();
  std::vector<VertexPair>& pairs = joined.pairs;
  for (const std::uint32_t f : shared_) {
    const Face& face = mesh_.face(f);
    const VertexPair pair{face.vertex[face.corner_of(removed)], face.vertex[face.corner_of(kept)]};
    const VertexPair kinds{attributes_.kind(pair.removed), attributes_.kind(pair.kept)};
    for (const VertexPair& known : kinds_) {
      if ((known.removed == kinds.removed) != (known.kept == kinds.kept)) return false;
    }
    kinds_.push_back(kinds);
    const auto has_one = [&](const VertexPair& known) {
      return known.removed == pair.removed || known.kept == pair.kept;
    };
    if (std::ranges::none_of(pairs, has_one)) pairs.push_back(pair);
  }
  joined.by_faces = pairs.size();
  return std::ranges::all_of(mesh_.ring(removed), [&](std::uint32_t f) {
    const Face& face = mesh_.face(f);
    const std::uint32_t vertex = face.vertex[face.corner_of(removed)];
    if (std::ranges::find(pairs, vertex, &VertexPair::removed) != pairs.end()) return true;
    const auto kinds = std::ranges::find(kinds_, attributes_.kind(vertex), &VertexPair::removed);
    if (kinds == kinds_.end()) return false;
    pairs.push_back({vertex, nearest(vertex, kept, kinds->kept)});
    return true;
  });
}

std::uint32_t LegalCollapses::nearest(std::uint32_t vertex, std::uint32_t kept, std::uint32_t kind) const {
  std::uint32_t found = kind;
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t f : mesh_.ring(kept)) {
    const std::uint32_t other = mesh_.face(f).vertex[mesh_.face(f).corner_of(kept)];
    if (attributes_.kind(other) != kind) continue;
    if (const double turned = attributes_.turned(vertex, other); turned < least) least = turned, found = other;
  }
  return found;
}

bool LegalCollapses::keeps_sides(std::uint32_t p, std::uint32_t q, glm::vec3 place) const {
  return is_finite(place) && keeps_sides_around(p, q, glm::dvec3(place)) && keeps_sides_around(q, p, glm::dvec3(place));
}

bool LegalCollapses::keeps_sides_around(std::uint32_t p, std::uint32_t q, const glm::dvec3& place) const {
  constexpr double least_cosine = 0.2;
  for (const std::uint32_t f : mesh_.ring(p)) {
    const Face& face = mesh_.face(f);
    const FacePlane& plane = mesh_.plane(f);
    if (face.has(q) || !(plane.weight > 0)) continue;
    const int k = face.corner_of(p);
    const glm::dvec3 one = glm::dvec3(mesh_.point(face.point[(k + 1) % 3]).place) - place;
    const glm::dvec3 two = glm::dvec3(mesh_.point(face.point[(k + 2) % 3]).place) - place;
    const glm::dvec3 normal = cross(one, two);
    const double along = dot(normal, plane.normal);
    // Both normals' lengths are known by their squares; weight is half of one over the old length.
    if (!(along > 0 &&
          along * along * 4 * plane.weight * plane.weight >= least_cosine * least_cosine * dot(normal, normal)))
      return false;
  }
  return true;
}

}  // namespace foredraw::processors::quadric_collapse

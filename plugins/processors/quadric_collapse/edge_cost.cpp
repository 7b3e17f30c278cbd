#include "edge_cost.h"

#include <algorithm>
#include <functional>

namespace foredraw::processors::quadric_collapse {

/// Calls see(number of the face, neighbour, weight) for each face of each sharp edge at p.
template <class See>
void EdgeCosts::each_sharp_edge(std::uint32_t p, See see) const {
  const std::span<const std::uint32_t> ring = mesh_.ring(p);
  for (const std::uint32_t f : ring) {
    const Face& face = mesh_.face(f);
    const int k = face.corner_of(p);
    for (const int other : {(k + 1) % 3, (k + 2) % 3}) {
      const std::uint32_t q = face.point[other];
      int faces = 0;
      std::uint32_t beside = f;
      for (const std::uint32_t g : ring) {
        if (!mesh_.face(g).has(q)) continue;
        ++faces;
        if (g != f) beside = g;
      }
      const double weight = faces == 2 ? seam_weight(f, beside, p, q) : weights_.border;
      if (weight > 0) see(f, q, weight);
    }
  }
}

/// A seam where directions alone differ counts as much as it shows: it may be a crease, or a face's border in a mesh
/// that is shaded flat.
double EdgeCosts::seam_weight(std::uint32_t f, std::uint32_t g, std::uint32_t p, std::uint32_t q) const {
  double turned = 0;
  for (const std::uint32_t one : {p, q}) {
    const std::uint32_t a = mesh_.face(f).vertex[mesh_.face(f).corner_of(one)];
    const std::uint32_t b = mesh_.face(g).vertex[mesh_.face(g).corner_of(one)];
    if (a == b) continue;
    if (attributes_.kind(a) != attributes_.kind(b)) return weights_.seam;
    turned = std::max(turned, attributes_.turned(a, b));
  }
  return weights_.seam * std::min(turned, 1.0);
}

/// Whether each edge at p goes out of one face and into another, of the same vertices, or what `of` tells of them.
template <class Of>
bool EdgeCosts::is_smooth(std::uint32_t p, const Of& of) const {
  const std::span<const std::uint32_t> ring = mesh_.ring(p);
  std::array<std::uint32_t, most_faces> next, next_point, previous;
  std::uint32_t vertex = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Face& face = mesh_.face(ring[i]);
    const int k = face.corner_of(p);
    if (i > 0 && of(face.vertex[k]) != vertex) return false;
    vertex = of(face.vertex[k]);
    next[i] = of(face.vertex[(k + 1) % 3]);
    next_point[i] = face.point[(k + 1) % 3];
    previous[i] = of(face.vertex[(k + 2) % 3]);
  }
  for (std::size_t i = 0; i < ring.size(); ++i) {
    int into = 0, out_of = 0;
    for (std::size_t j = 0; j < ring.size(); ++j) {
      into += previous[j] == next[i];
      out_of += next_point[j] == next_point[i];
    }
    if (into != 1 || out_of != 1) return false;
  }
  return true;
}

/// The plane through the edge that stands upright on the face; by the edge's length squared.
void EdgeCosts::add_sharp(std::uint32_t f, std::uint32_t p, std::uint32_t q, double weight, Symmetric& planes) const {
  const glm::dvec3& up = mesh_.plane(f).normal;
  const double normal = dot(up, up);
  if (!(normal > 0)) return;
  const glm::dvec3 edge = glm::dvec3(mesh_.point(q).place) - glm::dvec3(mesh_.point(p).place);
  planes.add(cross(edge, up), weight / normal);
}

/// Without the memory. A point lies on all its planes, so that of a quadric about its place the matrix is all there is.
Around EdgeCosts::faces_around(std::uint32_t p) const {
  Around sum;
  Symmetric& matrix = sum.planes.matrix;
  for (const std::uint32_t f : mesh_.ring(p)) {
    const FacePlane& plane = mesh_.plane(f);
    matrix.add(plane.normal, plane.weight);
    sum.area += plane.normal;
  }
  if (mesh_.point(p).is_sharp) {
    each_sharp_edge(p, [&](std::uint32_t f, std::uint32_t q, double weight) { add_sharp(f, p, q, weight, matrix); });
  }
  return sum;
}

Around EdgeCosts::around(std::uint32_t p) const {
  if (const std::uint32_t i = p - first_point_; i < first_.size()) return first_[i];
  Around sum = faces_around(p);
  sum.planes.add(mesh_.point(p).memory, weights_.memory);
  return sum;
}

void EdgeCosts::begin(std::uint32_t first, std::uint32_t end) {
  first_point_ = first;
  first_.resize(end - first);
  for (std::uint32_t p = first; p < end; ++p) {
    Point& point = mesh_.point(p);
    const bool is_hub = mesh_.ring(p).size() > most_faces;
    point.is_sharp = is_hub || !is_smooth(p, std::identity());
    point.is_seam = point.is_sharp && (is_hub || !is_smooth(p, [&](std::uint32_t v) { return attributes_.kind(v); }));
    if (is_hub) continue;
    Around& here = first_[p - first];
    here = faces_around(p);
    point.memory = here.planes;
    here.planes.add(point.memory, weights_.memory);
  }
}

/// About p's place, of which `a` tells. Reads shared_.
Quadric EdgeCosts::planes_around(const Around& a, std::uint32_t p, std::uint32_t q, Constraint& volume) const {
  const Around b = around(q);
  const glm::dvec3 there = glm::dvec3(mesh_.point(q).place) - glm::dvec3(mesh_.point(p).place);
  Quadric sum = a.planes;
  sum.add_about(b.planes, there);
  glm::dvec3 area = b.area;
  // What both have counts once. Both lie on it.
  for (const std::uint32_t f : shared_) {
    const FacePlane& plane = mesh_.plane(f);
    sum.matrix.add(plane.normal, -plane.weight);
    area -= plane.normal;
  }
  const bool p_is_sharp = mesh_.point(p).is_sharp, q_is_sharp = mesh_.point(q).is_sharp;
  if (p_is_sharp && q_is_sharp && !is_smooth_between(p, q)) {
    const double weight = shared_.size() == 2 ? seam_weight(shared_[0], shared_[1], p, q) : weights_.border;
    for (const std::uint32_t f : shared_) add_sharp(f, p, q, -weight, sum.matrix);
  }
  volume =
      mesh_.point(p).is_seam || mesh_.point(q).is_seam ? Constraint{} : Constraint{a.area + area, dot(area, there)};
  return sum;
}

Quadric EdgeCosts::around(const Around& a, std::uint32_t p, std::uint32_t q, Constraint& volume) {
  mesh_.shared_faces(p, q, shared_);
  Quadric sum = planes_around(a, p, q, volume);
  if (attributes_.empty() && poses_.empty()) return sum;
  if (!attributes_.empty()) sum.add(attributes_.around(p, q, shared_));
  if (poses_.empty()) return sum;
  Quadric about_q;
  poses_.add_around(p, q, shared_, sum.matrix, about_q.matrix);
  sum.add_about(about_q, glm::dvec3(mesh_.point(q).place) - glm::dvec3(mesh_.point(p).place));
  return sum;
}

/// Of two faces with the same vertices at both ends. Reads shared_.
bool EdgeCosts::is_smooth_between(std::uint32_t p, std::uint32_t q) const {
  if (shared_.size() != 2) return false;
  const Face& f = mesh_.face(shared_[0]);
  const Face& g = mesh_.face(shared_[1]);
  const auto same_at = [&](std::uint32_t one) { return f.vertex[f.corner_of(one)] == g.vertex[g.corner_of(one)]; };
  return same_at(p) && same_at(q);
}

EdgeCost EdgeCosts::least(const Around& a, std::uint32_t p, std::uint32_t q) {
  Constraint volume;
  const Quadric sum = around(a, p, q, volume);
  const glm::dvec3 from(mesh_.point(p).place), there = glm::dvec3(mesh_.point(q).place) - from;
  if (weights_.at_endpoints) {
    const double at_q = sum.at(there);
    return sum.constant <= at_q ? EdgeCost{sum.constant, mesh_.point(p).place} : EdgeCost{at_q, mesh_.point(q).place};
  }
  const glm::vec3 place(from + processors::quadric_collapse::least(sum, volume, there * 0.5));
  return {sum.at(glm::dvec3(place) - from), place};
}

/// Of an edge that is not sharp, with what the points say of attributes and poses.
void EdgeCosts::add_together(Around a, std::uint32_t p, const Neighbour& other) {
  const std::uint32_t q = other.point;
  Around b = around(q);
  if (!attributes_.empty()) a.planes.add(attributes_.around(p, q, other.shared));
  if (!poses_.empty()) poses_.add_around(p, q, other.shared, a.planes.matrix, b.planes.matrix);
  together_.add(mesh_.point(p).place, a, mesh_.point(q).place, b, mesh_.plane(other.shared[0]),
                mesh_.plane(other.shared[1]));
}

void EdgeCosts::least(std::uint32_t p, std::span<const Neighbour> neighbours, std::span<EdgeCost> costs) {
  if (neighbours.empty()) return;  // a hub, around which to look takes long
  for (const Neighbour& one : neighbours) mesh_.prefetch_planes(one.point);
  const Around a = around(p);
  const auto solve = [&] {
    const std::span<const EdgeCost> solved = together_.costs();
    for (std::size_t i = 0; i < solved.size(); ++i) costs[which_[i]] = solved[i];
    together_.clear();
  };
  for (std::uint32_t i = 0; i < neighbours.size(); ++i) {
    const Neighbour& one = neighbours[i];
    const bool is_sharp = mesh_.point(p).is_sharp || mesh_.point(one.point).is_sharp;
    if (is_sharp || one.faces != 2 || weights_.at_endpoints) {
      costs[i] = least(a, p, one.point);
      continue;
    }
    which_[together_.size()] = i;
    add_together(a, p, one);
    if (together_.is_full()) solve();
  }
  solve();
}

double EdgeCosts::distances(std::uint32_t p, std::uint32_t q, glm::vec3 place) {
  Constraint volume;
  mesh_.shared_faces(p, q, shared_);
  return planes_around(around(p), p, q, volume).at(glm::dvec3(place) - glm::dvec3(mesh_.point(p).place));
}

Quadric EdgeCosts::joined_memory(std::uint32_t p, std::uint32_t q, glm::vec3 place) const {
  Quadric sum;
  for (const std::uint32_t one : {p, q}) {
    const Point& point = mesh_.point(one);
    sum.add_about(point.memory, glm::dvec3(point.place) - glm::dvec3(place));
  }
  return sum;
}

}  // namespace foredraw::processors::quadric_collapse

#include "edge_cost.h"

namespace foredraw::collapsing {

/// Calls see(face, neighbour, weight) for each face of each sharp edge at p.
template <class See>
void EdgeCosts::each_sharp_edge(std::uint32_t p, See see) const {
  const std::span<const std::uint32_t> ring = mesh_.ring(p);
  for (const std::uint32_t f : ring) {
    const Face& face = mesh_.face(f);
    const int k = face.corner_of(p);
    for (const int other : {(k + 1) % 3, (k + 2) % 3}) {
      const std::uint32_t q = face.point[other];
      int faces = 0;
      bool alike = true;
      for (const std::uint32_t g : ring) {
        const Face& beside = mesh_.face(g);
        if (!beside.has(q)) continue;
        ++faces;
        alike = alike && beside.vertex[beside.corner_of(p)] == face.vertex[k] &&
                beside.vertex[beside.corner_of(q)] == face.vertex[other];
      }
      if (faces != 2 || !alike) see(face, q, faces == 2 ? weights_.seam : weights_.border);
    }
  }
}

/// Whether each edge at p goes out of one face and into another, of the same vertices.
bool EdgeCosts::is_smooth(std::uint32_t p) const {
  const std::span<const std::uint32_t> ring = mesh_.ring(p);
  if (ring.empty()) return true;
  const Face& first = mesh_.face(ring.front());
  const std::uint32_t vertex = first.vertex[first.corner_of(p)];
  for (const std::uint32_t f : ring) {
    const Face& face = mesh_.face(f);
    const int k = face.corner_of(p);
    if (face.vertex[k] != vertex) return false;
    int into = 0, out_of = 0;
    for (const std::uint32_t g : ring) {
      const Face& beside = mesh_.face(g);
      const int j = beside.corner_of(p);
      into += beside.vertex[(j + 2) % 3] == face.vertex[(k + 1) % 3];
      out_of += beside.point[(j + 1) % 3] == face.point[(k + 1) % 3];
    }
    if (into != 1 || out_of != 1) return false;
  }
  return true;
}

/// The plane through the edge that stands upright on the face; by the edge's length squared.
void EdgeCosts::add_sharp(const Face& face, std::uint32_t p, std::uint32_t q, double weight, Symmetric& planes) const {
  const double normal = dot(face.normal, face.normal);
  if (!(normal > 0)) return;
  const glm::dvec3 edge = glm::dvec3(mesh_.point(q).place) - glm::dvec3(mesh_.point(p).place);
  planes.add(cross(edge, face.normal), weight / normal);
}

void EdgeCosts::refresh(std::uint32_t p) {
  Point& point = mesh_.point(p);
  if (!point.is_stale) return;
  point.is_stale = false;
  // It lies on all its planes, so that of a quadric about its place the matrix is all there is.
  Symmetric planes;
  glm::dvec3 area(0);
  for (const std::uint32_t f : mesh_.ring(p)) {
    const Face& face = mesh_.face(f);
    planes.add(face.normal, face.weight);
    area += face.normal;
  }
  if (point.is_sharp) {
    each_sharp_edge(p,
                    [&](const Face& face, std::uint32_t q, double weight) { add_sharp(face, p, q, weight, planes); });
  }
  point.area = area;
  point.planes = {planes};
  point.planes.add(point.memory, weights_.memory);
}

void EdgeCosts::begin() {
  for (std::uint32_t p = 0; p < mesh_.points().size(); ++p) {
    Point& point = mesh_.point(p);
    const bool is_hub = mesh_.ring(p).size() > most_faces;
    point.is_sharp = is_hub || !is_smooth(p);
    if (is_hub) continue;
    refresh(p);
    point.memory = point.planes;
    point.is_stale = true;
  }
}

/// About p's place.
Quadric EdgeCosts::around(std::uint32_t p, std::uint32_t q, Constraint& volume) {
  refresh(p);
  refresh(q);
  mesh_.shared_faces(p, q, shared_);
  const Point& a = mesh_.point(p);
  const Point& b = mesh_.point(q);
  const glm::dvec3 there = glm::dvec3(b.place) - glm::dvec3(a.place);
  Quadric sum = a.planes;
  sum.add_about(b.planes, there);
  glm::dvec3 area = b.area;
  // What both have counts once. Both lie on it.
  for (const std::uint32_t f : shared_) {
    const Face& face = mesh_.face(f);
    sum.matrix.add(face.normal, -face.weight);
    area -= face.normal;
  }
  const bool is_sharp = a.is_sharp || b.is_sharp;
  if (a.is_sharp && b.is_sharp && !is_smooth_between(p, q)) {
    const double weight = shared_.size() == 2 ? weights_.seam : weights_.border;
    for (const std::uint32_t f : shared_) add_sharp(mesh_.face(f), p, q, -weight, sum.matrix);
  }
  volume = is_sharp ? Constraint{} : Constraint{a.area + area, dot(area, there)};
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

EdgeCost EdgeCosts::optimal(std::uint32_t p, std::uint32_t q) {
  Constraint volume;
  const Quadric sum = around(p, q, volume);
  const glm::dvec3 from(mesh_.point(p).place), there = glm::dvec3(mesh_.point(q).place) - from;
  const glm::vec3 place(from + least(sum, volume, there * 0.5));
  return {sum.at(glm::dvec3(place) - from), place};
}

double EdgeCosts::at(std::uint32_t p, std::uint32_t q) {
  Constraint volume;
  return around(p, q, volume).constant;
}

Quadric EdgeCosts::joined_memory(std::uint32_t p, std::uint32_t q, glm::vec3 place) const {
  Quadric sum;
  for (const std::uint32_t one : {p, q}) {
    const Point& point = mesh_.point(one);
    sum.add_about(point.memory, glm::dvec3(point.place) - glm::dvec3(place));
  }
  return sum;
}

}  // namespace foredraw::collapsing

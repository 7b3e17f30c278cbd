#pragma once
// What it costs in poses to make one point of two: squared distances from the planes that the faces around have there,
// by area. In each pose, too, a point lies on all planes of its faces. And where the joined point will lie in a pose is
// an affine function of where it lies at rest, so that planes in poses are 3 x 3 matrices about the point's place at
// rest, and nothing else.

#include "collapsing_mesh.h"

#include <foredraw/collapses/posed_vertices.h>

#include <glm/mat3x3.hpp>

namespace foredraw::processors::quadric_collapse {

class PosedPlanes {
 public:
  /// `weight`: of all poses together.
  PosedPlanes(const CollapsingMesh& mesh, const PosedVertices& posed, double weight);

  bool empty() const { return poses_ == 0; }
  /// Finds the planes of the face, which is new or has changed.
  void measure(std::uint32_t face);
  /// Adds what the faces around either end of an edge say, as functions of where the joined point lies from that end at
  /// rest. `shared`: the faces between both.
  void add_around(std::uint32_t p, std::uint32_t q, std::span<const std::uint32_t> shared, Symmetric& of_p,
                  Symmetric& of_q);
  /// The kept point becomes the blend of both, and goes to that place; in the mesh they are still where they were.
  void join(std::uint32_t removed, std::uint32_t kept, float blend, glm::vec3 place);

 private:
  /// A point in a pose. As it moves by a step at rest, it moves by linear * step there.
  struct Posed {
    glm::dmat3 linear{1};
    glm::dvec3 place{0};
  };

  const Symmetric* sums_at(std::uint32_t point);

  const CollapsingMesh& mesh_;
  std::size_t poses_;
  std::vector<double> scales_;          ///< [pose] the root of its weight
  std::vector<Posed> points_;           ///< [point * poses + pose]
  std::vector<glm::dvec3> normals_;     ///< [face * poses + pose] normal normal^T measures weight * area * distance^2
  std::vector<Symmetric> sums_;         ///< [point * poses + pose] over the faces around it
  std::vector<std::uint32_t> changes_;  ///< [point] of its faces, when they were added up
};

}  // namespace foredraw::processors::quadric_collapse

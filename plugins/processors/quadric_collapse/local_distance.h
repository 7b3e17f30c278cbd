#pragma once
// How far a collapse moves the surface, close around it.

#include "collapsing_mesh.h"

namespace foredraw::processors::quadric_collapse {

/// The squared distance, at most, of the place from the faces around both points, and of either point from the faces
/// that will be. Of at most most_faces around them. The same on every processor.
class LocalDistance {
 public:
  static constexpr std::size_t most_faces = 128;

  double squared(const CollapsingMesh& mesh, std::uint32_t p, std::uint32_t q, glm::vec3 place);

  using Row = std::array<double, most_faces>;  // [face]
  struct Rows {
    std::array<Row, 3> a;     ///< where the joined corner is now
    std::array<Row, 3> b, c;  ///< the other corners
    std::size_t staying = 0;  ///< faces that stay; those behind them go
    std::size_t all = 0;
  };

 private:
  void add(const CollapsingMesh& mesh, std::uint32_t point, const Face& face);

  alignas(64) Rows rows_;
};

}  // namespace foredraw::processors::quadric_collapse

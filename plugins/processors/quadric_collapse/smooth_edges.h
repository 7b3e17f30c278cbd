#pragma once
// The costs of several edges at once, where neither point of them is sharp: most edges of most meshes.

#include "collapsing_mesh.h"

#include <array>

namespace foredraw::processors::quadric_collapse {

/// The cost of joining two points, and the place that is least.
struct EdgeCost {
  double cost = 0;
  glm::vec3 place{0};
};

/// What a point knows of the surface around it.
struct Around {
  Quadric planes;      ///< of all faces here and, by weight, of the memory; about its place
  glm::dvec3 area{0};  ///< sum of the faces' normals
};

/// Up to eight edges, side by side.
class SmoothEdges {
 public:
  static constexpr std::size_t most = 8;
  using Row = std::array<double, most>;  // [edge]

  /// A point, the other one, and the two faces of the edge between them.
  void add(glm::vec3 a_place, const Around& a, glm::vec3 b_place, const Around& b, const FacePlane& f,
           const FacePlane& g);
  std::size_t size() const { return size_; }
  bool is_full() const { return size_ == most; }
  void clear() { size_ = 0; }
  /// [edge], of those that were added: as EdgeCosts::least() says it. The same on every processor.
  std::span<const EdgeCost> costs();

  struct Surroundings {
    std::array<Row, 6> matrix;
    std::array<Row, 3> vector;
    Row constant;
    std::array<Row, 3> area;
  };
  struct Normal {
    std::array<Row, 3> normal;
    Row weight;
  };
  struct Rows {
    Surroundings a, b;
    Normal f, g;
    std::array<Row, 3> from, there;  ///< of b: from a
  };
  struct Answers {
    std::array<Row, 3> place;  ///< in floats
    Row cost;
  };

 private:
  alignas(64) Rows rows_;
  alignas(64) Answers answers_;
  std::array<EdgeCost, most> costs_;
  std::size_t size_ = 0;
};

}  // namespace foredraw::processors::quadric_collapse

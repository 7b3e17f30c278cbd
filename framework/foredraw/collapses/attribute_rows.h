#pragma once
// What vertices carry, as numbers that simplifiers count beside distances.

#include <foredraw/collapses/joined_mesh.h>

namespace foredraw {

/// How much each kind counts. A difference times its weight is a length.
struct AttributeWeights {
  double normals = 0.004;   ///< one unit, in diagonals of the mesh's box
  double texcoords = 0.03;  ///< as far as a texture slides on the surface, in units of the mesh
  double colors = 0.01;     ///< one unit, in diagonals
  double joints = 0.02;     ///< a weight of 1 taken from one joint and given to another, in diagonals
  double targets = 0.1;     ///< as far as morph targets move a vertex, in units of the mesh
};

/// Numbers of each vertex of a mesh, in units of length. Finite.
struct AttributeRows {
  std::size_t width = 0;      ///< numbers a vertex
  std::vector<float> values;  ///< [vertex * width + i]
  std::size_t blended = 0;    ///< the last ones of each vertex, that are always blended along an edge: what moves it
  /// Three numbers that point somewhere, and stay as long as they are.
  struct Direction {
    std::size_t first = 0;
    double length = 0;
  };
  std::vector<Direction> directions = {};
  /// [vertex] the first one at its place that differs from it in directions alone, as where faces are shaded flat: one
  /// may stand for the other, at the cost of what their directions differ. None: each vertex is unlike all others.
  std::vector<std::uint32_t> alike = {};

  std::uint32_t kind(std::uint32_t vertex) const { return alike.empty() ? vertex : alike[vertex]; }
  const float* of(std::uint32_t vertex) const { return values.data() + vertex * width; }
  float* of(std::uint32_t vertex) { return values.data() + vertex * width; }
};

/// Of the kinds whose weight is not 0. What a stream of the mesh lacks is 0 there. Many joints become six numbers, and
/// many targets two directions: sums with signs drawn for each, which keep squared distances in the mean (Achlioptas:
/// Database-friendly random projections, 2003). The same for the same mesh.
AttributeRows attribute_rows(const JoinedMesh& mesh, const AttributeWeights& weights);

}  // namespace foredraw

#pragma once
// What it costs to make one point of two: squared distances from the planes of the faces around, by area, with the
// volume kept. Memoryless as in Lindstrom, Turk: Fast and Memory Efficient Polygonal Simplification, Visualization
// 1998; quadrics after Garland, Heckbert 1997.

#include "collapsing_mesh.h"

namespace foredraw::collapsing {

struct CostWeights {
  double memory = 0.1;
  double border = 10;
  double seam = 3;
};

/// The cost of joining two points, and the place that is least.
struct EdgeCost {
  double cost = 0;
  glm::vec3 place{0};
};

class EdgeCosts {
 public:
  EdgeCosts(CollapsingMesh& mesh, const CostWeights& weights) : mesh_(mesh), weights_(weights) {}

  /// More around an edge are not looked at.
  static constexpr std::size_t most_faces = 128;

  /// Finds sharp points, and gives every point its planes and memory.
  void begin();
  EdgeCost optimal(std::uint32_t p, std::uint32_t q);
  /// The cost with the joined point at p's place.
  double at(std::uint32_t p, std::uint32_t q);
  /// What both remember, about the place where they are joined.
  Quadric joined_memory(std::uint32_t p, std::uint32_t q, glm::vec3 place) const;

 private:
  Quadric around(std::uint32_t p, std::uint32_t q, Constraint& volume);
  void refresh(std::uint32_t p);
  bool is_smooth(std::uint32_t p) const;
  bool is_smooth_between(std::uint32_t p, std::uint32_t q) const;
  template <class See>
  void each_sharp_edge(std::uint32_t p, See see) const;
  void add_sharp(const Face& face, std::uint32_t p, std::uint32_t q, double weight, Symmetric& planes) const;

  CollapsingMesh& mesh_;
  CostWeights weights_;
  std::vector<std::uint32_t> shared_;
};

}  // namespace foredraw::collapsing

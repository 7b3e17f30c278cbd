#pragma once
// What it costs to make one point of two: squared distances from the planes of the faces around, by area, with the
// volume kept. Memoryless as in Lindstrom, Turk: Fast and Memory Efficient Polygonal Simplification, Visualization
// 1998; quadrics after Garland, Heckbert 1997.

#include "attribute_cost.h"
#include "local_distance.h"
#include "posed_planes.h"
#include "smooth_edges.h"

#include <array>

namespace foredraw::processors::quadric_collapse {

struct CostWeights {
  double memory = 0.1;
  double border = 10;
  double seam = 3;
  bool at_endpoints = false;  ///< the joined point lies at one of both
};

class EdgeCosts {
 public:
  EdgeCosts(CollapsingMesh& mesh, const CostWeights& weights, AttributeCosts& attributes, PosedPlanes& poses)
      : mesh_(mesh), weights_(weights), attributes_(attributes), poses_(poses) {}

  /// More around an edge are not looked at.
  static constexpr std::size_t most_faces = LocalDistance::most_faces;

  /// Of these points: finds the sharp ones, and gives each its memory. What is found is kept until end_of_first().
  void begin(std::uint32_t first, std::uint32_t end);
  void end_of_first() { std::vector<Around>().swap(first_); }
  /// The least cost of joining both.
  EdgeCost least(std::uint32_t p, std::uint32_t q) { return least(around(p), p, q); }
  /// Of joining the point to some of its neighbours.
  void least(std::uint32_t p, std::span<const Neighbour> neighbours, std::span<EdgeCost> costs);
  /// Of a place, what distances at rest alone cost.
  double distances(std::uint32_t p, std::uint32_t q, glm::vec3 place);
  /// What both remember, about the place where they are joined.
  Quadric joined_memory(std::uint32_t p, std::uint32_t q, glm::vec3 place) const;

 private:
  Quadric planes_around(const Around& a, std::uint32_t p, std::uint32_t q, Constraint& volume) const;
  Quadric around(const Around& a, std::uint32_t p, std::uint32_t q, Constraint& volume);
  EdgeCost least(const Around& a, std::uint32_t p, std::uint32_t q);
  void add_together(Around a, std::uint32_t p, const Neighbour& other);
  Around faces_around(std::uint32_t p) const;
  Around around(std::uint32_t p) const;
  template <class Of>
  bool is_smooth(std::uint32_t p, const Of& of) const;
  bool is_smooth_between(std::uint32_t p, std::uint32_t q) const;
  template <class See>
  void each_sharp_edge(std::uint32_t p, See see) const;
  double seam_weight(std::uint32_t f, std::uint32_t g, std::uint32_t p, std::uint32_t q) const;
  void add_sharp(std::uint32_t f, std::uint32_t p, std::uint32_t q, double weight, Symmetric& planes) const;

  CollapsingMesh& mesh_;
  CostWeights weights_;
  AttributeCosts& attributes_;
  PosedPlanes& poses_;
  std::vector<std::uint32_t> shared_;
  std::uint32_t first_point_ = 0;
  std::vector<Around> first_;  ///< [point - first_point_], while all edges are entered
  SmoothEdges together_;
  std::array<std::uint32_t, SmoothEdges::most> which_;  ///< neighbours that are in it
};

}  // namespace foredraw::processors::quadric_collapse

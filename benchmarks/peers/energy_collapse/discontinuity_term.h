#pragma once
// Edisc: how far points of the original's borders and seams lie from those of the mesh. What would change the topology
// of these curves is not weighed but refused: CurveRules.

#include "star.h"

#include <foredraw/collapses/collapse_recorder.h>

namespace foredraw::processors::energy_collapse {

/// The sum of their squared distances, by `weight`, with the joined point at `place`. `nearest` gets [curve sample of
/// the star] the curve's number in the star, and the squared distance.
double discontinuity_term(const Star& star, const glm::dvec3& place, double weight, std::vector<Nearest>& nearest,
                          Fit& fit);

/// The squared distance of a point from an edge, and how far along it is nearest, 0 to 1.
struct OnEdge {
  double squared = 0, along = 0;
};
OnEdge nearest_on_edge(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& point);

/// Which edges are sharp: borders, those of more than two triangles, and those across which vertices differ.
class CurveRules {
 public:
  explicit CurveRules(const CollapseRecorder& recorder) : recorder_(recorder) {}

  bool is_sharp(std::uint32_t p, std::uint32_t q) const;
  /// The points that sharp edges lead to from p, in the order of its triangles.
  std::vector<std::uint32_t> sharp_neighbours(std::uint32_t p) const;
  /// Whether the curves keep their topology when the edge is gone: no two become one, and no end or junction moves onto
  /// another.
  bool keeps_curves(std::uint32_t p, std::uint32_t q) const;

 private:
  const CollapseRecorder& recorder_;
};

}  // namespace foredraw::processors::energy_collapse

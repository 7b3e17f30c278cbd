#pragma once
// The mesh while its edges collapse, and the points of the original that are kept with what they are nearest to.

#include "discontinuity_term.h"
#include "scalar_term.h"

#include <foredraw/collapses/unit_frame.h>

#include <map>
#include <optional>

namespace foredraw::processors::energy_collapse {

/// What a collapse makes of an edge.
struct Joined {
  std::uint32_t removed = 0, kept = 0;
  glm::vec3 place{0};  ///< in the mesh's units
  double blend = 0;
  double cost = 0;   ///< what it adds to the energy
  double error = 0;  ///< root mean square distance of the points around, in the mesh's units
};

class EnergyMesh {
 public:
  EnergyMesh(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices, const VertexScalars& scalars,
             const EnergyCollapseOptions& options);

  std::size_t triangle_count() const { return recorder_.triangle_count(); }
  std::size_t point_count() const { return places_.size(); }
  std::uint32_t changes(std::uint32_t p) const { return recorder_.changes(p); }
  bool has_edge(std::uint32_t p, std::uint32_t q) const { return recorder_.triangles_of_edge(p, q) > 0; }
  /// Each once, in the order of its triangles.
  std::vector<std::uint32_t> neighbours(std::uint32_t p) const;

  /// The best that can be made of an edge; nothing where it may not collapse, or where there is too much around it.
  std::optional<Joined> best(std::uint32_t p, std::uint32_t q);
  void collapse(const Joined& joined);
  CollapseSequence take() { return recorder_.take(); }

 private:
  struct Sample {
    glm::dvec3 at{0};
    double squared = 0;     ///< distance from the mesh
    double difference = 0;  ///< of attributes
  };
  struct CurveSample {
    glm::dvec3 at{0};
    double squared = 0;
  };
  using Edge = std::pair<std::uint32_t, std::uint32_t>;  ///< the lower number first

  double length_unit() const { return frame_.unit * frame_.diagonal; }
  glm::dvec3 at(const glm::vec3& position) const { return frame_.from_mesh(position) / frame_.diagonal; }
  void scatter_samples(std::span<const glm::vec3> positions);
  void scatter_curve_samples();
  void add_triangles(std::uint32_t p, std::uint32_t other, Star& star) const;
  void add_curves(std::uint32_t p, std::uint32_t other, Star& star) const;
  void add_springs(std::uint32_t removed, std::uint32_t kept, Star& star) const;
  /// After pairs_up(removed, kept).
  Star star_of(std::uint32_t removed, std::uint32_t kept) const;
  glm::dvec3 rounded(const glm::dvec3& place) const { return at(to_mesh(place)); }
  glm::vec3 to_mesh(const glm::dvec3& place) const { return frame_.to_mesh(place * frame_.diagonal); }
  bool keeps_sides(const Star& star, const glm::dvec3& place) const;
  VertexScalars scalars() const { return {values_, width_}; }

  EnergyCollapseOptions options_;
  CollapseRecorder recorder_;
  CurveRules rules_;
  UnitFrame frame_;
  std::vector<glm::vec3> positions_;  // [point], in the mesh's units
  std::vector<glm::dvec3> places_;    // [point], in box diagonals
  std::vector<Sample> samples_;
  std::vector<std::vector<std::uint32_t>> samples_on_;  // [triangle]
  std::vector<CurveSample> curve_samples_;
  std::map<Edge, std::vector<std::uint32_t>> curve_samples_on_;
  std::vector<float> values_, sample_values_;  // [vertex * width], [sample * width]
  std::size_t width_ = 0;
  double spacing_ = 1;  // of samples, in box diagonals
  std::vector<Nearest> nearest_, curve_nearest_;
};

}  // namespace foredraw::processors::energy_collapse

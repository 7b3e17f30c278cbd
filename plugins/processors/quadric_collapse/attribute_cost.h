#pragma once
// What it costs in attributes to make one point of two. Over a face an attribute is a linear function; the joined
// vertex should lie on those of all faces around. Hoppe: New Quadric Metric for Simplifying Meshes with Appearance
// Attributes, Visualization 1999. There the attributes are solved for beside the place. Here they are what the sequence
// makes of them, a blend along the edge, so that each is a function of the place, too, and 3 x 3 matrices are all there
// is.

#include "collapsing_mesh.h"

#include <foredraw/collapses/attribute_rows.h>
#include <foredraw/scene/collapse_sequence.h>

namespace foredraw::collapsing {

class AttributeCosts {
 public:
  AttributeCosts(const CollapsingMesh& mesh, AttributeRows rows)
      : mesh_(mesh),
        rows_(std::move(rows)),
        squares_(empty() ? 0 : mesh.face_count()),
        slopes_(squares_.size() * rows_.width),
        sums_(empty() ? 0 : mesh.point_count()),
        sums_by_number_(sums_.size() * rows_.width) {}

  bool empty() const { return rows_.width == 0; }
  /// Finds the slopes of the face, which is new or has changed.
  void measure(std::uint32_t face);
  /// Squared differences of the faces around `at` by area, as a function of where the point lies that it becomes with
  /// `other`, from `at`. `shared`: the faces of both, at least one.
  Symmetric around(std::uint32_t at, std::uint32_t other, std::span<const std::uint32_t> shared);
  /// The kept vertices become the blend.
  void blend(std::span<const VertexPair> pairs, float blend);

 private:
  /// What the faces around a vertex say: sums by area.
  struct Sums {
    std::uint32_t changes = ~std::uint32_t{0};  ///< of the point's faces, when they were added up
    double area = 0;
    Symmetric squares;
  };
  using Both = std::span<const std::uint32_t>;

  const Sums& sums_at(std::uint32_t point);
  Symmetric around_smooth(std::uint32_t at, std::uint32_t other, const glm::dvec3& step, Both shared);
  Symmetric around_sharp(std::uint32_t at, std::uint32_t other, const glm::dvec3& step, Both shared) const;

  const CollapsingMesh& mesh_;
  AttributeRows rows_;
  std::vector<Symmetric> squares_;          ///< [face]: sum of its slopes' squares, by area
  std::vector<glm::dvec3> slopes_;          ///< [face * width + i]: how attribute i grows along the face
  std::vector<Sums> sums_;                  ///< [point], of those that are not sharp
  std::vector<glm::dvec3> sums_by_number_;  ///< [point * width + i]: of each attribute's slopes
};

}  // namespace foredraw::collapsing

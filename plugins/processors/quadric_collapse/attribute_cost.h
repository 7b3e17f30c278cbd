#pragma once
// What it costs in attributes to make one point of two. Over a face an attribute is a linear function; the joined
// vertex should lie on those of all faces around. Hoppe: New Quadric Metric for Simplifying Meshes with Appearance
// Attributes, Visualization 1999. For each place there is a best value, the mean of these functions by area. With it
// put in, what is left is a quadric of the place alone, however many attributes there are. Where attributes are blended
// along the edge instead, each is a function of the place, too.

#include "collapsing_mesh.h"

#include <foredraw/collapses/attribute_rows.h>
#include <foredraw/collapses/collapse_sequence.h>
#include <foredraw/collapses/wedge_shares.h>

namespace foredraw::processors::quadric_collapse {

/// Which vertex of the kept point each vertex of the removed one becomes.
struct JoinedVertices {
  std::vector<VertexPair> pairs;
  std::size_t by_faces = 0;  ///< the first ones are beside each other in a face, and one to one

  void clear() { pairs.clear(), by_faces = 0; }
};

class AttributeCosts {
 public:
  /// `solves`: whether the joined vertex has the best values; if not, all are blended.
  AttributeCosts(const CollapsingMesh& mesh, AttributeRows rows, bool solves)
      : mesh_(mesh),
        rows_(std::move(rows)),
        solved_(solves ? rows_.width - rows_.blended : 0),
        squares_(solved_ > 0 ? mesh.face_count() : 0),
        blended_squares_(solved_ < rows_.width ? mesh.face_count() : 0),
        slopes_(mesh.face_count() * rows_.width),
        changes_(empty() ? 0 : mesh.point_count(), ~std::uint32_t{0}),
        sums_(empty() ? 0 : rows_.values.size() / rows_.width),
        sums_by_number_(sums_.size() * rows_.width) {}

  bool empty() const { return rows_.width == 0; }
  /// Vertices of one point and one kind differ in directions alone.
  std::uint32_t kind(std::uint32_t vertex) const { return rows_.kind(vertex); }
  /// By how much the directions of two vertices of a kind differ, squared, directions having length 1. 1 where they do
  /// not count.
  double turned(std::uint32_t one, std::uint32_t other) const;
  /// Finds the slopes of the face, which is new or has changed.
  void measure(std::uint32_t face);
  /// Squared differences of the faces around both points by area, as a function of where the joined point lies, from p.
  /// `shared`: the faces of both, at least one.
  Quadric around(std::uint32_t p, std::uint32_t q, std::span<const std::uint32_t> shared);
  /// What around() leaves out at that place: that vertices become another one which no face joins them to.
  double jumps(std::uint32_t removed, std::uint32_t kept, glm::vec3 place, float blend, const JoinedVertices& joined);
  /// Memory of who joins points.
  struct Room {
    struct WedgeFace {
      std::uint32_t face = 0;
      std::uint32_t wedge = 0;  ///< the kept point's vertex that it has, or will have
    };
    std::vector<WedgeFace> faces;
    WedgeShares shares;
    std::vector<double> solved;
  };
  /// The kept vertices get what they carry at that place; in the mesh both points are still where they were.
  void join(std::uint32_t removed, std::uint32_t kept, glm::vec3 place, float blend, std::span<const VertexPair> pairs,
            Room& room);

 private:
  /// What the faces around a vertex say: sums by area.
  struct Sums {
    double area = 0;
    Symmetric squares;
  };
  struct Edge;
  struct Ends;
  struct Jump;

  void add_up(std::uint32_t point);
  void add_wedge(const Ends& ends, const Edge& edge, Quadric& from_p, Quadric& from_q) const;
  void add_alone(std::uint32_t vertex, Quadric& from) const;
  void solve(std::uint32_t removed, std::uint32_t kept, glm::vec3 place, float blend, std::span<const VertexPair> pairs,
             Room& room);
  void put(std::uint32_t vertex, std::span<const WedgeShare> shares, std::vector<double>& solved);
  void blend_numbers(const VertexPair& pair, std::size_t first, std::size_t end, float blend);

  const CollapsingMesh& mesh_;
  AttributeRows rows_;
  std::size_t solved_;                      ///< the first numbers of each vertex; the others are blended
  std::vector<Symmetric> squares_;          ///< [face]: sum of its slopes' squares, by area, if any is solved for
  std::vector<Symmetric> blended_squares_;  ///< [face]: the same of those that are blended
  std::vector<glm::dvec3> slopes_;          ///< [face * width + i]: how attribute i grows along the face
  std::vector<std::uint32_t> changes_;      ///< [point]: of its faces, when they were added up
  std::vector<Sums> sums_;                  ///< [vertex]
  std::vector<glm::dvec3> sums_by_number_;  ///< [vertex * width + i]: of each attribute's slopes
};

}  // namespace foredraw::processors::quadric_collapse

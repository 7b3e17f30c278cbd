#pragma once
// Which edges may be collapsed: those that leave a surface of the same shape, with the same seams, and no triangle
// turned over.

#include "attribute_cost.h"

namespace foredraw::processors::quadric_collapse {

class LegalCollapses {
 public:
  LegalCollapses(const CollapsingMesh& mesh, MeshEditor& editor, const AttributeCosts& attributes)
      : mesh_(mesh), editor_(editor), attributes_(attributes) {}

  /// Whether the surface has the same topology when the edge is gone: what both points neighbour are the third corners
  /// of the faces between them, and nothing else; and some face is left.
  bool keeps_topology(std::uint32_t p, std::uint32_t q);
  /// Which vertex of `kept` each vertex of `removed` becomes, the two being those last asked about: the one beside it
  /// in a face; where there is none, the one of the same kind as those beside its own kind whose directions are
  /// nearest. False: faces do not say which kind becomes which, or not one to one, so that a seam would open, close or
  /// jump.
  bool pair_vertices(std::uint32_t removed, std::uint32_t kept, JoinedVertices& joined);
  /// Whether every face that stays keeps its side when both points go to that place.
  bool keeps_sides(std::uint32_t p, std::uint32_t q, glm::vec3 place) const;

 private:
  bool keeps_sides_around(std::uint32_t p, std::uint32_t q, const glm::dvec3& place) const;
  bool has_face(std::uint32_t p, std::uint32_t a, std::uint32_t b) const;
  bool is_border(std::uint32_t p) const;
  std::uint32_t nearest(std::uint32_t vertex, std::uint32_t kept, std::uint32_t kind) const;

  const CollapsingMesh& mesh_;
  MeshEditor& editor_;
  const AttributeCosts& attributes_;
  std::vector<std::uint32_t> shared_;  ///< between the points last asked about
  std::vector<VertexPair> kinds_;      ///< which kind becomes which
};

}  // namespace foredraw::processors::quadric_collapse

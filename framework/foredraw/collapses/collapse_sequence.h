#pragma once
// A mesh made coarser one edge at a time: what every simplifier answers with. Levels of any size, geomorphs and streams
// are cut out of it. Hoppe: Progressive Meshes, SIGGRAPH 1996, section 3; a record here is a collapse, and a vertex
// split is the same record undone, the last one first.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace foredraw {

/// One of two points goes, and with it the triangles that have both.
struct Collapse {
  std::uint32_t removed = 0;  ///< point
  std::uint32_t kept = 0;     ///< point
  float blend = 0;            ///< 0: attributes of the kept point stay; 1: they become those of the removed one
  float error = 0;            ///< an estimate of the distance from the original so far, in units; never falls
  friend bool operator==(const Collapse&, const Collapse&) = default;
};

/// A vertex of the removed point, and the one of the kept point that triangles have in its place.
struct VertexPair {
  std::uint32_t removed = 0;
  std::uint32_t kept = 0;
  friend bool operator==(const VertexPair&, const VertexPair&) = default;
};

/// Vertices are those of the mesh that was simplified. Vertices at one position are one point, which is known by the
/// first of them; so seams are points of several vertices, and stay closed as a point moves.
struct CollapseSequence {
  std::vector<Collapse> collapses;
  std::vector<VertexPair> pairs;
  std::vector<std::uint32_t> first_pair;  ///< [collapse], and the number of pairs behind the last
  std::vector<float> places;              ///< [3 * collapse]: where the kept point lies then; none: where it was
  /// What a vertex carries that comes to lie at neither of both places is solved for from the triangles around
  /// (WedgeShares); false: it is blended, too.
  bool solves = false;
  friend bool operator==(const CollapseSequence&, const CollapseSequence&) = default;
};

}  // namespace foredraw
